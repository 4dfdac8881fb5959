/// Length of the next step from the local error and from the difficulty of the solve: numbers in, numbers out.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree {

/// Bounds on steps [s].
struct StepBounds {
  double initial = 1e-6, least = 1e-12, most = std::numeric_limits<double>::infinity();
  bool adaptive = true;  ///< false: every step is `initial`
};

/// What became of a step.
struct StepOutcome {
  double error = 0;              ///< local error over what it may be; 0 where there is no estimate
  double error_before = 0;       ///< that of the step before
  int newton = 0;                ///< iterations a stage, failed attempts included
  bool failed = false;           ///< attempts given up since Newton or Krylov failed
  bool error_too_large = false;  ///< attempts given up since the local error was too large

  static constexpr int easy_newton = 4;  ///< iterations up to which a step counts as easy
  bool easy() const { return !failed && newton <= easy_newton; }
};

class StepController {
 public:
  static constexpr int hard_newton = 8;      ///< iterations from which on a step counts as hard: it shrinks
  static constexpr double growth = 1.3;      ///< of easy steps
  static constexpr double reduction = 0.25;  ///< after a failure of the solver
  static constexpr double aim = 0.64, least_factor = 0.3;
  /// Exponents of the errors of the last step and of the one before: the controller PI.4.2 of Soederlind & Wang (2006),
  /// J. Comput. Appl. Math. 185, 225.
  static constexpr double last = 0.6, before_last = -0.2;

  /// `order` of the scheme.
  StepController(const StepBounds& bounds, int order) : bounds_(bounds), power_(order + 1) {}

  /// A step to make, and the one that was meant: shorter where a time is near that the step must not pass.
  struct Plan {
    double dt, meant;
    bool cut() const { return dt < meant; }
  };
  /// `next` as next() said; `left` to the time that the step must not pass.
  Plan plan(double next, double left) const {
    const double meant = bounds_.adaptive ? next : bounds_.initial;
    double dt = meant;
    if (dt >= left * (1 - 1e-6))  // no remainder that is a step of rounding errors
      dt = left;
    else if (2 * dt > left && bounds_.adaptive)
      dt = left / 2;
    return {dt, meant};
  }
  /// The shortest step that counts: what is left to a given time may be less than the bound.
  double least(double dt) const { return std::min(bounds_.least, dt); }
  /// Whether a step of dt with this error stands.
  bool accepts(double dt, double error) const { return !bounds_.adaptive || error <= 1 || dt <= 2 * bounds_.least; }
  /// The next attempt at a step of dt whose error was too large.
  double after_rejection(double dt, double error) const {
    return std::max(bounds_.least, dt * std::max(least_factor, std::pow(aim / error, 1 / power_)));
  }
  /// The step after one of dt, which came of `plan`.
  double next(double dt, const StepOutcome& outcome, const Plan& plan) const {
    const double after = std::clamp(dt * std::max(factor(outcome), least_factor), bounds_.least, bounds_.most);
    const bool cut_by_us = plan.cut() && !outcome.failed && !outcome.error_too_large;  // and not by the solution
    return cut_by_us ? std::max(after, plan.meant) : after;
  }

 private:
  double factor(const StepOutcome& outcome) const {
    double factor = growth;
    if (outcome.failed)
      factor = 1;
    else if (outcome.newton >= hard_newton)
      factor = 0.8;
    else if (!outcome.easy())
      factor = 1 + (growth - 1) * (hard_newton - outcome.newton) / (hard_newton - StepOutcome::easy_newton);
    if (outcome.error_too_large) factor = std::min(factor, 1.0);
    if (outcome.error > 0) factor = std::min(factor, by_error(outcome.error, outcome.error_before));
    return factor;
  }
  double by_error(double error, double before) const {
    if (!(before > 0)) return std::pow(aim / error, 1 / power_);
    return std::pow(aim / error, last / power_) * std::pow(aim / before, before_last / power_);
  }

  StepBounds bounds_;
  double power_;  ///< of dt in the local error
};

}  // namespace scree
