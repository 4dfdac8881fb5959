/// The linear system of the first Newton iteration of a backward-Euler step from the state of a checkpoint, solved by a
/// preset or by any options of PETSc, on any number of ranks.
///
///     linear_solvers DIRECTORY [-dt 1e-2] [-scene NAME] [-label TEXT] [-repeat 3] [-header]
///                              [-solver multigrid] [options]
///
/// Prints one line of CSV (`-header`: the names of its columns before it). The system is solved from a zero guess to
/// the tolerance of the preset, and to 1e-5. Seconds, CPU seconds of the busiest rank, are the least of `repeat`
/// trials: of the first set-up, of one with new entries in the same matrix, of the solution. Set-ups include one
/// application of the preconditioner, since parts of it are set up only then. Messages, bytes and reductions are those
/// that PETSc counts: hypre's are not among them.
#include <petsclog.h>
#include <petscts.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "../support/sample_problem.hpp"
#include "scree/app/petsc_session.hpp"
#include "scree/app/problem_setup.hpp"
#include "scree/config/command_line.hpp"
#include "scree/config/read_case.hpp"
#include "scree/output/checkpoint.hpp"
#include "scree/stepping/condensed_preconditioner.hpp"
#include "scree/stepping/corrections.hpp"
#include "scree/stepping/orderings.hpp"
#include "scree/stepping/petsc_versions.hpp"
#include "scree/stepping/presets.hpp"
#include "scree/stepping/staggered_multigrid.hpp"

namespace scree::test {
namespace {

constexpr double tight_tolerance = 1e-5;

// ---- options ----

/// Options of this program: they leave the command line, the rest is the case's and PETSc's.
struct Options {
  int repeat = 1;
  double dt = 1e-2;
  bool header = false;
  std::string scene, label;

  explicit Options(CommandLine& line) {
    CommandLine rest;
    for (const auto& [key, value] : line.options) {
      if (key == "repeat")
        repeat = std::stoi(value);
      else if (key == "dt")
        dt = std::stod(value);
      else if (key == "header")
        header = true;
      else if (key == "scene")
        scene = value;
      else if (key == "label")
        label = value;
      else
        rest.options.push_back({key, value});
    }
    line.options = rest.options;
  }
};

/// The state at which a run ended, and its time.
double read_state(const std::string& directory, const Box& box, DiscreteProblem& problem, Vec state) {
  const Checkpoint saved = read_checkpoint(directory, box, problem.dm(), problem.model().fields());
  check(VecCopy(saved.vector("state"), state));
  const double time = saved.scalar("time");
  check(problem.update_conditions(time));
  return time;
}

// ---- the system ----

/// Jacobian and right-hand side of the first Newton iteration of a step of dt from a state.
class System {
 public:
  System(DiscreteProblem& problem, Vec state, double time, double dt) : problem_(problem), time_(time), dt_(dt) {
    for (Vec* vector : {&guess_, &rate_, &right_side, &solution}) check(VecDuplicate(state, vector));
    check(VecCopy(state, guess_));
    check(raise_temperature(problem, dt, least_nu_of_guess, guess_));  // as the program does
    check(VecWAXPY(rate_, -1, state, guess_));
    check(VecScale(rate_, 1 / dt));
    check(problem.residual(time + dt, guess_, rate_, right_side));
    check(VecScale(right_side, -1));
    assemble();
  }
  ~System() {
    for (Vec* vector : {&guess_, &rate_, &right_side, &solution}) (void)VecDestroy(vector);
  }
  System(const System&) = delete;
  System& operator=(const System&) = delete;

  void assemble() { check(problem_.jacobian(time_ + dt_, guess_, rate_, 1 / dt_, matrix())); }
  Mat matrix() const { return problem_.matrix(); }
  double residual() const {
    Vec difference;
    double left, right;
    check(VecDuplicate(right_side, &difference));
    check(MatMult(matrix(), solution, difference));
    check(VecAXPY(difference, -1, right_side));
    check(VecNorm(difference, NORM_2, &left));
    check(VecNorm(right_side, NORM_2, &right));
    check(VecDestroy(&difference));
    return left / right;
  }

 private:
  DiscreteProblem& problem_;
  double time_, dt_;
  Vec guess_ = nullptr, rate_ = nullptr;

 public:
  Vec right_side = nullptr, solution = nullptr;
};

// ---- the solution ----

/// What this rank has sent and reduced so far.
struct Traffic {
  double messages = petsc_isend_ct + petsc_send_ct, bytes = petsc_isend_len + petsc_send_len,
         reductions = petsc_allreduce_ct;
};

struct Solution {
  int iterations = 0;
  KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
  double residual = 0, seconds = 1e300, messages = 0, bytes = 0, reductions = 0;  ///< the last three an iteration
};

/// CPU seconds of this process: unlike those of the wall, they do not tell of what else the machine does.
double cpu_seconds() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * t.tv_usec; };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// CPU seconds that `work` takes on the busiest rank.
template <class Work>
double seconds_of(Work&& work) {
  MPI_Barrier(PETSC_COMM_WORLD);
  const double start = cpu_seconds();
  work();
  double seconds = cpu_seconds() - start;
  MPI_Allreduce(MPI_IN_PLACE, &seconds, 1, MPI_DOUBLE, MPI_MAX, PETSC_COMM_WORLD);
  return seconds;
}

class Solver {
 public:
  Solver(System& system, DM dm) : system_(system) {
    check(KSPCreate(PETSC_COMM_WORLD, &ksp_));
    check(KSPSetDM(ksp_, dm));  // as SNES does it
    check(take_no_operators_from_dm(ksp_));
    check(KSPSetFromOptions(ksp_));
    check(KSPSetOperators(ksp_, system.matrix(), system.matrix()));
  }
  ~Solver() { (void)KSPDestroy(&ksp_); }
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;

