/// How exactly Newton's method solves a step.
#pragma once

#include <algorithm>

namespace scree {

/// Where Newton's method stops, as a share of the error that a step may make: loosely where the steps before went
/// well, tightly for some steps after a failed one, and for twice as many after each that follows. What a loose
/// solution leaves in the velocities is noise in strain rates, which beds of little T, with stresses of the sign of the
/// strain rate alone, answer with hundreds of failed steps; elsewhere it saves a third of the iterations.
struct NewtonTolerance {
  static constexpr double tight = 1e-3, loose = 3e-2;
  static constexpr int least_wait = 20, most_wait = 1280;

  int calm = 0;           ///< steps since the last failure
  int wait = least_wait;  ///< steps without a failure after which the next is solved loosely

  double share() const { return calm < wait ? tight : loose; }
  void failed() { calm = 0; }  ///< an attempt; the next one of the same step is to do better
  /// After the step, of which `failed_before` says whether it took several attempts.
  void step_done(bool failed_before) {
    if (failed_before) wait = std::min(2 * wait, most_wait);
    calm = failed_before ? 0 : calm + 1;
    if (calm == 4 * wait) wait = least_wait;
  }
};

}  // namespace scree
