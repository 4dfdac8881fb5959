#include "scree/app/phase_clock.hpp"

#include <petsclog.h>
#include <petscts.h>
#include <sys/resource.h>

#include "scree/output/errors.hpp"

namespace scree {

namespace {

double cpu_seconds() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) { return t.tv_sec + 1e-6 * t.tv_usec; };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

}  // namespace

PhaseClock::PhaseClock(MPI_Comm comm) : comm_(comm), started_(MPI_Wtime()) {
  check_petsc(TSInitializePackage(), "logging");  // registers the events of SNES, KSP and PC too
  check_petsc(SNESInitializePackage(), "logging");
  check_petsc(KSPInitializePackage(), "logging");
  check_petsc(PCInitializePackage(), "logging");
  check_petsc(PetscLogDefaultBegin(), "logging");
  const char* names[] = {"SNESFunctionEval", "SNESJacobianEval", "PCSetUp", "SNESSolve"};
  for (std::size_t k = 0; k < events_.size(); ++k) check_petsc(PetscLogEventGetId(names[k], &events_[k]), "logging");
  start_ = now();
}

std::array<double, 5> PhaseClock::now() const {
  std::array<double, 4> seconds{};
  for (std::size_t k = 0; k < events_.size(); ++k) {
    PetscEventPerfInfo info{};
    if (events_[k] >= 0) check_petsc(PetscLogEventGetPerfInfo(PETSC_DETERMINE, events_[k], &info), "logging");
    seconds[k] = info.time;
  }
  // SNESSolve contains the others; KSPSolve would contain the set-ups of smoothers, but not that of the whole.
  return {cpu_seconds(), seconds[0], seconds[1], seconds[2], seconds[3] - seconds[0] - seconds[1] - seconds[2]};
}

PhaseSeconds PhaseClock::read() const {
  auto seconds = now();
  for (std::size_t k = 1; k < seconds.size(); ++k) seconds[k] -= start_[k];
  MPI_Allreduce(MPI_IN_PLACE, seconds.data(), static_cast<int>(seconds.size()), MPI_DOUBLE, MPI_SUM, comm_);
  return {seconds[0], seconds[1], seconds[2], seconds[3], seconds[4]};
}

double PhaseClock::wall() const { return MPI_Wtime() - started_; }

double PhaseClock::peak_memory_per_rank() const {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  double peak = 1024.0 * static_cast<double>(usage.ru_maxrss);
  MPI_Allreduce(MPI_IN_PLACE, &peak, 1, MPI_DOUBLE, MPI_MAX, comm_);
  return peak;
}

}  // namespace scree
