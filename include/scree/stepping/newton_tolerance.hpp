/// How exactly Newton's method solves a step.
#pragma once

#include <algorithm>

namespace scree {

/// Residual per unknown, in units of the scales, at which Newton's method stops: a share of the error that a step may
/// make, loose where the steps before went well, tight for some steps after a failed one, and for twice as many if
/// loose steps failed within as many. What a loose solution leaves in the velocities is noise in strain rates, which
/// beds of little T, with stresses of the sign of the strain rate alone, answer with hundreds of failed steps;
/// elsewhere it saves a third of the iterations.
struct NewtonTolerance {
  static constexpr double tight = 5e-4, loose = 1.5e-2;
  static constexpr double most = 3e-4;    ///< however loose: nu of the emptiest cells would turn negative
  static constexpr double least = 1e-11;  ///< what rounding lets be reached
  static constexpr double most_dilute = 3e-2;
  static constexpr int least_wait = 10, most_wait = 160;

  int calm = 0;           ///< steps since the last failure
  int wait = least_wait;  ///< steps without a failure after which the next is solved loosely

  /// For steps that may make the local error `local_tolerance`.
  double residual(double local_tolerance) const {
    return std::clamp((calm < wait ? tight : loose) * local_tolerance, least, most);
  }
  /// How far off a single unknown may be where particles are few [scales].
  static double dilute(double local_tolerance) { return std::clamp(3 * local_tolerance, 1e3 * least, most_dilute); }
  /// How far off velocities may be on the whole, relative to what they are.
  static double velocity(double local_tolerance) { return std::max(0.3 * local_tolerance, 1e3 * least); }
  /// An attempt; the next one of the same step is to do better. A tight one that fails says nothing of loose ones.
  void failed() {
    if (calm >= wait) wait = calm < 2 * wait ? std::min(2 * wait, most_wait) : least_wait;
    calm = 0;
  }
  /// After the step, of which `failed_before` says whether it took several attempts.
  void step_done(bool failed_before) {
    if (failed_before)
      failed();
    else
      ++calm;
  }
};

}  // namespace scree
