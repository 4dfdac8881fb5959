#include "scree/stepping/time_stepper.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "scree/stepping/line_search.hpp"

namespace scree {

namespace {

/// Newton iterations up to which a step counts as easy (it may grow), and from which on as hard (it shrinks).
constexpr int easy_newton = 4, hard_newton = 8;
/// Easy steps in a row before the first guess is extrapolated: elsewhere extrapolation causes most of the failures.
constexpr int easy_before_extrapolation = 3;
constexpr double growth = 1.3, solver_reduction = 0.25;
/// A preconditioner has aged at more Krylov iterations than this factor times those of the first system, and so many:
/// about what a set-up costs.
constexpr int aged_factor = 2, aged_more = 10;
/// Where an iteration has reduced the residual to this share, and it is within that factor of where Newton stops, the
/// Jacobian and its factors serve for one more iteration: they converge about as fast.
constexpr double kept_reduction = 0.1, kept_distance = 30;

/// Puts the preconditioner back to where it was before its first set-up; KSPReset alone drops the splits of a
/// fieldsplit, which come from options.
PetscErrorCode forget(SNES snes) {
  PetscFunctionBeginUser;
  KSP ksp;
  PC pc;
  PetscCall(SNESGetKSP(snes, &ksp));
  PetscCall(KSPGetPC(ksp, &pc));
  PetscCall(PCSetType(pc, PCNONE));
  PetscCall(KSPReset(ksp));
  PetscCall(KSPSetFromOptions(ksp));
  PetscFunctionReturn(0);
}

MPI_Comm comm_of(Vec vector) { return PetscObjectComm(reinterpret_cast<PetscObject>(vector)); }

}  // namespace

TimeStepper::TimeStepper(DiscreteProblem& problem, StepControl control)
    : problem_(problem), control_(std::move(control)), limits_(problem) {
  history_.dt_next = control_.step_initial;
}

TimeStepper::~TimeStepper() {
  PetscCallAbort(PETSC_COMM_SELF, TSDestroy(&ts_));
  for (Vec* vector : {&state_, &guess_, &predicted_, &past_[0], &past_[1]})
    PetscCallAbort(PETSC_COMM_SELF, VecDestroy(vector));
}

PetscErrorCode TimeStepper::create(double time) {
  PetscFunctionBeginUser;
  time_ = time;
  PetscCall(DMCreateGlobalVector(problem_.dm(), &state_));
  for (Vec* vector : {&guess_, &predicted_, &past_[0], &past_[1]}) PetscCall(VecDuplicate(state_, vector));
  PetscCall(make_ts());
  PetscFunctionReturn(0);
}

PetscErrorCode TimeStepper::make_ts() {
  PetscFunctionBeginUser;
  PetscCall(TSDestroy(&ts_));
  PetscCall(TSCreate(comm_of(state_), &ts_));
  PetscCall(problem_.attach(ts_));
  if (control_.scheme == "bdf") {
    PetscCall(TSSetType(ts_, TSBDF));
    PetscCall(TSBDFSetOrder(ts_, 2));
  } else if (control_.scheme == "arkimex") {
    PetscCall(TSSetType(ts_, TSARKIMEX));
    PetscCall(TSARKIMEXSetType(ts_, TSARKIMEX2E));
    PetscCall(TSARKIMEXSetFullyImplicit(ts_, PETSC_TRUE));
    PetscCall(TSSetEquationType(ts_, TS_EQ_IMPLICIT));
    PetscCall(TSSetPreStage(ts_, put_back_jacobian));
    finds_slope_ = true;
  } else {
    PetscCall(TSSetType(ts_, TSBEULER));
  }
  TSAdapt adapt;
  PetscCall(TSGetAdapt(ts_, &adapt));
  PetscCall(TSAdaptSetType(adapt, TSADAPTNONE));
  PetscCall(TSAdaptSetScaleSolveFailed(adapt, solver_reduction));
  PetscCall(TSAdaptSetStepLimits(adapt, control_.step_min, PETSC_MAX_REAL));
  PetscCall(TSSetMaxSNESFailures(ts_, -1));
  PetscCall(TSSetMaxStepRejections(ts_, 100));
  PetscCall(TSSetErrorIfStepFails(ts_, PETSC_FALSE));
  PetscCall(TSSetExactFinalTime(ts_, TS_EXACTFINALTIME_STEPOVER));
  PetscCall(TSSetMaxTime(ts_, PETSC_MAX_REAL));
  PetscCall(TSSetMaxSteps(ts_, PETSC_MAX_INT - 1));
  PetscCall(TSSetTime(ts_, time_));
  PetscCall(TSSetSolution(ts_, state_));

  SNES snes;
  PetscCall(TSGetSNES(ts_, &snes));
  // The absolute tolerance is set_newton_tolerance's. stol 0: a failed line search ends with tiny steps.
  PetscCall(SNESSetTolerances(snes, PETSC_DEFAULT, 1e-8, 0, 15, 10000));
  PetscCall(SNESSetForceIteration(snes, PETSC_TRUE));
  PetscCall(TSSetFromOptions(ts_));
  PetscCall(PetscOptionsHasName(nullptr, nullptr, "-snes_test_jacobian", &jacobian_tested_));
  PetscCall(SNESSetConvergenceTest(snes, converged, this, nullptr));
  PetscCall(SNESSetComputeInitialGuess(snes, first_guess, this));
  PetscCall(use_guarded_full_steps(snes));
  PetscCall(limits_.attach(snes));
  PetscFunctionReturn(0);
}

/// TSARKIMEX finds its first slope with a TS of its own, whose end takes the Jacobian and the splits of the
/// preconditioner out of the SNES that both share; SNES would go on with a matrix from the DM, which has other entries
/// than ours.
PetscErrorCode TimeStepper::put_back_jacobian(TS ts, PetscReal) {
  PetscFunctionBeginUser;
  SNES snes;
  Mat A, P;
  PetscCall(TSGetSNES(ts, &snes));
  PetscCall(SNESGetJacobian(snes, &A, &P, nullptr, nullptr));
  if (P) PetscFunctionReturn(0);
  void* problem;
  PetscCall(TSGetIJacobian(ts, nullptr, nullptr, nullptr, &problem));
  P = static_cast<DiscreteProblem*>(problem)->matrix();
  PetscCall(SNESSetJacobian(snes, P, P, nullptr, nullptr));
  PetscCall(forget(snes));
  PetscFunctionReturn(0);
}

PetscErrorCode TimeStepper::set_time(double time) {
  PetscFunctionBeginUser;
  time_ = time;
  PetscCall(TSSetTime(ts_, time));
  PetscFunctionReturn(0);
}

PetscErrorCode TimeStepper::make_preconditioner_anew() {
  PetscFunctionBeginUser;
  SNES snes;
  KSP ksp;
  PC pc;
  PetscInt lag;
  PetscBool lag_chosen;
  PetscCall(TSGetSNES(ts_, &snes));
  PetscCall(SNESGetKSP(snes, &ksp));
  PetscCall(KSPGetPC(ksp, &pc));
  PetscCall(PetscOptionsGetInt(nullptr, nullptr, "-snes_lag_preconditioner", &lag, &lag_chosen));
  if (lag_chosen) PetscCall(SNESSetLagPreconditioner(snes, lag));
  PetscCall(PCSetType(pc, PCNONE));  // a type that is set again keeps the solvers inside as they are
  PetscCall(KSPSetFromOptions(ksp));
  PetscCall(renew_preconditioner());
  PetscFunctionReturn(0);
}

PetscErrorCode TimeStepper::restart_after_event() {
  PetscFunctionBeginUser;
  history_.dt_past = {0, 0};
  history_.easy_steps = 0;
  history_.guess = FirstGuess::better;
  history_.dt_next = std::min(history_.dt_next, control_.step_initial);
  PetscCall(make_ts());
  PetscFunctionReturn(0);
}

PetscErrorCode TimeStepper::forget_preconditioner() {
  PetscFunctionBeginUser;
  if (control_.scheme ==
      "beuler") {  // KSPReset leaves traces in multigrid: the next steps would differ in the last bits
    PetscCall(make_ts());
    PetscFunctionReturn(0);
  }
  SNES snes;  // the other schemes would lose their past states with TS
  PetscCall(TSGetSNES(ts_, &snes));
  PetscCall(forget(snes));
  PetscFunctionReturn(0);
}

/// A preconditioner is made at the first Newton iteration of a step and serves to its end, unless it ages on the way.
/// An older one costs more iterations than it saves: the bubble to .15 s takes 2955 Krylov iterations and 19 s instead
/// of 990 and 12 s.
PetscErrorCode TimeStepper::renew_preconditioner() {
  PetscFunctionBeginUser;
  SNES snes;
  KSP ksp;
  PetscBool chosen, alone;  // a preconditioner that is the whole solver: an old one would make Newton linear
  PetscCall(PetscOptionsHasName(nullptr, nullptr, "-snes_lag_preconditioner", &chosen));
  if (chosen) PetscFunctionReturn(0);
  PetscCall(TSGetSNES(ts_, &snes));
  PetscCall(SNESGetKSP(snes, &ksp));
  PetscCall(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(ksp), KSPPREONLY, &alone));
  PetscCall(SNESSetLagPreconditioner(snes, alone ? 1 : -2));  // -2: once, then not again
  fresh_krylov_ = -1;
  PetscFunctionReturn(0);
}

