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
/// where they are narrow, and large where a kink lies within them. Directions are scaled so that s = 1 is wide. Steps
/// are made narrower while the error of any row is above its `negligible`, which is not negative.
inline Differences differences(Evaluation& problem, const Values& state, const Values& rate, const Values& direction,
                               const Values& rate_direction, const Values& negligible) {
  const auto shifted = [](const Values& at, double s, const Values& along) {
    Values result = at;
    for (std::size_t i = 0; i < at.size(); ++i) result[i] += s * along[i];
    return result;
  };
  constexpr int levels = 5;
  Values central[levels];
  Differences result{problem.zeros(), Values(state.size(), std::numeric_limits<double>::infinity())};
  double s = 1e-3;
  for (int k = 0; k < levels; ++k, s /= 4) {
    Values& quotient = central[k];
    quotient = problem.residual(shifted(state, s, direction), shifted(rate, s, rate_direction));
    const Values lower = problem.residual(shifted(state, -s, direction), shifted(rate, -s, rate_direction));
    for (std::size_t i = 0; i < quotient.size(); ++i) quotient[i] = (quotient[i] - lower[i]) / (2 * s);
    if (k < 2) continue;  // an error wants two extrapolations
    bool enough = true;
    for (std::size_t i = 0; i < state.size(); ++i) {
      const double before = (16 * central[k - 1][i] - central[k - 2][i]) / 15;
      const double here = (16 * central[k][i] - central[k - 1][i]) / 15;
      const double error = std::abs(here - before);
      if (error < result.error[i]) {
        result.error[i] = error;
        result.slope[i] = here;
      }
      enough = enough && result.error[i] <= negligible[i];
    }
    if (enough) break;
  }
  return result;
}

}  // namespace scree::test
