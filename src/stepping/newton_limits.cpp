#include "scree/stepping/newton_limits.hpp"

#include <algorithm>

#include "scree/balances/layout.hpp"
#include "scree/stepping/corrections.hpp"

namespace scree {

namespace {

/// Takes over T of `raised` where `target` was held at the lower bound of T.
PetscErrorCode take_over(Vec raised, int T, int unknowns, const std::vector<PetscInt>& held, Vec target) {
  PetscFunctionBeginUser;
  const double* from;
  double* to;
  PetscCall(VecGetArrayRead(raised, &from));
  PetscCall(VecGetArray(target, &to));
  for (const PetscInt at : held)
    if (at % unknowns == T) to[at] = from[at];
  PetscCall(VecRestoreArray(target, &to));
  PetscCall(VecRestoreArrayRead(raised, &from));
  PetscFunctionReturn(0);
}

}  // namespace

NewtonLimits::NewtonLimits(const DiscreteProblem& problem)
    : problem_(problem),
      context_{problem.setup().solids.friction.nu_max, maximum_chi(problem.setup().solids.friction), false} {
  for (const Field& field : problem.model().fields())
    if (field.unknown->bounds != unbounded) bounded_.push_back(field);
}

PetscErrorCode NewtonLimits::apply(Vec from, Vec target, bool first_guess, std::vector<PetscInt>* held) const {
  PetscFunctionBeginUser;
  const double* old;
  double* x;
  PetscInt size;
  PetscCall(VecGetLocalSize(target, &size));
  PetscCall(VecGetArrayRead(from, &old));
  PetscCall(VecGetArray(target, &x));
  NewtonContext context = context_;
  context.first_guess = first_guess;
  const int unknowns = problem_.model().unknowns();
  for (PetscInt node = 0; node < size; node += unknowns)
    for (const Field& field : bounded_) {
      const PetscInt at = node + field.component;
      const NewtonBounds bounds = field.unknown->bounds(old[at] * field.scale, context);
      const double within = std::clamp(x[at], bounds.lower / field.scale, bounds.upper / field.scale);
      if (within != x[at]) held->push_back(at);
      x[at] = within;
    }
  PetscCall(VecRestoreArray(target, &x));
  PetscCall(VecRestoreArrayRead(from, &old));
  PetscFunctionReturn(0);
}

PetscErrorCode NewtonLimits::pre_check(SNESLineSearch, Vec state, Vec step, PetscBool* changed, void* limits) {
  PetscFunctionBeginUser;
  auto& self = *static_cast<NewtonLimits*>(limits);
  std::vector<PetscInt> held;
  // The line search goes from state to state - step.
  PetscCall(VecAYPX(step, -1, state));
  PetscCall(self.apply(state, step, false, &held));
  self.limited_ += static_cast<long>(held.size());
  long any = static_cast<long>(held.size());
  PetscCallMPI(
      MPI_Allreduce(MPI_IN_PLACE, &any, 1, MPI_LONG, MPI_SUM, PetscObjectComm(reinterpret_cast<PetscObject>(state))));
  const bool has_step = self.stage_->shift > 0;  // a steady problem has none
  if (any > 0 && has_step) PetscCall(self.raise_cold(held, step));
  PetscCall(VecAYPX(step, -1, state));
  *changed = any > 0 ? PETSC_TRUE : PETSC_FALSE;
  PetscFunctionReturn(0);
}

/// Where Newton's method wanted T < 0 it may be on its way to nothing, away from a root above. Other cells are left
/// alone: what raises T knows production and dissipation, not what neighbours exchange.
PetscErrorCode NewtonLimits::raise_cold(const std::vector<PetscInt>& held, Vec target) const {
  PetscFunctionBeginUser;
  const int T = problem_.model().component<GranularEnergy>();
  if (T < 0) PetscFunctionReturn(0);
  Vec raised;
  PetscCall(DMGetGlobalVector(problem_.dm(), &raised));
  PetscCall(VecCopy(target, raised));
  PetscCall(raise_temperature(problem_, 1 / stage_->shift, least_nu_with_production, raised));
  PetscCall(take_over(raised, T, problem_.model().unknowns(), held, target));
  PetscCall(DMRestoreGlobalVector(problem_.dm(), &raised));
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
