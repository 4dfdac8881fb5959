#include "scree/app/phase_clock.hpp"

#include <petsclog.h>
#include <petscts.h>
#include <sys/resource.h>

#include <algorithm>

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

PhaseClock::Reading PhaseClock::now() const {
  std::array<double, 4> seconds{};
  for (std::size_t k = 0; k < events_.size(); ++k) {
    PetscEventPerfInfo info{};
    if (events_[k] >= 0) check_petsc(PetscLogEventGetPerfInfo(PETSC_DETERMINE, events_[k], &info), "logging");
    seconds[k] = info.time;
  }
  // SNESSolve contains the others; KSPSolve would contain the set-ups of smoothers, but not that of the whole.
  return {MPI_Wtime(),
          cpu_seconds(),
          {seconds[0], seconds[1], seconds[2], seconds[3] - seconds[0] - seconds[1] - seconds[2]}};
}

PhaseSeconds PhaseClock::read() const {
  const Reading reading = now();
  const double wall = reading.wall - start_.wall, cpu = reading.cpu - start_.cpu;
  const double ran = wall > 0 ? std::min(cpu / wall, 1.0) : 1;
  std::array<double, 5> seconds{reading.cpu};
  for (std::size_t k = 0; k < reading.phases.size(); ++k) seconds[k + 1] = ran * (reading.phases[k] - start_.phases[k]);
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
