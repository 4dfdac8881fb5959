#include "scree/stepping/time_stepper.hpp"

#include <cmath>

#include "scree/stepping/local_error.hpp"
#include "scree/stepping/petsc_versions.hpp"

namespace scree {

TimeStepper::TimeStepper(const DiscreteProblem& problem, const StepControl& control, std::string prefix)
    : problem_(problem),
      control_(control),
      prefix_(std::move(prefix)),
      scheme_(control.scheme),
      controller_(control.step, scheme_.order()),
      stages_(problem, control_, history_) {
  history_.dt_next = control_.step.initial;
}

TimeStepper::~TimeStepper() {
  PetscCallAbort(PETSC_COMM_SELF, TSDestroy(&ts_));
  for (Vec* vector : {&state_, &start_, &difference_, &past_[0], &past_[1]})
    PetscCallAbort(PETSC_COMM_SELF, VecDestroy(vector));
}

PetscErrorCode TimeStepper::create(double time, const PetscOptionList& solver) {
  PetscFunctionBeginUser;
  time_ = time;
  PetscCall(DMCreateGlobalVector(problem_.dm(), &state_));
  for (Vec* vector : {&start_, &difference_, &past_[0], &past_[1]}) PetscCall(VecDuplicate(state_, vector));
  PetscCall(options_.set(prefix_, solver));
  PetscCall(make_ts());
  PetscFunctionReturn(0);
}

PetscErrorCode TimeStepper::make_ts() {
  PetscFunctionBeginUser;
  PetscCall(TSDestroy(&ts_));
  PetscCall(TSCreate(PetscObjectComm(reinterpret_cast<PetscObject>(state_)), &ts_));
  PetscCall(TSSetOptionsPrefix(ts_, prefix_.c_str()));
  PetscCall(stages_.create(ts_, prefix_));
  PetscCall(set_scheme());
  TSAdapt adapt;
  PetscCall(TSGetAdapt(ts_, &adapt));
  PetscCall(TSAdaptSetType(adapt, TSADAPTNONE));
  PetscCall(TSAdaptSetScaleSolveFailed(adapt, StepController::reduction));
  PetscCall(TSAdaptSetStepLimits(adapt, control_.step.least, PETSC_MAX_REAL));
  PetscCall(TSSetMaxSNESFailures(ts_, petsc_unlimited));
  PetscCall(TSSetMaxStepRejections(ts_, 100));
  PetscCall(TSSetErrorIfStepFails(ts_, PETSC_FALSE));
  PetscCall(TSSetExactFinalTime(ts_, TS_EXACTFINALTIME_STEPOVER));
  PetscCall(TSSetMaxTime(ts_, PETSC_MAX_REAL));
  PetscCall(TSSetMaxSteps(ts_, PETSC_MAX_INT - 1));
  PetscCall(TSSetTime(ts_, time_));
  PetscCall(TSSetSolution(ts_, state_));
  PetscCall(TSSetFromOptions(ts_));
  PetscFunctionReturn(0);
}

PetscErrorCode TimeStepper::set_scheme() {
  PetscFunctionBeginUser;
  switch (control_.scheme) {
    case TimeScheme::beuler:
      PetscCall(TSSetType(ts_, TSBEULER));
      break;
    case TimeScheme::bdf:
      PetscCall(TSSetType(ts_, TSBDF));
      PetscCall(TSBDFSetOrder(ts_, 2));
      break;
    case TimeScheme::arkimex:
      PetscCall(TSSetType(ts_, TSARKIMEX));
      PetscCall(TSARKIMEXSetType(ts_, TSARKIMEX2E));
      PetscCall(TSARKIMEXSetFullyImplicit(ts_, PETSC_TRUE));
      PetscCall(TSSetEquationType(ts_, TS_EQ_IMPLICIT));
      finds_slope_ = true;
      break;
  }
  PetscFunctionReturn(0);
}

PetscErrorCode TimeStepper::set_time(double time) {
  PetscFunctionBeginUser;
  time_ = time;
  PetscCall(TSSetTime(ts_, time));
  PetscFunctionReturn(0);
}

PetscErrorCode TimeStepper::change_preconditioner(const PetscOptionList& solver) {
  PetscFunctionBeginUser;
  PetscCall(options_.set(prefix_, solver));
  PetscCall(stages_.make_preconditioner_anew());
  PetscFunctionReturn(0);
}

void TimeStepper::on_linear_failure(std::function<std::optional<PetscOptionList>()> stronger) {
  stages_.on_linear_failure([this, stronger = std::move(stronger)](bool* changed) -> PetscErrorCode {
    PetscFunctionBeginUser;
    const std::optional<PetscOptionList> solver = stronger();
    *changed = solver.has_value();
    if (solver) PetscCall(change_preconditioner(*solver));
    PetscFunctionReturn(0);
  });
}

PetscErrorCode TimeStepper::restart_after_event() {
  PetscFunctionBeginUser;
  history_.forget_past(control_.step.initial);
  PetscCall(make_ts());
  PetscFunctionReturn(0);
}

PetscErrorCode TimeStepper::forget_preconditioner() {
  PetscFunctionBeginUser;
  // KSPReset leaves traces in multigrid: the next steps would differ in the last bits.
  if (scheme_.has_one_step())
    PetscCall(make_ts());
  else  // TS holds past states
    PetscCall(stages_.forget_preconditioner());
  PetscFunctionReturn(0);
}

PetscErrorCode TimeStepper::step(double limit, StepReport* report) {
  PetscFunctionBeginUser;
  *report = StepReport();
  stages_.begin_step();
  PetscCall(VecCopy(state_, start_));
  const StepController::Plan plan = controller_.plan(history_.dt_next, limit - time_);
  double dt = plan.dt;
  for (bool done = false; !done;) {
    PetscCall(attempt(dt, report, &done));
    if (!done) dt = controller_.after_rejection(report->dt, report->error);
  }
  report->newton = stages_.count().newton;
  report->krylov = stages_.count().krylov;
  report->setups = stages_.count().setups;
  report->limited = stages_.limited();
  if (report->failed) PetscFunctionReturn(0);
  report->imbalance = {stages_.imbalance().solids * report->dt, stages_.imbalance().gas * report->dt};

  time_ = report->time;
  std::swap(past_[0], past_[1]);
  PetscCall(VecCopy(start_, past_[0]));
  history_.dt_past = {report->dt, history_.dt_past[0]};
  const int newton = (report->newton + scheme_.stages() - 1) / scheme_.stages();
  const StepOutcome outcome{report->error, history_.error, newton, report->rejected_solver > 0,
                            report->rejected_error > 0};
  history_.error = report->error;
  history_.guess.step_done(outcome.newton, outcome.failed || outcome.error_too_large, outcome.easy());
  history_.newton.step_done(outcome.failed);
  history_.dt_next = controller_.next(report->dt, outcome, plan);
  PetscFunctionReturn(0);
}

PetscErrorCode TimeStepper::attempt(double dt, StepReport* report, bool* done) {
  PetscFunctionBeginUser;
  const double least = controller_.least(dt);
  int failures;
  bool worked;
  PetscCall(stages_.begin_attempt(start_, past_[0]));
  if (problem_.setup().solids.friction.lagged) PetscCall(lag_friction(problem_, dt, state_));
  PetscCall(take_step(dt, least, &failures, &worked));
  report->rejected_solver += failures;
  if (failures > 0) report->reason = stages_.count().failure;
  *done = true;
  if (!worked) {
    PetscCall(give_up(report, report->reason));
    PetscFunctionReturn(0);
  }
  PetscCall(TSGetTime(ts_, &report->time));
  report->dt = report->time - time_;
  PetscCall(local_error(report->dt, &report->error));
  if (report->dt < 0.4 * least) {  // TS may cut further, down to steps that time does not feel
    PetscCall(give_up(report, report->reason));
  } else if (!std::isfinite(report->error)) {
    PetscCall(give_up(report, "the state is not finite"));
  } else if (!controller_.accepts(report->dt, report->error)) {
    *done = false;
    ++report->rejected_error;
    PetscCall(TSRollBack(ts_));
    PetscCall(TSRestartStep(ts_));  // what TS keeps of the rejected step is not to be used
    finds_slope_ = control_.scheme == TimeScheme::arkimex;
    PetscCall(VecCopy(start_, state_));
  }
  PetscFunctionReturn(0);
}

/// One step by TS, which cuts it where the solver fails, down to `least`: then it did not work.
PetscErrorCode TimeStepper::take_step(double dt, double least, int* failures, bool* worked) {
  PetscFunctionBeginUser;
  PetscInt before, after;
  TSAdapt adapt;
  TSConvergedReason reason;
  PetscCall(TSGetAdapt(ts_, &adapt));
  PetscCall(TSAdaptSetStepLimits(adapt, least, PETSC_MAX_REAL));
  PetscCall(TSGetSNESFailures(ts_, &before));
  PetscCall(TSSetTimeStep(ts_, finds_slope_ ? dt / 2 : dt));
  PetscCall(TSStep(ts_));
  finds_slope_ = false;
  PetscCall(TSGetSNESFailures(ts_, &after));
  PetscCall(TSGetConvergedReason(ts_, &reason));
  *failures = static_cast<int>(after - before);
  *worked = reason >= 0;
  PetscFunctionReturn(0);
}

PetscErrorCode TimeStepper::give_up(StepReport* report, const std::string& reason) {
  PetscFunctionBeginUser;
  report->failed = true;
  report->reason = reason;
  PetscCall(VecCopy(start_, state_));
  PetscFunctionReturn(0);
}

/// Over what it may be; 0 where there are too few past states.
PetscErrorCode TimeStepper::local_error(double dt, double* error) {
  PetscFunctionBeginUser;
  *error = 0;
  if (!scheme_.can_extrapolate(history_.dt_past)) PetscFunctionReturn(0);
  const StateWeights weights = scheme_.extrapolation(dt, history_.dt_past);
  PetscCall(VecAXPBYPCZ(difference_, weights[0], weights[1], 0, start_, past_[0]));
  if (weights[2] != 0) PetscCall(VecAXPY(difference_, weights[2], past_[1]));
  PetscCall(VecAXPY(difference_, -1, state_));
  PetscCall(norm_of_error(problem_, state_, difference_, error));
  *error *= scheme_.error_share(dt, history_.dt_past) / control_.local_tolerance();
  PetscFunctionReturn(0);
}

}  // namespace scree
