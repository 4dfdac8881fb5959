/// What the time schemes have of their own: order, local error, extrapolation. Numbers only.
#pragma once

#include <array>
#include <cmath>

#include "scree/stepping/choices.hpp"

namespace scree {

/// Lengths of the steps before the current state, newest first; 0: there was none [s].
using PastSteps = std::array<double, 2>;

/// Weights of the current state and of the two before it.
using StateWeights = std::array<double, 3>;

class Scheme {
 public:
  explicit Scheme(TimeScheme scheme) : scheme_(scheme) {}

  TimeScheme name() const { return scheme_; }
  /// Stages of a step that Newton's method solves.
  int stages() const { return scheme_ == TimeScheme::arkimex ? 2 : 1; }
  int order() const { return scheme_ == TimeScheme::beuler ? 1 : 2; }
  /// Backward Euler keeps nu and T positive however long the step is. No scheme of higher order does, not even for
  /// linear balances (Bolley and Crouzeix (1978), RAIRO Anal. numer. 12, 237).
  bool keeps_signs() const { return scheme_ == TimeScheme::beuler; }
  /// Whether a step depends on nothing but the state before it, so that TS may be made anew between steps.
  bool has_one_step() const { return scheme_ == TimeScheme::beuler; }

  /// Whether there are steps enough behind the current state to extrapolate with the order of the scheme.
  bool can_extrapolate(const PastSteps& past) const { return past[static_cast<std::size_t>(order() - 1)] > 0; }
  /// The polynomial of degree order() through the past states, after a step of dt.
  StateWeights extrapolation(double dt, const PastSteps& past) const {
    const auto [d1, d2] = past;
    if (order() == 1) return {1 + dt / d1, -dt / d1, 0};
    const double s = d1 + d2;  // Lagrange's polynomial through 0, -d1, -s
    return {(dt + d1) * (dt + s) / (d1 * s), -dt * (dt + s) / (d1 * d2), dt * (dt + d1) / (s * d2)};
  }
  /// Share of the difference between a new state and the extrapolation that is the local error of the scheme.
  /// Backward Euler's last step has its new slope, so that the line through its ends is the tangent at its end, and
  /// differs from the next state by dt^2 y'': twice the error, whatever the lengths of the steps. The parabola through
  /// smooth states errs by dt (dt + d1) (dt + s) y'''/6, BDF2 by dt^2 (dt + d1) y'''/6, TSARKIMEX2E (TR-BDF2, Bank et
  /// al. (1985), IEEE Trans. CAD 4, 436) by (3 sqrt(2) - 4)/6 dt^3 y'''.
  double error_share(double dt, const PastSteps& past) const {
    const auto [d1, d2] = past;
    switch (scheme_) {
      case TimeScheme::beuler:
        return 0.5;
      case TimeScheme::bdf:
        return dt / (dt + d1 + d2);
      case TimeScheme::arkimex:
        return (3 * std::sqrt(2.0) - 4) * dt * dt / ((dt + d1) * (dt + d1 + d2));
    }
    return 1;
  }
  /// Local error that a step may make so that the errors of all steps add up to about `accuracy`: where steps of dt
  /// make local errors like dt^(p+1), what they leave is like dt^p. The factor is measured, on what has no steady state
  /// (tests/verification/accuracy_steers.py): fields come to one to three times the accuracy, what is added up over a
  /// bed to less.
  double local_tolerance(double accuracy) const { return 2.0 / order() * std::pow(accuracy, 1 + 1.0 / order()); }

 private:
  TimeScheme scheme_;
};

}  // namespace scree
