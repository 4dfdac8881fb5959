/// Keeps the iterates of Newton's method inside the model: a step may go only part of the way to a bound.
#pragma once

#include <petscsnes.h>

#include "scree/stepping/discrete_problem.hpp"
#include "scree/stepping/stage.hpp"

namespace scree {

/// Limits of one Newton step, component by component: nu takes at most .7 of what is left to nu_max and stays >= 0,
/// T keeps at least a share and chi 10 % of its value, chi stays below the tip of the yield surface. These limit the
/// way of an iterate only: a converged state satisfies its equations, nothing is clipped.
class NewtonLimits {
 public:
  /// Shares that T keeps: in a Newton step, and in the first guess of a step in time, from where Newton's method
  /// seldom finds back up.
  static constexpr double least_T_of_iterate = 0.01, least_T_of_guess = 0.5;

  explicit NewtonLimits(const DiscreteProblem& problem);

  /// Registers with the line search of `snes`, which solves `stage`; both objects must outlive it.
  PetscErrorCode attach(SNES snes, const Stage* stage);
  /// Changes `target`, meant to be reached from `from`, where it breaks a limit; adds to `limited` the unknowns changed
  /// on this rank. T may fall to `least_T` times what it was.
  PetscErrorCode apply(Vec from, Vec target, double least_T, long* limited) const;

  long limited() const { return limited_; }  ///< unknowns limited so far, on this rank
  void reset() { limited_ = 0; }

 private:
  static PetscErrorCode pre_check(SNESLineSearch, Vec state, Vec step, PetscBool* changed, void* limits);

  const DiscreteProblem& problem_;
  double nu_max_, chi_max_;
  int T_, chi_;  ///< components
  const Stage* stage_ = nullptr;
  long limited_ = 0;
};

}  // namespace scree
