#include "scree/stepping/stage_solver.hpp"

#include <cmath>

#include "scree/stepping/condensed_preconditioner.hpp"
#include "scree/stepping/line_search.hpp"
#include "scree/stepping/orderings.hpp"
#include "scree/stepping/petsc_versions.hpp"
#include "scree/stepping/remainder.hpp"
#include "scree/stepping/staggered_multigrid.hpp"

namespace scree {

StageSolver::~StageSolver() {
  PetscCallAbort(PETSC_COMM_SELF, SNESDestroy(&newton_));
  PetscCallAbort(PETSC_COMM_SELF, VecDestroy(&line_));
  PetscCallAbort(PETSC_COMM_SELF, VecDestroy(&guess_));
  PetscCallAbort(PETSC_COMM_SELF, VecDestroy(&settled_));
}

/// The SNES of TS is a shell with a prefix of its own, so that the user's options go to the one that does the work.
PetscErrorCode StageSolver::create(TS ts, const std::string& prefix) {
  PetscFunctionBeginUser;
  SNES shell;
  ts_ = ts;
  prefix_ = prefix;
  PetscCall(TSSetDM(ts, problem_.dm()));
  PetscCall(TSSetIFunction(ts, nullptr, evaluate, this));
  PetscCall(TSSetIJacobian(ts, problem_.matrix(), problem_.matrix(), differentiate, this));
  PetscCall(TSGetSNES(ts, &shell));
  PetscCall(SNESSetOptionsPrefix(shell, (prefix + "stage_").c_str()));
  PetscCall(SNESSetType(shell, SNESSHELL));
  PetscCall(SNESShellSetSolve(shell, solve_stage));
  PetscCall(SNESShellSetContext(shell, this));
  if (!line_) PetscCall(DMCreateGlobalVector(problem_.dm(), &line_));
  if (!guess_) PetscCall(DMCreateGlobalVector(problem_.dm(), &guess_));
  if (!settled_ && !scheme_.keeps_signs()) PetscCall(DMCreateGlobalVector(problem_.dm(), &settled_));
  PetscCall(create_newton());
  PetscFunctionReturn(0);
}

/// It has the equations of the SNES of TS from the DM that both share.
PetscErrorCode StageSolver::create_newton() {
  PetscFunctionBeginUser;
  PetscCall(register_orderings());
  PetscCall(register_condensed_preconditioner());
  PetscCall(register_staggered_multigrid());
  PetscCall(SNESDestroy(&newton_));
  PetscCall(SNESCreate(PetscObjectComm(reinterpret_cast<PetscObject>(problem_.dm())), &newton_));
  PetscCall(SNESSetOptionsPrefix(newton_, prefix_.c_str()));
  PetscCall(SNESSetApplicationContext(newton_, this));
  PetscCall(SNESSetDM(newton_, problem_.dm()));
  PetscCall(SNESSetJacobian(newton_, problem_.matrix(), problem_.matrix(), nullptr, nullptr));
  // The absolute tolerance is set_tolerance's. stol 0: a failed line search ends with tiny steps.
  PetscCall(SNESSetTolerances(newton_, petsc_unchanged, 1e-8, 0, 25, 10000));
  PetscCall(SNESSetForceIteration(newton_, PETSC_TRUE));
  PetscCall(SNESSetConvergenceHistory(newton_, nullptr, nullptr, PETSC_DECIDE, PETSC_TRUE));
  PetscCall(SNESSetFromOptions(newton_));
  PetscCall(is_given("-snes_test_jacobian", &tests_jacobian_));
  PetscCall(SNESSetConvergenceTest(newton_, test_convergence, this, nullptr));
  PetscCall(SNESSetUpdate(newton_, before_iteration));
  PetscCall(use_guarded_full_steps(newton_));
  PetscCall(limits_.attach(newton_, &stage_));
  PetscFunctionReturn(0);
}

PetscErrorCode StageSolver::begin_attempt(Vec start, Vec before) {
  PetscFunctionBeginUser;
  start_ = start;
  before_ = before;
  PetscCall(renew_preconditioner());
  PetscCall(set_tolerance());
  PetscFunctionReturn(0);
}

PetscErrorCode StageSolver::solve_stage(SNES shell, Vec state) {
  PetscFunctionBeginUser;
  void* solver;
  PetscCall(SNESShellGetContext(shell, &solver));
  auto& self = *static_cast<StageSolver*>(solver);
  SNESConvergedReason reason;
  PetscInt iterations;
  Vec right_side, residual;
  void* asked_by;  // TSARKIMEX finds its first slope with a TS of its own, of other stages, which does not count
  PetscCall(SNESGetFunction(shell, nullptr, nullptr, &asked_by));
  const bool counts = asked_by == self.ts_;
  if (counts && self.found_slope_) PetscCall(self.renew_preconditioner());
  self.found_slope_ = !counts;
  PetscCall(SNESGetRhs(shell, &right_side));
  PetscCall(SNESGetConvergedReason(self.newton_, &reason));
  PetscCall(SNESSetUp(self.newton_));

  PetscCall(self.begin_newton());
  PetscCall(self.guess(state, reason < 0));
  PetscCall(VecCopy(state, self.guess_));
  bool renews = !self.age_.is_new(), stronger = true;  // one made in this stage would be made of the same Jacobian
  PetscCall(self.run_newton(right_side, state, counts, &reason));
  for (; reason == SNES_DIVERGED_LINEAR_SOLVE; renews = false) {
    PetscCall(self.strengthen(renews, &stronger));
    if (!stronger) break;
    PetscCall(VecCopy(self.guess_, state));
    PetscCall(self.run_newton(right_side, state, counts, &reason));
  }
  PetscCall(SNESGetIterationNumber(self.newton_, &iterations));
  if (reason > 0) {
    PetscCall(self.look_at_age());
    PetscCall(SNESGetFunction(self.newton_, &residual, nullptr, nullptr));
    PetscCall(correct(self.problem_, self.stage_, residual, state, &self.imbalance_));
  } else {
    self.count_.failure = SNESConvergedReasons[reason];
    self.history_.newton.failed();
    PetscCall(self.set_tolerance());
    PetscCall(self.renew_preconditioner());
  }
  self.stage_.rate = nullptr;
  PetscCall(SNESSetIterationNumber(shell, iterations));
  PetscCall(SNESSetConvergedReason(shell, reason));
  PetscFunctionReturn(0);
}

PetscErrorCode StageSolver::begin_newton() {
  PetscFunctionBeginUser;
  double dt;
  PetscCall(TSGetTimeStep(ts_, &dt));
  const bool over_the_step = scheme_.name() == TimeScheme::beuler;
  problem_.model().begin_newton(tests_jacobian_ ? TangentKind::exact : control_.tangent, over_the_step ? dt : 0);
  PetscFunctionReturn(0);
}

PetscErrorCode StageSolver::run_newton(Vec right_side, Vec state, bool counts, SNESConvergedReason* reason) {
  PetscFunctionBeginUser;
  PetscInt iterations, krylov;
  KSP ksp;
  PetscCall(begin_newton());
  PetscCall(SNESGetKSP(newton_, &ksp));
  PetscCall(KSPGetTolerances(ksp, &linear_tolerance_, nullptr, nullptr, nullptr));
  PetscCall(SNESSolve(newton_, right_side, state));
  PetscCall(KSPSetTolerances(ksp, linear_tolerance_, petsc_unchanged, petsc_unchanged, petsc_unchanged));
  PetscCall(SNESGetConvergedReason(newton_, reason));
  PetscCall(SNESGetIterationNumber(newton_, &iterations));
  PetscCall(SNESGetLinearSolveIterations(newton_, &krylov));
  if (!counts) PetscFunctionReturn(0);
  count_.newton += static_cast<int>(iterations);
  count_.krylov += static_cast<int>(krylov);
  PetscFunctionReturn(0);
}

/// After a linear system that was not solved. A shorter step would make the next one easier, and the one after it, as
/// long again, would fail as this one: in nearly rigid beds for ever. So first the preconditioner is made of the
/// Jacobian at hand, if it `renews`, then another solver is asked for.
PetscErrorCode StageSolver::strengthen(bool renews, bool* stronger) {
  PetscFunctionBeginUser;
  PetscBool lag_given;
  PetscCall(is_given("-snes_lag_preconditioner", &lag_given));
  *stronger = renews && !lag_given;
  if (*stronger)
    PetscCall(renew_preconditioner());
  else if (strengthen_)
    PetscCall(strengthen_(stronger));
  PetscFunctionReturn(0);
}

PetscErrorCode StageSolver::evaluate(TS, PetscReal time, Vec state, Vec rate, Vec residual, void* solver) {
  PetscFunctionBeginUser;
  auto& self = *static_cast<StageSolver*>(solver);
  self.stage_.time = time;
  self.stage_.rate = rate;
  PetscCall(self.problem_.residual(time, state, rate, residual));
  PetscFunctionReturn(0);
}

PetscErrorCode StageSolver::differentiate(TS, PetscReal time, Vec state, Vec rate, PetscReal shift, Mat A, Mat P,
                                          void* solver) {
  PetscFunctionBeginUser;
  auto& self = *static_cast<StageSolver*>(solver);
  if (self.keeps_jacobian_ && A == P && shift == self.stage_.shift) PetscFunctionReturn(0);
  self.stage_.shift = shift;
  PetscCall(self.problem_.jacobian(time, state, rate, shift, P));
  if (A != P) {  // a matrix-free operator needs to know that the state has changed
    PetscCall(MatAssemblyBegin(A, MAT_FINAL_ASSEMBLY));
    PetscCall(MatAssemblyEnd(A, MAT_FINAL_ASSEMBLY));
  }
  PetscFunctionReturn(0);
}

PetscErrorCode StageSolver::guess(Vec state, bool after_failure) {
  PetscFunctionBeginUser;
  double dt;
  std::vector<PetscInt> held;
  PetscCall(TSGetTimeStep(ts_, &dt));
  // Schemes of order 2 bring a guess of their own.
  if (scheme_.order() == 1 && control_.extrapolate && scheme_.can_extrapolate(history_.dt_past) && !after_failure &&
      history_.guess.considers_line())
    PetscCall(put_on_line(dt, state));
  PetscCall(limits_.apply(start_, state, true, &held));
  PetscCall(raise_temperature(problem_, dt, least_nu_of_guess, state));
  PetscFunctionReturn(0);
}

/// Puts the line through the last two states in the place of `state`, the last of them, where FirstGuessPolicy wants
/// it.
PetscErrorCode StageSolver::put_on_line(double dt, Vec state) {
  PetscFunctionBeginUser;
  std::vector<PetscInt> held;
  const StateWeights weights = scheme_.extrapolation(dt, history_.dt_past);
  PetscCall(VecAXPBYPCZ(line_, weights[0], weights[1], 0, start_, before_));
  PetscCall(limits_.apply(start_, line_, true, &held));
  if (history_.guess.asks_residuals()) {
    double of_state, of_line;
    PetscCall(residual_norm(state, &of_state));
    PetscCall(residual_norm(line_, &of_line));
    history_.guess.compare(of_state, of_line);
  }
  if (history_.guess.choice == FirstGuess::line) PetscCall(VecCopy(line_, state));
  PetscFunctionReturn(0);
}

PetscErrorCode StageSolver::residual_norm(Vec state, double* norm) {
  PetscFunctionBeginUser;
  Vec residual;
  PetscCall(SNESGetFunction(newton_, &residual, nullptr, nullptr));
  PetscCall(SNESComputeFunction(newton_, state, residual));
  PetscCall(VecNorm(residual, NORM_2, norm));
  PetscFunctionReturn(0);
}

PetscErrorCode StageSolver::test_convergence(SNES snes, PetscInt iteration, PetscReal x_norm, PetscReal step_norm,
                                             PetscReal f_norm, SNESConvergedReason* reason, void* solver) {
  PetscFunctionBeginUser;
  const auto& self = *static_cast<const StageSolver*>(solver);
  if (!self.scheme_.keeps_signs() && iteration > 0) PetscCall(self.settle_what_died_down(&f_norm));
  PetscCall(SNESConvergedDefault(snes, iteration, x_norm, step_norm, f_norm, reason, nullptr));
  if (*reason > 0 && iteration > 0) {
    bool small;
    PetscCall(self.remainder_is_small(&small));
    if (!small) *reason = SNES_CONVERGED_ITERATING;
  }
  PetscFunctionReturn(0);
}

/// A stage of a scheme of order 2 would have T or chi below zero where they die down within the step. NewtonLimits hold
/// them above, and their balances stay open by what they would have to lose beyond all that they have: nothing that is
/// left to solve for.
PetscErrorCode StageSolver::settle_what_died_down(PetscReal* f_norm) const {
  PetscFunctionBeginUser;
  constexpr double share = 1e-3, nothing = 1e-7;  // of the value before the step, of its scale
  const int unknowns = problem_.model().unknowns();
  Vec state, residual;
  const double *old, *x;
  double* f;
  PetscInt size;
  PetscCall(SNESGetSolution(newton_, &state));
  PetscCall(SNESGetFunction(newton_, &residual, nullptr, nullptr));
  PetscCall(VecCopy(residual, settled_));
  PetscCall(VecGetLocalSize(state, &size));
  PetscCall(VecGetArrayRead(start_, &old));
  PetscCall(VecGetArrayRead(state, &x));
  PetscCall(VecGetArray(settled_, &f));
  for (const Field& field : problem_.model().fields()) {
    const bool dies_down = field.unknown->bounds != unbounded && field.component != Model::solids_fraction;
    for (PetscInt at = field.component; dies_down && at < size; at += unknowns)
      if (x[at] < std::max(share * old[at], nothing) && f[at] > 0) f[at] = 0;
  }
  PetscCall(VecRestoreArray(settled_, &f));
  PetscCall(VecRestoreArrayRead(state, &x));
  PetscCall(VecRestoreArrayRead(start_, &old));
  PetscCall(VecNorm(settled_, NORM_2, f_norm));
  PetscFunctionReturn(0);
}

/// Decides what the iteration takes over from the one before, the Jacobian, the preconditioner, and how well it solves
/// the linear system.
PetscErrorCode StageSolver::before_iteration(SNES snes, PetscInt iteration) {
  PetscFunctionBeginUser;
  void* solver;
  double tolerance;
  PetscCall(SNESGetApplicationContext(snes, &solver));
  auto& self = *static_cast<StageSolver*>(solver);
  PetscCall(SNESGetTolerances(snes, &tolerance, nullptr, nullptr, nullptr, nullptr));
  const ResidualNorms norms = self.norms();
  self.keeps_jacobian_ = !self.tests_jacobian_ && keeps_jacobian(norms, tolerance);
  if (iteration > 0) PetscCall(self.look_at_age());
  KSP ksp;
  PetscCall(SNESGetKSP(snes, &ksp));
  PetscCall(KSPSetTolerances(ksp, linear_tolerance(self.linear_tolerance_, norms, tolerance), petsc_unchanged,
                             petsc_unchanged, petsc_unchanged));
  PetscInt lag;
  PetscCall(SNESGetLagPreconditioner(snes, &lag));
  if (lag == 1 || self.renews_) ++self.count_.setups;
  self.renews_ = false;
  PetscFunctionReturn(0);
}

ResidualNorms StageSolver::norms() const {
  double* first;
  PetscInt count;
  PetscCallAbort(PETSC_COMM_SELF, SNESGetConvergenceHistory(newton_, &first, nullptr, &count));
  return ResidualNorms(first, first + count);
}

/// Whether what is left is small beyond the mean: where particles are few, single cells far off make energy, and keep a
/// T from which there is no way back. And whether renewing nu would change it by no more than Newton's tolerance, which
/// in long steps takes more than a small residual, and leave it where it can be: nu below minus the floor of voids is a
/// negative inertia. And whether rows of mass leave less in velocities than a step may: on cells much wider than the
/// particles a small residual is a large flow, which grows from step to step.
PetscErrorCode StageSolver::remainder_is_small(bool* small) const {
  PetscFunctionBeginUser;
  Vec state, residual;
  const double share_of_floor = scheme_.keeps_signs() ? 1e-8 : 0.5;
  Remainder left;
  PetscCall(SNESGetSolution(newton_, &state));
  PetscCall(SNESGetFunction(newton_, &residual, nullptr, nullptr));
  if (!scheme_.keeps_signs()) residual = settled_;
  PetscCall(measure_remainder(problem_, stage_.shift, state, residual, &left));
  *small = left.dilute <= NewtonTolerance::dilute(control_.local_tolerance()) &&
           left.nu_change <= tolerated_residual() &&
           left.velocity <= NewtonTolerance::velocity(control_.local_tolerance()) &&
           left.least_nu >= -share_of_floor * problem_.setup().model.solids_fraction_floor;
  PetscFunctionReturn(0);
}

PetscErrorCode StageSolver::look_at_age() {
  PetscFunctionBeginUser;
  KSP ksp;
  PetscInt krylov;
  PetscCall(SNESGetKSP(newton_, &ksp));
  PetscCall(KSPGetIterationNumber(ksp, &krylov));
  if (age_.has_aged(static_cast<int>(krylov))) PetscCall(renew_preconditioner());
  PetscFunctionReturn(0);
}

/// Has the preconditioner made with the next Jacobian, and kept from then on. One that is the whole solver is made each
/// time: an old one would make Newton's method linear.
PetscErrorCode StageSolver::renew_preconditioner() {
  PetscFunctionBeginUser;
  KSP ksp;
  PetscBool given, alone;
  PetscCall(is_given("-snes_lag_preconditioner", &given));
  if (given) PetscFunctionReturn(0);
  PetscCall(SNESGetKSP(newton_, &ksp));
  PetscCall(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(ksp), KSPPREONLY, &alone));
  PetscCall(SNESSetLagPreconditioner(newton_, alone ? 1 : -2));  // -2: once, then not again
  age_.renewed();
  renews_ = true;
  PetscFunctionReturn(0);
}