/// Renews the preconditioner where a Newton iteration took many more Krylov iterations than the first one with it:
/// where an iterate moves far, in the start of fine particles in air, they would go from 11 over 42, 96 and 182 to
/// failure.
PetscErrorCode TimeStepper::renew_if_aged(SNES snes) {
  PetscFunctionBeginUser;
  KSP ksp;
  PetscInt krylov;
  PetscCall(SNESGetKSP(snes, &ksp));
  PetscCall(KSPGetIterationNumber(ksp, &krylov));
  if (fresh_krylov_ < 0)
    fresh_krylov_ = krylov;
  else if (krylov > aged_factor * fresh_krylov_ + aged_more)
    PetscCall(renew_preconditioner());
  PetscFunctionReturn(0);
}

/// Schemes of order 2 do not keep nu positive: in voids a loose solution takes it below what the floor of the inertia
/// there bears.
double TimeStepper::newton_residual() const {
  const NewtonTolerance newton = control_.scheme == "beuler" ? history_.newton : NewtonTolerance();
  return newton.residual(control_.accuracy);
}

/// PETSc's norm is a sum over unknowns.
PetscErrorCode TimeStepper::set_newton_tolerance() {
  PetscFunctionBeginUser;
  SNES snes;
  PetscInt size;
  PetscBool chosen;
  PetscCall(PetscOptionsHasName(nullptr, nullptr, "-snes_atol", &chosen));
  if (chosen) PetscFunctionReturn(0);
  PetscCall(TSGetSNES(ts_, &snes));
  PetscCall(VecGetSize(state_, &size));
  const double tolerance = newton_residual() * std::sqrt(static_cast<double>(size));
  PetscCall(SNESSetTolerances(snes, tolerance, PETSC_DEFAULT, PETSC_DEFAULT, PETSC_DEFAULT, PETSC_DEFAULT));
  PetscFunctionReturn(0);
}

