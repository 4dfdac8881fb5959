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
      context_{problem.setup().solids.friction.nu_max, maximum_chi(problem.setup().solids.friction), false} {
  for (const Field& field : problem.model().fields())
    if (field.unknown->bounds != unbounded) bounded_.push_back(field);
}

PetscErrorCode NewtonLimits::apply(Vec from, Vec target, bool first_guess, long* limited) const {
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
      x[at] = bounded(x[at], bounds.lower / field.scale, bounds.upper / field.scale, *limited);
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
  PetscCall(self.apply(state, step, false, &limited));
  self.limited_ += limited;
  long any = limited;
  PetscCallMPI(
      MPI_Allreduce(MPI_IN_PLACE, &any, 1, MPI_LONG, MPI_SUM, PetscObjectComm(reinterpret_cast<PetscObject>(state))));
  // Where Newton's method wanted T < 0 it may be on its way to nothing, away from a root above.
  const bool has_step = self.stage_->shift > 0;  // a steady problem has none
  if (any > 0 && has_step)
    PetscCall(raise_temperature(self.problem_, 1 / self.stage_->shift, least_nu_with_production, step));
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
