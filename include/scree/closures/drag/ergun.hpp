/// Drag of a packed bed, Ergun (1952).
#pragma once

#include "scree/math/dual.hpp"

namespace scree {

/// beta = 150 nu^2 mu_g/((1-nu) d^2) + 1.75 rho_g nu |u - v|/d as F(nu, Re) [-]; vanishes with nu and Re.
template <class Number>
Number ergun_factor(const Number& nu, const Number& Re) {
  return (150.0 / 18 * nu + 1.75 / 18 * Re) / (1.0 - nu);
}

/// Ergun's equation at any solids fraction. Limits: 25/3 nu/(1-nu) as Re -> 0, 1.75/18 Re/(1-nu) as Re grows.
/// The equation is one of packed beds: in dilute flow it would go to nothing. Here F stays at 1, the drag of a lone
/// sphere in creeping flow, where the equation is below 0.5, and is the equation's above 1.5 (creeping flow: from
/// nu = 0.153 on); a parabola joins them.
struct Ergun {
  static constexpr const char *name = "ergun", *source = "Ergun (1952)";

  template <class Number>
  static Number factor(const Number& nu, const Number& Re) {
    constexpr double width = 0.5;
    const Number bed = ergun_factor(nu, Re);
    if (bed <= 1 - width) return Number(1.0);
    if (bed >= 1 + width) return bed;
    const Number t = bed - (1 - width);
    return 1.0 + t * t / (4 * width);
  }
};

}  // namespace scree
