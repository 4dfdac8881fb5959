/// What a step depends on beside the state.
#pragma once

#include <algorithm>

#include "scree/stepping/first_guess.hpp"
#include "scree/stepping/newton_tolerance.hpp"
#include "scree/stepping/scheme.hpp"

namespace scree {

/// For checkpoints: with it and the past states a run goes on as if it had not been interrupted.
struct StepHistory {
  double dt_next = 0;  ///< step to try [s]
  PastSteps dt_past{0, 0};
  double error = 0;  ///< local error of the last step over what it might be; 0: not known
  FirstGuessPolicy guess;
  NewtonTolerance newton;

  /// Calls visit(name, member) for each number; the names are those in checkpoints.
  template <class Visitor>
  void each_member(Visitor&& visit) {
    visit("dt_next", dt_next);
    visit("dt_past_0", dt_past[0]);
    visit("dt_past_1", dt_past[1]);
    visit("error", error);
    visit("easy_steps", guess.easy_steps);
    visit("guess", guess.choice);
    visit("calm_steps", newton.calm);
    visit("calm_wait", newton.wait);
  }

  /// After something that makes past states and steps no guide: begins small again.
  void forget_past(double step_initial) {
    dt_past = {0, 0};
    error = 0;
    guess = FirstGuessPolicy();
    dt_next = std::min(dt_next, step_initial);
  }
};

}  // namespace scree
