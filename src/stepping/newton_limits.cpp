#include "scree/stepping/newton_limits.hpp"

#include <algorithm>

#include "scree/stepping/corrections.hpp"

namespace scree {

namespace {

/// `target` moved into [lower, upper]; counts if it had to move.
double bounded(double target, double lower, double upper, long& limited) {
  const double result = std::min(std::max(target, lower), upper);
  if (result != target) ++limited;
  return result;
}

}  // namespace

NewtonLimits::NewtonLimits(const DiscreteProblem& problem)
    : problem_(problem),
      nu_max_(problem.setup().solids.friction.nu_max),
      chi_max_(maximum_chi(problem.setup().solids.friction)),
      T_(problem.model().granular_temperature()),
      chi_(problem.model().frictional_pressure_ratio()) {}

PetscErrorCode NewtonLimits::apply(Vec from, Vec target, double least_T, long* limited) const {
  PetscFunctionBeginUser;
  const double* old;
  double* x;
  PetscInt size;
  PetscCall(VecGetLocalSize(target, &size));
  PetscCall(VecGetArrayRead(from, &old));
  PetscCall(VecGetArray(target, &x));
  const int unknowns = problem_.model().unknowns();
  for (PetscInt node = 0; node < size; node += unknowns) {
    const double nu = old[node + Model::solids_fraction];
    double& next_nu = x[node + Model::solids_fraction];
    next_nu = bounded(next_nu, 0, nu + 0.7 * (nu_max_ - nu), *limited);
    if (T_ >= 0) x[node + T_] = bounded(x[node + T_], least_T * old[node + T_], PETSC_INFINITY, *limited);
    if (chi_ >= 0) x[node + chi_] = bounded(x[node + chi_], 0.1 * old[node + chi_], chi_max_, *limited);
  }
  PetscCall(VecRestoreArray(target, &x));
  PetscCall(VecRestoreArrayRead(from, &old));
  PetscFunctionReturn(0);
}

PetscErrorCode NewtonLimits::pre_check(SNESLineSearch, Vec state, Vec step, PetscBool* changed, void* limits) {
  PetscFunctionBeginUser;
  auto& self = *static_cast<NewtonLimits*>(limits);
  long limited = 0;
  // The line search goes from state to state - step.
  PetscCall(VecAYPX(step, -1, state));
  PetscCall(self.apply(state, step, least_T_of_iterate, &limited));
  self.limited_ += limited;
  long any = limited;
  PetscCallMPI(
      MPI_Allreduce(MPI_IN_PLACE, &any, 1, MPI_LONG, MPI_SUM, PetscObjectComm(reinterpret_cast<PetscObject>(state))));
  // Where Newton's method wanted T < 0 it may be on its way to nothing, away from a root above.
  if (any > 0) PetscCall(raise_temperature(self.problem_, 1 / self.stage_->shift, step));
  PetscCall(VecAYPX(step, -1, state));
  *changed = any > 0 ? PETSC_TRUE : PETSC_FALSE;
  PetscFunctionReturn(0);
}

PetscErrorCode NewtonLimits::attach(SNES snes, const Stage* stage) {
  PetscFunctionBeginUser;
  stage_ = stage;
  SNESLineSearch search;
  PetscCall(SNESGetLineSearch(snes, &search));
  PetscCall(SNESLineSearchSetPreCheck(search, pre_check, this));
  PetscFunctionReturn(0);
}

}  // namespace scree
