#include "scree/stepping/consistent_gas.hpp"

#include "scree/balances/layout.hpp"

namespace scree {

namespace {

/// Length of the step that gives p_g, as a share of the first of the run: u hardly moves in it.
constexpr double share_of_step = 1e-3;

PetscErrorCode copy_pressure(const Model& model, Vec from, Vec to) {
  PetscFunctionBeginUser;
  const int unknowns = model.unknowns();
  const double* source;
  double* target;
  PetscInt size;
  PetscCall(VecGetLocalSize(to, &size));
  PetscCall(VecGetArrayRead(from, &source));
  PetscCall(VecGetArray(to, &target));
  for (PetscInt k = model.component<GasContinuity>(); k < size; k += unknowns) target[k] = source[k];
  PetscCall(VecRestoreArray(to, &target));
  PetscCall(VecRestoreArrayRead(from, &source));
  PetscFunctionReturn(0);
}

}  // namespace

PetscErrorCode make_gas_consistent(const DiscreteProblem& problem, const StepControl& control,
                                   const PetscOptionList& solver, double time, Vec state, bool* done) {
  PetscFunctionBeginUser;
  *done = true;
  if (problem.model().component<GasContinuity>() < 0) PetscFunctionReturn(0);
  PetscCall(impose_gas(problem, time, state));
  PetscCall(project_gas(problem, time, state));
  ProblemSetup setup = problem.setup();
  setup.model.solids_moving = false;
  setup.model.gas_alone = true;
  StepControl steps = control;
  steps.scheme = TimeScheme::beuler;
  steps.step.adaptive = steps.extrapolate = false;
  steps.step.initial *= share_of_step;
  steps.step.least = 0;

  DiscreteProblem frozen(setup);
  PetscCall(frozen.create(PetscObjectComm(reinterpret_cast<PetscObject>(problem.dm())), time));
  TimeStepper stepper(frozen, steps, "gas_start_");
  PetscCall(stepper.create(time, solver));
  PetscCall(VecCopy(state, stepper.state()));
  StepReport report;
  PetscCall(stepper.step(PETSC_MAX_REAL, &report));
  *done = !report.failed;
  if (*done) PetscCall(copy_pressure(problem.model(), stepper.state(), state));
  PetscFunctionReturn(0);
}

}  // namespace scree
