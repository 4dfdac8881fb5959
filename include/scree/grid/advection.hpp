/// Values that a flow carries through a face: first-order upwind, or second order with van Albada's limiter.
#pragma once

#include "scree/math/dual.hpp"

namespace scree {

/// Van Albada's mean of two slopes (van Albada, van Leer & Roberts 1982): 0 where their signs differ.
/// Smooth but for a kink where one slope changes sign.
template <class Number>
Number van_albada(const Number& a, const Number& b) {
  const Number product = a * b;
  if (!(product > 0.0)) return Number(0.0);
  return product * (a + b) / (a * a + b * b + 1e-200);
}

/// The slope in a cell beside a side across which no slope is known: that to its one neighbour, as long as it is small
/// against `steepest` >= 0, the value of the cell over the distance to its face. So second order is kept, and what
/// flows out of a nearly empty cell stays in proportion to what it has.
template <class Number>
Number one_sided_slope(const Number& slope, const Number& steepest) {
  const Number size = slope < 0.0 ? Number(-slope) : slope;
  return slope * steepest * (size + steepest) / (size * size + steepest * steepest + 1e-200);
}

/// Metrics about the place where a flow crosses from `lower` to `upper`, each a distance [m].
struct AdvectionMetrics {
  double far_lower;    ///< from far_lower to lower
  double across;       ///< from lower to upper
  double far_upper;    ///< from upper to far_upper
  double lower_reach;  ///< from lower to the crossing
  double upper_reach;  ///< from the crossing to upper
};

/// The upstream value. A flow of exactly zero counts as positive, so that the branch never depends on rounding at rest.
template <class Flow, class Number>
const Number& upwind(const Flow& flow, const Number& lower, const Number& upper) {
  return value_of(flow) >= 0 ? lower : upper;
}

/// The upstream value carried to the crossing along its slope, which lower_slope and upper_slope make of the slope
/// between the two.
template <class Flow, class Number, class LowerSlope, class UpperSlope>
Number along_slope(const Flow& flow, const Number& lower, const Number& upper, const AdvectionMetrics& h,
                   LowerSlope&& lower_slope, UpperSlope&& upper_slope) {
  const Number middle = (upper - lower) / h.across;
  if (value_of(flow) >= 0) return lower + h.lower_reach * lower_slope(middle);
  return upper - h.upper_reach * upper_slope(middle);
}

/// The upstream value carried to the crossing along the limited slope.
template <class Flow, class Number>
Number limited_upwind(const Flow& flow, const Number& far_lower, const Number& lower, const Number& upper,
                      const Number& far_upper, const AdvectionMetrics& h) {
  return along_slope(
      flow, lower, upper, h,
      [&](const Number& middle) { return van_albada(Number((lower - far_lower) / h.far_lower), middle); },
      [&](const Number& middle) { return van_albada(middle, Number((far_upper - upper) / h.far_upper)); });
}

}  // namespace scree
