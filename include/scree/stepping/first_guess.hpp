/// Where Newton's method begins.
#pragma once

namespace scree {

/// The state before the step, or the line through the last two states, or whichever has the smaller residual.
enum class FirstGuess { better, state, line };

/// When the line is asked at all. Where fronts move or friction switches it leads astray: most failures of Newton's
/// method would come from it. What did well in the last step is not asked again.
struct FirstGuessPolicy {
  static constexpr int easy_before_line = 3;  ///< easy steps in a row
  static constexpr int most_newton = 2;       ///< iterations with which a guess did well

  FirstGuess choice = FirstGuess::better;
  int easy_steps = 0;  ///< in a row

  bool considers_line() const { return choice != FirstGuess::state && easy_steps >= easy_before_line; }
  bool asks_residuals() const { return choice == FirstGuess::better; }
  /// With the residuals of the two guesses; one that is not finite loses.
  void compare(double of_state, double of_line) { choice = of_line < of_state ? FirstGuess::line : FirstGuess::state; }
  /// After a step of `newton` iterations; `lost`: an attempt at it was given up; `easy`: none by the solver, and few.
  void step_done(int newton, bool lost, bool easy) {
    if (lost || newton > most_newton) choice = FirstGuess::better;
    easy_steps = easy ? easy_steps + 1 : 0;
  }
};

}  // namespace scree
