/// What the time schemes have of their own: order, local error, extrapolation. Numbers only.
#pragma once

#include <array>

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
  int order() const { return scheme_ == TimeScheme::beuler ? 1 : 2; }
  /// Backward Euler keeps nu and T positive however long the step is.
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
  /// Share of the difference between a new state and the extrapolation that counts as the local error of the scheme.
  /// Cautious: for equal steps 1/2 for backward Euler and 1/3 for order 2, where Taylor's series say 1/3, and 2/11 for
  /// BDF.
  double error_share(double dt, const PastSteps& past) const {
    return dt / (dt + (order() == 1 ? past[0] : past[0] + past[1]));
  }

 private:
  TimeScheme scheme_;
};

}  // namespace scree
