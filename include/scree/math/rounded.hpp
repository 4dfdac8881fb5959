/// Minimum and maximum with a constant, rounded where they would have a kink: Newton's method wants slopes.
#pragma once

#include "scree/math/dual.hpp"

namespace scree {

/// min(x, limit), rounded by a parabola over limit +- width.
template <class Number>
Number rounded_minimum(const Number& x, double limit, double width) {
  if (x <= limit - width) return x;
  if (x >= limit + width) return Number(limit);
  const Number t = x - (limit - width);
  return x - t * t / (4 * width);
}

/// max(x, limit), rounded in the same way.
template <class Number>
Number rounded_maximum(const Number& x, double limit, double width) {
  return -rounded_minimum(Number(-x), -limit, width);
}

}  // namespace scree
