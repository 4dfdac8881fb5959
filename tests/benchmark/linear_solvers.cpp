/// The linear system of the first Newton iteration of a backward-Euler step from the state of a checkpoint, on the grid
/// of the run or a finer one, solved by a preset or by any options of PETSc, on any number of ranks.
///
///     linear_solvers DIRECTORY [-refine 2] [-dt 1e-2] [-scene NAME] [-label TEXT] [-repeat 3] [-header]
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
#include <cmath>
#include <cstdio>
#include <vector>

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
  int refine = 1, repeat = 1;
  double dt = 1e-2;
  bool header = false;
  std::string scene, label;

  explicit Options(CommandLine& line) {
    CommandLine rest;
    for (const auto& [key, value] : line.options) {
      if (key == "refine")
        refine = std::stoi(value);
      else if (key == "repeat")
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

/// The case on a grid with `times` as many cells along each axis.
Case refined_case(CaseInput input, int times) {
  const std::string* own = input.find("grid_refine");
  input.set("grid_refine", std::to_string((own ? std::stoi(*own) : 1) * times));
  return read_case(input);
}

// ---- the state on the finer grid ----

/// Two neighbours along an axis and the share of the upper one.
struct Between {
  int lower = 0;
  double share = 0;
};

/// Where `position` lies among the places of a field along an axis: faces, or centres of cells, beyond the last of
/// which it is constant.
Between between(const Axis& axis, bool on_faces, double position) {
  const int last = axis.cells() - (on_faces && !axis.periodic() ? 0 : 1);
  const auto place = [&](int i) { return on_faces ? axis.face(i) : axis.centre(i); };
  int i = 0;
  while (i < last - 1 && place(i + 1) <= position) ++i;
  if (last == 0) return {};
  return {i, std::clamp((position - place(i)) / (place(i + 1) - place(i)), 0., 1.)};
}

/// Linear interpolation along each axis of the state of a run, which every rank holds whole.
class CoarseState {
 public:
  CoarseState(const std::string& directory, const Box& box, const DiscreteProblem& fine) {
    const auto [unknowns, width] = fine.setup().models.extent(box.dim, fine.setup().model, fine.setup().solids);
    check(create_dm(PETSC_COMM_SELF, box, unknowns, width, &dm_));
    const Checkpoint saved = read_checkpoint(directory, box, dm_, fine.model().fields());
    time = saved.scalar("time");
    lattice_ = std::make_unique<Lattice>(box, dm_);
    const double* x;
    check(VecGetArrayRead(saved.vector("state"), &x));
    values_.assign(x, x + lattice_->owned_size() * unknowns);
    check(VecRestoreArrayRead(saved.vector("state"), &x));
    unknowns_ = unknowns;
  }
  ~CoarseState() { (void)DMDestroy(&dm_); }
  CoarseState(const CoarseState&) = delete;
  CoarseState& operator=(const CoarseState&) = delete;

  double at(const Field& field, const std::array<double, max_dim>& x) const {
    std::array<Between, max_dim> places;
    for (int a = 0; a < lattice_->dim; ++a) places[a] = between(lattice_->axes[a], a == field.face_axis, x[a]);
    double sum = 0;
    for (int corner = 0; corner < 1 << lattice_->dim; ++corner) {
      double weight = 1;
      Index I;
      for (int a = 0; a < lattice_->dim; ++a) {
        const bool upper = corner >> a & 1;
        I[a] = places[a].lower + upper;
        weight *= upper ? places[a].share : 1 - places[a].share;
      }
      if (weight > 0)
        sum += weight * values_[static_cast<std::size_t>(lattice_->owned(I) * unknowns_ + field.component)];
    }
    return sum;
  }

  double time = 0;

 private:
  DM dm_ = nullptr;
  std::unique_ptr<Lattice> lattice_;
  Values values_;
  int unknowns_ = 0;
};

/// Puts the interpolated state where the finer grid has unknowns; walls keep their velocity, gas its volume.
void interpolate(const CoarseState& coarse, const DiscreteProblem& fine, Vec state) {
  const Lattice& grid = fine.lattice();
  double* x;
  check(VecZeroEntries(state));
  check(VecGetArray(state, &x));
  for (const Field& field : fine.model().fields())
    for_each_node(grid.owned_first, grid.owned_count, [&](const Index& I) {
      if (field.face_axis < 0 ? !grid.inside(I) : !grid.is_face(field.face_axis, I)) return;
      std::array<double, max_dim> at{};
      for (int a = 0; a < grid.dim; ++a)
        at[a] = a == field.face_axis ? grid.axes[a].face(I[a]) : grid.axes[a].centre(I[a]);
      double& value = x[grid.owned(I) * fine.model().unknowns() + field.component];
      value = coarse.at(field, at);
      if (field.symbol == "v" && fine.barriers().wall(field.face_axis, I))
        value = fine.barriers().condition(field.face_axis, I).velocity[field.face_axis] / field.scale;
    });
  check(VecRestoreArray(state, &x));
  check(impose_gas(fine, coarse.time, state));
  check(project_gas(fine, coarse.time, state));
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
  const Box coarse_box = read_case(input).box;
  const Case scene = refined_case(input, options.refine);
  DiscreteProblem problem(problem_setup(scene));
  check(problem.create(PETSC_COMM_WORLD, 0));
  Vec state;
  check(DMCreateGlobalVector(problem.dm(), &state));
  double time;
  {
    const CoarseState coarse(directory, coarse_box, problem);
    time = coarse.time;
    check(problem.update_conditions(time));
    interpolate(coarse, problem, state);
  }
  System system(problem, state, time, options.dt);
  const char* preset = name_of(scene.solver.preset);
  check(register_orderings());
  check(register_condensed_preconditioner());
  check(register_staggered_multigrid());
  ScopedOptions of_preset;
  int ranks, cells = 1;
  MPI_Comm_size(PETSC_COMM_WORLD, &ranks);
  check(of_preset.set("", preset_options(scene.solver.preset, problem.model().fields(), ranks)));

  Solver solver(system, problem.dm());
  const double first = solver.set_up();
  double again = 1e300;
  for (int k = 0; k < options.repeat; ++k) again = std::min(again, solver.set_up_again());
  const Solution loose = solver.solve(0, options.repeat), tight = solver.solve(tight_tolerance, 1);

  std::string grid;
  for (int axis = 0; axis < scene.box.dim; ++axis) {
    cells *= scene.box.cells(axis);
    grid += (axis > 0 ? "x" : "") + std::to_string(scene.box.cells(axis));
  }
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
