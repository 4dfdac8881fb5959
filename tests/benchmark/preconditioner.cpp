#include <benchmark/benchmark.h>

#include "benchmarks.hpp"
#include "scenes.hpp"
#include "scree/app/initial_state.hpp"
#include "scree/app/problem_setup.hpp"
#include "scree/stepping/consistent_gas.hpp"
#include "scree/stepping/presets.hpp"

namespace scree::benchmarks {
namespace {

/// A flow on its own way from the initial state, with the solver of the program.
class DevelopedFlow {
 public:
  DevelopedFlow(const Scene& scene, int refine, double until)
      : case_(read_scene(scene, refine)), problem_(problem_setup(case_)) {
    check(problem_.create(PETSC_COMM_SELF, 0));
    const Model& model = problem_.model();
    const bool gas = model.component<GasContinuity>() >= 0;
    const PetscOptionList solver =
        preset_options(gas ? SolverPreset::fieldsplit : SolverPreset::multigrid, model.fields());
    StepControl control;
    control.step.initial = case_.time.step_initial;
    stepper_ = std::make_unique<TimeStepper>(problem_, control);
    check(stepper_->create(0, solver));
    (void)set_initial_state(case_, problem_, stepper_->state());
    bool done;
    check(make_gas_consistent(problem_, control, solver, 0, stepper_->state(), &done));
    for (StepReport report; stepper_->time() < until * (1 - 1e-12) && !report.failed;)
      check(stepper_->step(until, &report));
    prepare();
  }
  ~DevelopedFlow() {
    for (Vec* vector : {&rate_, &right_, &solution_}) (void)VecDestroy(vector);
  }
  DevelopedFlow(const DevelopedFlow&) = delete;
  DevelopedFlow& operator=(const DevelopedFlow&) = delete;

  /// Set-up and one application: smoothers of multigrid factorise when they are first asked for.
  void set_up() {
    // The matrix as after a new Jacobian: otherwise the set-up that is there would do.
    check(MatAssemblyBegin(problem_.matrix(), MAT_FINAL_ASSEMBLY));
    check(MatAssemblyEnd(problem_.matrix(), MAT_FINAL_ASSEMBLY));
    check(KSPSetOperators(ksp_, problem_.matrix(), problem_.matrix()));
    check(KSPSetUp(ksp_));
    PC pc;
    check(KSPGetPC(ksp_, &pc));
    check(PCApply(pc, right_, solution_));
  }
  void solve() { check(KSPSolve(ksp_, right_, solution_)); }
  int iterations() const {
    PetscInt count;
    check(KSPGetIterationNumber(ksp_, &count));
    return static_cast<int>(count);
  }
  int cells() const { return problem_.box().cells(0) * problem_.box().cells(1); }

 private:
  /// Residual and Jacobian of the first Newton iteration of a step as long as those of the plateau.
  void prepare() {
    constexpr double dt = 0.01;
    check(VecDuplicate(stepper_->state(), &rate_));
    check(VecDuplicate(rate_, &right_));
    check(VecDuplicate(rate_, &solution_));
    check(problem_.residual(stepper_->time(), stepper_->state(), rate_, right_));
    check(problem_.jacobian(stepper_->time(), stepper_->state(), rate_, 1 / dt, problem_.matrix()));
    check(SNESGetKSP(stepper_->newton(), &ksp_));
    check(KSPSetReusePreconditioner(ksp_, PETSC_FALSE));
  }

  Case case_;
  DiscreteProblem problem_;
  std::unique_ptr<TimeStepper> stepper_;
  Vec rate_ = nullptr, right_ = nullptr, solution_ = nullptr;
  KSP ksp_ = nullptr;  // of the stepper
};

void report(benchmark::State& state, const DevelopedFlow& flow) {
  using benchmark::Counter;
  state.counters["time_per_cell"] = Counter(flow.cells(), Counter::kIsIterationInvariantRate | Counter::kInvert);
  state.counters["cells"] = flow.cells();
}

}  // namespace

void add_preconditioners(const std::string& cases) {
  for (const Scene& scene : scenes(cases)) {
    if (scene.name != "bin" && scene.name != "bubble") continue;
    const double until = scene.name == "bin" ? 0.1 : 0.02;  // [s]
    const auto flow = [=, kept = std::make_shared<std::unique_ptr<DevelopedFlow>>()]() -> DevelopedFlow& {
      if (!*kept) *kept = std::make_unique<DevelopedFlow>(scene, 1, until);
      return **kept;
    };
    benchmark::RegisterBenchmark(("preconditioner_setup/" + scene.name + "/1").c_str(), [=](benchmark::State& state) {
      DevelopedFlow& f = flow();
      for (auto _ : state) f.set_up();
      report(state, f);
    })->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark(("krylov/" + scene.name + "/1").c_str(), [=](benchmark::State& state) {
      DevelopedFlow& f = flow();
      f.set_up();
      for (auto _ : state) f.solve();
      report(state, f);
      state.counters["krylov"] = f.iterations();
    })->Unit(benchmark::kMillisecond);
  }
}

}  // namespace scree::benchmarks