PetscErrorCode TimeStepper::first_guess(SNES snes, Vec guess, void* stepper) {
  PetscFunctionBeginUser;
  auto& self = *static_cast<TimeStepper*>(stepper);
  SNESConvergedReason reason;
  PetscCall(SNESGetConvergedReason(snes, &reason));
  if (reason < 0) {
    self.last_failure_ = SNESConvergedReasons[reason];
    self.history_.newton.failed();
    PetscCall(self.set_newton_tolerance());
    PetscCall(self.renew_preconditioner());
  }

  double dt;
  PetscCall(TSGetTimeStep(self.ts_, &dt));
  if (self.control_.scheme == "beuler" && self.control_.extrapolate && self.history_.dt_past[0] > 0 && reason >= 0)
    PetscCall(self.extrapolate(snes, dt / self.history_.dt_past[0], guess));
  long limited = 0;
  PetscCall(self.limits_.apply(self.guess_, guess, NewtonLimits::least_T_of_guess, &limited));
  PetscCall(self.problem_.raise_temperature(guess, dt));
  PetscFunctionReturn(0);
}

/// Puts the line through the last two states in the place of `guess`, the last of them, if its residual is smaller:
/// where fronts move or friction switches the line leads astray. What did well in the last step is not asked again.
PetscErrorCode TimeStepper::extrapolate(SNES snes, double ratio, Vec guess) {
  PetscFunctionBeginUser;
  if (history_.guess == FirstGuess::state || history_.easy_steps < easy_before_extrapolation) PetscFunctionReturn(0);
  long limited = 0;
  PetscCall(VecAXPBYPCZ(predicted_, 1 + ratio, -ratio, 0, guess_, past_[0]));
  PetscCall(limits_.apply(guess_, predicted_, NewtonLimits::least_T_of_guess, &limited));
  if (history_.guess == FirstGuess::better) {
    Vec residual;
    double norm, norm_on_line;
    PetscCall(SNESGetFunction(snes, &residual, nullptr, nullptr));
    PetscCall(SNESComputeFunction(snes, guess, residual));
    PetscCall(VecNorm(residual, NORM_2, &norm));
    PetscCall(SNESComputeFunction(snes, predicted_, residual));
    PetscCall(VecNorm(residual, NORM_2, &norm_on_line));
    history_.guess = norm_on_line < norm ? FirstGuess::line : FirstGuess::state;  // the latter for NaN
  }
  if (history_.guess == FirstGuess::line) PetscCall(VecCopy(predicted_, guess));
  PetscFunctionReturn(0);
}

