/// How far a state that Newton's method has come to is from one that may be taken.
#pragma once

#include "scree/stepping/discrete_problem.hpp"

namespace scree {

/// What a residual leaves undone, beside its norm. All in units of the scales.
struct Remainder {
  double nu_change;  ///< root mean square of what renew_solids_fraction would do to nu
  double least_nu;   ///< nu of the emptiest cell afterwards
  double dilute;     ///< the largest change in storage that would balance a row of v, T or chi where nu < 0.1
  double velocity;   ///< root mean square of the flow through a cell that would balance a row of mass, over that of v
};

/// That of `residual`, which belongs to `state`, in a stage of `shift` [1/s]. Collective.
PetscErrorCode measure_remainder(const DiscreteProblem& problem, double shift, Vec state, Vec residual,
                                 Remainder* remainder);

}  // namespace scree
