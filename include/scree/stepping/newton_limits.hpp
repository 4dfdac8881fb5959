/// Keeps the iterates of Newton's method inside the model: a step may go only part of the way to a bound.
#pragma once

#include <petscsnes.h>

#include <vector>

#include "scree/stepping/discrete_problem.hpp"
#include "scree/stepping/stage.hpp"

namespace scree {

/// Limits of one Newton step, unknown by unknown: the bounds that stand in its trait (balances/). They limit the way of
/// an iterate only: a converged state satisfies its equations, nothing is clipped.
class NewtonLimits {
 public:
  explicit NewtonLimits(const DiscreteProblem& problem);

  /// Registers with the line search of `snes`, which solves `stage`; both objects must outlive it.
  PetscErrorCode attach(SNES snes, const Stage* stage);
  /// Changes `target`, meant to be reached from `from`, where it breaks a limit; adds to `held` the places of the
  /// unknowns changed among those of this rank.
  PetscErrorCode apply(Vec from, Vec target, bool first_guess, std::vector<PetscInt>* held) const;

  long limited() const { return limited_; }  ///< unknowns limited so far, on this rank
  void reset() { limited_ = 0; }

 private:
  PetscErrorCode raise_cold(const std::vector<PetscInt>& held, Vec target) const;
  static PetscErrorCode pre_check(SNESLineSearch, Vec state, Vec step, PetscBool* changed, void* limits);

  const DiscreteProblem& problem_;
  NewtonContext context_;
  std::vector<Field> bounded_;  ///< those that have bounds
  const Stage* stage_ = nullptr;
  long limited_ = 0;
};

}  // namespace scree
