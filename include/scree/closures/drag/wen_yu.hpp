/// Drag of Wen & Yu (1966), eqs. (6) and (7).
#pragma once

#include "scree/math/dual.hpp"

namespace scree {

/// C_D Re/24 of (7), a lone sphere: drag in units of its Stokes value [-].
/// (7) jumps by 0.4 % at Re = 1000; here a smoothstep joins its two forms over Re = 950 ... 1050, so that slopes are
/// continuous and factor times Re still grows with Re.
template <class Number>
Number lone_sphere_factor(const Number& Re) {
  constexpr double lower = 950, upper = 1050;
  if (Re >= upper) return .44 / 24 * Re;
  const Number intermediate = 1.0 + .15 * pow(Re, .687);
  if (Re <= lower) return intermediate;
  const Number t = (Re - lower) / (upper - lower);
  return intermediate + t * t * (3.0 - 2.0 * t) * (.44 / 24 * Re - intermediate);
}

/// Limits: (1-nu)^-2.65 as Re -> 0, 0.44/24 Re (1-nu)^-2.65 beyond Re = 1050.
struct WenYu {
  static constexpr const char *name = "wen_yu", *source = "Wen & Yu (1966), eqs. (6), (7)";

  template <class Number>
  static Number factor(const Number& nu, const Number& Re) {
    return pow(1.0 - nu, -2.65) * lone_sphere_factor(Re);
  }
};

}  // namespace scree