PetscErrorCode TimeStepper::converged(SNES snes, PetscInt iteration, PetscReal x_norm, PetscReal step_norm,
                                      PetscReal f_norm, SNESConvergedReason* reason, void* stepper) {
  PetscFunctionBeginUser;
  PetscCall(SNESConvergedDefault(snes, iteration, x_norm, step_norm, f_norm, reason, nullptr));
  auto& self = *static_cast<TimeStepper*>(stepper);
  const bool lost = self.progress_.is_lost(iteration, f_norm);
  if (*reason == SNES_CONVERGED_ITERATING && lost) *reason = SNES_DIVERGED_DTOL;
  if (*reason > 0 && iteration > 0) {
    bool small;
    PetscCall(self.remainder_is_small(snes, &small));
    if (!small) *reason = SNES_CONVERGED_ITERATING;
  }
  double tolerance;
  PetscCall(SNESGetTolerances(snes, &tolerance, nullptr, nullptr, nullptr, nullptr));
  self.problem_.keep_jacobian(!self.jacobian_tested_ && iteration > 0 && f_norm < kept_reduction * self.last_norm_ &&
                              f_norm < kept_distance * tolerance);
  self.last_norm_ = f_norm;
  if (iteration > 0) PetscCall(self.renew_if_aged(snes));
  if (*reason > 0) PetscCall(self.correct_continuity(snes));
  PetscFunctionReturn(0);
}

/// Whether what is left is small beyond the mean: where particles are few, single cells far off make energy, and keep a
/// T from which there is no way back. And whether correct_continuity would change nu by no more than Newton's
/// tolerance, which in long steps takes more than a small residual, and leave it where it can be: nu below minus the
/// floor of voids is a negative inertia.
PetscErrorCode TimeStepper::remainder_is_small(SNES snes, bool* small) const {
  PetscFunctionBeginUser;
  Vec state, residual;
  const double share = control_.scheme == "beuler" ? 1e-8 : 0.5;  // schemes of order 2 do not keep nu positive
  Remainder left;
  PetscCall(SNESGetSolution(snes, &state));
  PetscCall(SNESGetFunction(snes, &residual, nullptr, nullptr));
  PetscCall(problem_.remainder(state, residual, &left));
  *small = left.dilute <= NewtonTolerance::dilute(control_.accuracy) && left.nu_change <= newton_residual() &&
           left.least_nu >= -share * problem_.setup().model.void_fraction_floor;
  PetscFunctionReturn(0);
}

PetscErrorCode TimeStepper::correct_continuity(SNES snes) {
  PetscFunctionBeginUser;
  Vec state, residual;
  PetscCall(SNESGetSolution(snes, &state));
  PetscCall(SNESGetFunction(snes, &residual, nullptr, nullptr));
  PetscCall(problem_.correct_continuity(state, residual, &attempt_imbalance_));
  PetscFunctionReturn(0);
}

