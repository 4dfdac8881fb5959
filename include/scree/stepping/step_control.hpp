/// What a user decides about steps.
#pragma once

#include "scree/stepping/choices.hpp"
#include "scree/stepping/step_controller.hpp"

namespace scree {

struct StepControl {
  TimeScheme scheme = TimeScheme::beuler;
  StepBounds step;
  double accuracy = 1e-2;                    ///< root mean square of the local error of a step, see norm_of_error
  TangentKind tangent = TangentKind::exact;  ///< of Newton's method
  bool extrapolate = true;  ///< first guess of Newton's method on the line of the last states if that is better
};

}  // namespace scree
