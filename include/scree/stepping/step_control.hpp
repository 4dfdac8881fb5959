/// What a user decides about steps.
#pragma once

#include "scree/stepping/choices.hpp"
#include "scree/stepping/scheme.hpp"
#include "scree/stepping/step_controller.hpp"

namespace scree {

struct StepControl {
  TimeScheme scheme = TimeScheme::beuler;
  StepBounds step;
  double accuracy = 0.1;                               ///< relative error in time that is asked for
  TangentKind tangent = TangentKind::stress_velocity;  ///< of Newton's method
  bool extrapolate = true;  ///< first guess of Newton's method on the line of the last states if that is better

  /// What the local error of a step may be in the norm of norm_of_error.
  double local_tolerance() const { return Scheme(scheme).local_tolerance(accuracy); }
};

}  // namespace scree