/// KSPReset alone drops the splits of a fieldsplit, which come from options.
PetscErrorCode StageSolver::forget_preconditioner() {
  PetscFunctionBeginUser;
  KSP ksp;
  PC pc;
  PetscCall(SNESGetKSP(newton_, &ksp));
  PetscCall(KSPGetPC(ksp, &pc));
  PetscCall(PCSetType(pc, PCNONE));
  PetscCall(KSPReset(ksp));
  PetscCall(KSPSetFromOptions(ksp));
  PetscFunctionReturn(0);
}

PetscErrorCode StageSolver::make_preconditioner_anew() {
  PetscFunctionBeginUser;
  KSP ksp;
  PC pc;
  PetscInt lag;
  PetscBool lag_given;
  PetscCall(SNESGetKSP(newton_, &ksp));
  PetscCall(KSPGetPC(ksp, &pc));
  PetscCall(PetscOptionsGetInt(nullptr, prefix_.c_str(), "-snes_lag_preconditioner", &lag, &lag_given));
  if (lag_given) PetscCall(SNESSetLagPreconditioner(newton_, lag));
  PetscCall(PCSetType(pc, PCNONE));  // a type that is set again keeps the solvers inside as they are
  PetscCall(KSPSetFromOptions(ksp));
  PetscCall(renew_preconditioner());
  PetscFunctionReturn(0);
}

double StageSolver::tolerated_residual() const { return history_.newton.residual(control_.local_tolerance()); }

/// PETSc's norm is a sum over unknowns.
PetscErrorCode StageSolver::set_tolerance() {
  PetscFunctionBeginUser;
  PetscInt size;
  PetscBool given;
  PetscCall(is_given("-snes_atol", &given));
  if (given) PetscFunctionReturn(0);
  PetscCall(VecGetSize(line_, &size));
  const double tolerance = tolerated_residual() * std::sqrt(static_cast<double>(size));
  PetscCall(SNESSetTolerances(newton_, tolerance, petsc_unchanged, petsc_unchanged, petsc_unchanged, petsc_unchanged));
  PetscFunctionReturn(0);
}

PetscErrorCode StageSolver::is_given(const char* option, PetscBool* given) const {
  PetscFunctionBeginUser;
  PetscCall(PetscOptionsHasName(nullptr, prefix_.c_str(), option, given));
  PetscFunctionReturn(0);
}

}  // namespace scree