  double set_up() {
    return seconds_of([&] {
      PC pc;
      check(KSPSetUp(ksp_));
      check(KSPSetUpOnBlocks(ksp_));
      check(KSPGetPC(ksp_, &pc));
      check(PCApply(pc, system_.right_side, system_.solution));
    });
  }
  double set_up_again() {
    system_.assemble();
    check(KSPSetOperators(ksp_, system_.matrix(), system_.matrix()));
    return set_up();
  }
  /// To `tolerance`; 0: that of the preset.
  Solution solve(double tolerance, int repeat) {
    const double other = petsc_unchanged;
    if (tolerance > 0) check(KSPSetTolerances(ksp_, tolerance, other, other, petsc_unchanged));
    Solution result;
    for (int k = 0; k < repeat; ++k) {
      check(VecZeroEntries(system_.solution));
      const Traffic before;
      const double seconds = seconds_of([&] { check(KSPSolve(ksp_, system_.right_side, system_.solution)); });
      const Traffic after;
      result.seconds = std::min(result.seconds, seconds);
      result.messages = after.messages - before.messages;
      result.bytes = after.bytes - before.bytes;
      result.reductions = after.reductions - before.reductions;
    }
    check(KSPGetIterationNumber(ksp_, &result.iterations));
    check(KSPGetConvergedReason(ksp_, &result.reason));
    result.residual = system_.residual();
    for (double* count : {&result.messages, &result.bytes, &result.reductions}) {
      MPI_Allreduce(MPI_IN_PLACE, count, 1, MPI_DOUBLE, MPI_MAX, PETSC_COMM_WORLD);
      *count /= std::max(1, result.iterations);
    }
    return result;
  }

 private:
  System& system_;
  KSP ksp_ = nullptr;
};

/// Greatest resident set so far, summed over the ranks [MB].
double peak_memory() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  double peak = 1024e-6 * static_cast<double>(usage.ru_maxrss);
  MPI_Allreduce(MPI_IN_PLACE, &peak, 1, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
  return peak;
}

void print_header() {
  PetscPrintf(
      PETSC_COMM_WORLD,
      "scene,grid,cells,dt,ranks,preset,label,iterations,reason,residual,setup_s,setup_again_s,solve_s,"
      "iterations_tight,reason_tight,residual_tight,solve_tight_s,messages,bytes,reductions,start_MB,peak_MB\n");
}

/// Messages and the like are those of the tight solution, a rank and an iteration.
void run(const std::string& directory, const Options& options, const CaseInput& input) {
  const double empty = peak_memory();
  const Case scene = read_case(input);
  DiscreteProblem problem(problem_setup(scene));
  check(problem.create(PETSC_COMM_WORLD, 0));
  Vec state;
  check(DMCreateGlobalVector(problem.dm(), &state));
  const double time = read_state(directory, scene.box, problem, state);
  System system(problem, state, time, options.dt);
  const char* preset = name_of(scene.solver.preset);
  check(register_orderings());
  check(register_condensed_preconditioner());
  check(register_staggered_multigrid());
  ScopedOptions of_preset;
  int ranks, cells = 1;
  MPI_Comm_size(PETSC_COMM_WORLD, &ranks);
  for (int axis = 0; axis < scene.box.dim; ++axis) cells *= scene.box.cells(axis);
  check(of_preset.set("", preset_options(scene.solver.preset, problem.model().fields(),
                                         {ranks, 0, problem.setup().model.gravity, static_cast<double>(cells)})));

  Solver solver(system, problem.dm());
  const double first = solver.set_up();
  double again = 1e300;
  for (int k = 0; k < options.repeat; ++k) again = std::min(again, solver.set_up_again());
  const Solution loose = solver.solve(0, options.repeat), tight = solver.solve(tight_tolerance, 1);

  std::string grid;
  for (int axis = 0; axis < scene.box.dim; ++axis)
    grid += (axis > 0 ? "x" : "") + std::to_string(scene.box.cells(axis));
  const double memory = peak_memory();
  if (options.header) print_header();
  PetscPrintf(PETSC_COMM_WORLD,
              "%s,%s,%d,%g,%d,%s,%s,%d,%d,%.2e,%.4g,%.4g,%.4g,%d,%d,%.2e,%.4g,%.4g,%.4g,%.4g,%.4g,%.4g\n",
              options.scene.c_str(), grid.c_str(), cells, options.dt, ranks, preset, options.label.c_str(),
              loose.iterations, static_cast<int>(loose.reason), loose.residual, first, again, loose.seconds,
              tight.iterations, static_cast<int>(tight.reason), tight.residual, tight.seconds, tight.messages,
              tight.bytes, tight.reductions, empty, memory);
  check(VecDestroy(&state));
}

}  // namespace
}  // namespace scree::test

int main(int argc, char** argv) {
  if (argc < 2) return 1;
  MPI_Init(&argc, &argv);
  try {
    const std::string directory = argv[1];
    scree::CommandLine line = scree::read_command_line({argv + 2, argv + argc});
    const scree::test::Options options(line);
    line.case_file = directory + "/case.yaml";
    const scree::CaseInput input = scree::case_input(line);
    const scree::PetscSession petsc(argv[0], scree::read_case(input).petsc_options);
    scree::test::check(PetscLogDefaultBegin());
    scree::test::run(directory, options, input);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "linear_solvers: %s\n", error.what());
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
  return MPI_Finalize();
}