PetscErrorCode TimeStepper::local_error(double dt, double* error) {
  PetscFunctionBeginUser;
  *error = 0;
  const auto [d1, d2] = history_.dt_past;
  const bool second_order = control_.scheme != "beuler";
  if (d1 <= 0 || (second_order && d2 <= 0)) PetscFunctionReturn(0);
  double share;  // of the difference to the extrapolation that is the error of the scheme
  if (!second_order) {
    PetscCall(VecAXPBYPCZ(predicted_, 1 + dt / d1, -dt / d1, 0, guess_, past_[0]));
    share = dt / (dt + d1);
  } else {  // Lagrange's polynomial through 0, -d1, -d1-d2 at dt
    const double s = d1 + d2;
    PetscCall(
        VecAXPBYPCZ(predicted_, (dt + d1) * (dt + s) / (d1 * s), -dt * (dt + s) / (d1 * d2), 0, guess_, past_[0]));
    PetscCall(VecAXPY(predicted_, dt * (dt + d1) / (s * d2), past_[1]));
    share = dt / (dt + s);
  }
  PetscCall(VecAXPY(predicted_, -1, state_));
  PetscCall(norm_of_evolving(predicted_, error));
  *error *= share / control_.accuracy;
  PetscFunctionReturn(0);
}

/// Root mean square over the unknowns that the error of a step is measured in. v, T and chi count less where fewer
/// particles have them than `few`: in voids they follow eddies of the gas, with steps of .1 ms where the bed asks for
/// some ms.
PetscErrorCode TimeStepper::norm_of_evolving(Vec difference, double* norm) const {
  PetscFunctionBeginUser;
  constexpr double few = 1e-2;
  const ProblemSetup& setup = problem_.setup();
  const bool gas_alone = !setup.model.solids_moving || setup.scales.density != setup.solids.kinetic.rho_s;
  const int unknowns = problem_.model().unknowns();
  std::vector<int> everywhere, with_particles;
  for (const Field& field : problem_.model().fields()) {
    if (field.symbol == "nu" || (field.symbol == "u" && gas_alone))
      everywhere.push_back(field.component);
    else if (field.symbol != "p_g" && field.symbol != "u")
      with_particles.push_back(field.component);
  }
  PetscInt size, local_size;
  const double *d, *x;
  PetscCall(VecGetSize(difference, &size));
  PetscCall(VecGetLocalSize(difference, &local_size));
  PetscCall(VecGetArrayRead(difference, &d));
  PetscCall(VecGetArrayRead(state_, &x));
  double sum = 0;
  for (PetscInt node = 0; node < local_size; node += unknowns) {
    const double weight = std::clamp(x[node + Model::solids_fraction] / few, 0.0, 1.0);
    for (const int c : everywhere) sum += d[node + c] * d[node + c];
    for (const int c : with_particles) sum += weight * d[node + c] * d[node + c];
  }
  PetscCall(VecRestoreArrayRead(state_, &x));
  PetscCall(VecRestoreArrayRead(difference, &d));
  PetscCallMPI(MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, comm_of(difference)));
  const double nodes = static_cast<double>(size) / unknowns;
  *norm = std::sqrt(sum / (nodes * static_cast<double>(everywhere.size() + with_particles.size())));
  PetscFunctionReturn(0);
}

