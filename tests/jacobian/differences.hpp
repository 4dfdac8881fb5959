/// Derivatives of the residual by differences, with an estimate of their error.
#pragma once

#include <cmath>
#include <limits>

#include "../support/sample_problem.hpp"

namespace scree::test {

/// dF/ds of F(state + s direction, rate + s rate_direction) at s = 0, a number a row, and how far to trust each.
struct Differences {
  Values slope, error;
};

/// Central differences at s = 1e-3 / 4^k, extrapolated to fourth order from neighbours (Richardson); of those the one
/// that differs least from the one before. The error is that difference: truncation where steps are wide, rounding
/// where they are narrow, and large where a kink lies within them. Directions are scaled so that s = 1 is wide.
inline Differences differences(Evaluation& problem, const Values& state, const Values& rate, const Values& direction,
                               const Values& rate_direction) {
  const auto shifted = [](const Values& at, double s, const Values& along) {
    Values result = at;
    for (std::size_t i = 0; i < at.size(); ++i) result[i] += s * along[i];
    return result;
  };
  constexpr int levels = 5;
  Values central[levels];
  double s = 1e-3;
  for (Values& quotient : central) {
    quotient = problem.residual(shifted(state, s, direction), shifted(rate, s, rate_direction));
    const Values lower = problem.residual(shifted(state, -s, direction), shifted(rate, -s, rate_direction));
    for (std::size_t i = 0; i < quotient.size(); ++i) quotient[i] = (quotient[i] - lower[i]) / (2 * s);
    s /= 4;
  }
  Differences result{problem.zeros(), Values(state.size(), std::numeric_limits<double>::infinity())};
  for (std::size_t i = 0; i < state.size(); ++i) {
    for (int k = 2; k < levels; ++k) {
      const double before = (16 * central[k - 1][i] - central[k - 2][i]) / 15;
      const double here = (16 * central[k][i] - central[k - 1][i]) / 15;
      const double error = std::abs(here - before);
      if (error >= result.error[i]) continue;
      result.error[i] = error;
      result.slope[i] = here;
    }
  }
  return result;
}

}  // namespace scree::test