PetscErrorCode TimeStepper::attempt(double dt, StepReport* report, bool* done) {
  PetscFunctionBeginUser;
  PetscInt newton[2], krylov[2], failures[2];
  const auto count = [&](int k) {
    PetscFunctionBeginUser;
    PetscCall(TSGetSNESIterations(ts_, &newton[k]));
    PetscCall(TSGetKSPIterations(ts_, &krylov[k]));
    PetscCall(TSGetSNESFailures(ts_, &failures[k]));
    PetscFunctionReturn(0);
  };
  PetscCall(count(0));
  last_failure_.clear();
  PetscCall(renew_preconditioner());
  PetscCall(set_newton_tolerance());
  TSAdapt adapt;  // what is left to a given time may be less than step_min
  PetscCall(TSGetAdapt(ts_, &adapt));
  const double least = std::min(control_.step_min, dt);
  PetscCall(TSAdaptSetStepLimits(adapt, least, PETSC_MAX_REAL));
  if (problem_.setup().solids.friction.lagged) PetscCall(problem_.lag_friction(state_, dt));
  PetscCall(TSSetTimeStep(ts_, finds_slope_ ? dt / 2 : dt));
  PetscCall(TSStep(ts_));
  finds_slope_ = false;
  PetscCall(count(1));
  report->newton += static_cast<int>(newton[1] - newton[0]);
  report->krylov += static_cast<int>(krylov[1] - krylov[0]);
  report->rejected_solver += static_cast<int>(failures[1] - failures[0]);
  if (failures[1] > failures[0]) report->reason = last_failure_;

  TSConvergedReason reason;
  PetscCall(TSGetConvergedReason(ts_, &reason));
  if (reason < 0) {
    report->failed = *done = true;
    PetscCall(VecCopy(guess_, state_));
    PetscFunctionReturn(0);
  }
  double reached;
  PetscCall(TSGetTime(ts_, &reached));
  report->dt = reached - time_;
  PetscCall(local_error(report->dt, &report->error));
  const bool too_short = report->dt < 0.4 * least;  // TS may cut further, down to steps that time does not feel
  if (too_short || !std::isfinite(report->error)) {
    report->failed = *done = true;
    if (!too_short) report->reason = "the state is not finite";
    PetscCall(VecCopy(guess_, state_));
    PetscFunctionReturn(0);
  }
  *done = !control_.adaptive || report->error <= 1 || report->dt <= 2 * control_.step_min;
  if (*done) {
    report->time = reached;
  } else {
    ++report->rejected_error;
    PetscCall(TSRollBack(ts_));
    PetscCall(TSRestartStep(ts_));  // what TS keeps of the rejected step is not to be used
    finds_slope_ = control_.scheme == "arkimex";
    PetscCall(VecCopy(guess_, state_));
  }
  PetscFunctionReturn(0);
}

PetscErrorCode TimeStepper::step(double limit, StepReport* report) {
  PetscFunctionBeginUser;
  *report = StepReport();
  limits_.reset();
  PetscCall(VecCopy(state_, guess_));  // guess_ holds the state at the start of the step
  double dt = control_.adaptive ? history_.dt_next : control_.step_initial;
  const double planned = dt;
  const double left = limit - time_;
  if (dt >= left * (1 - 1e-6))  // no remainder that is a step of rounding errors
    dt = left;
  else if (2 * dt > left && control_.adaptive)
    dt = left / 2;
  const bool cut = dt < planned;
  for (bool done = false; !done;) {
    PetscCall(attempt(dt, report, &done));
    if (!done) dt = std::max(control_.step_min, report->dt * std::max(0.3, 0.8 / std::sqrt(report->error)));
  }
  report->limited = limits_.limited();
  if (report->failed) PetscFunctionReturn(0);
  report->imbalance = {attempt_imbalance_.solids * report->dt, attempt_imbalance_.gas * report->dt};

  time_ = report->time;
  std::swap(past_[0], past_[1]);
  PetscCall(VecCopy(guess_, past_[0]));
  history_.dt_past = {report->dt, history_.dt_past[0]};
  choose_next_step(report->dt, *report);
  if (cut && report->rejected_solver + report->rejected_error == 0)
    history_.dt_next = std::max(history_.dt_next, planned);  // the cut was ours, not the solution's
  PetscFunctionReturn(0);
}

void TimeStepper::choose_next_step(double dt, const StepReport& report) {
  const bool failed = report.rejected_solver > 0;
  if (failed || report.rejected_error > 0 || report.newton > 2) history_.guess = FirstGuess::better;
  const bool easy = !failed && report.newton <= easy_newton;
  history_.easy_steps = easy ? history_.easy_steps + 1 : 0;
  history_.newton.step_done(failed);
  double factor = growth;
  if (failed || report.newton >= hard_newton)
    factor = failed ? 1.0 : 0.8;
  else if (!easy)
    factor = 1 + (growth - 1) * (hard_newton - report.newton) / (hard_newton - easy_newton);
  if (report.rejected_error > 0) factor = std::min(factor, 1.0);
  if (report.error > 0) factor = std::min(factor, 0.8 / std::sqrt(report.error));
  history_.dt_next = std::clamp(dt * std::max(factor, 0.3), control_.step_min, control_.step_max);
}

}  // namespace scree
