/// Drag of Syamlal & O'Brien (1987), from terminal velocities in fluidised and settling beds.
#pragma once

#include "scree/math/dual.hpp"

namespace scree {

/// beta = 3/4 C_D nu (1-nu) rho_g |u - v|/(V_r^2 d) with Dalla Valle's C_D = (0.63 + 4.8 sqrt(V_r/Re_s))^2, where
/// Re_s = Re/(1-nu) = rho_g d |u - v|/mu_g and V_r is the terminal velocity of the bed over that of a lone sphere, by
/// Garside & Al-Dibouni. c1 = 0.8 and d1 = 2.65 are the standard ones, not fitted to a minimum fluidisation velocity.
/// Limits: 0.96 (1-nu)^-3.14 as Re -> 0; (1-nu) 0.63^2/24 Re_s/B^2 as Re grows.
struct SyamlalOBrien {
  static constexpr const char *name = "syamlal_obrien", *source = "Syamlal & O'Brien (1987), c1 = .8, d1 = 2.65";
  static constexpr double c1 = .8, d1 = 2.65;

  template <class Number>
  static Number factor(const Number& nu, const Number& Re) {
    const Number gas = 1.0 - nu, Re_s = Re / gas, A = pow(gas, 4.14), B = velocity_ratio_at_large_Re(gas);
    const Number V_r = velocity_ratio(Number(.06 * Re_s), A, B);
    const Number root = .63 * sqrt(Re_s / V_r) + 4.8;
    return gas * root * root / (24.0 * V_r);
  }

  /// V_r = (A - x + sqrt(x^2 + 2 x (2B-A) + A^2))/2, x = 0.06 Re_s, from A in creeping flow to B at large Re; in the
  /// form that does not cancel.
  template <class Number>
  static Number velocity_ratio(const Number& x, const Number& A, const Number& B) {
    const Number root = sqrt(x * x + 2.0 * x * (2.0 * B - A) + A * A);
    return x < A ? .5 * (A - x + root) : 2.0 * x * B / (root + x - A);
  }

  /// B: c1 (1-nu)^1.28 below 1-nu = 0.85, (1-nu)^d1 above. They differ by 5e-4 at 0.85; a smoothstep over 0.84 ... 0.86
  /// joins them.
  template <class Number>
  static Number velocity_ratio_at_large_Re(const Number& gas) {
    constexpr double lower = .84, upper = .86;
    if (gas >= upper) return pow(gas, d1);
    const Number dense = c1 * pow(gas, 1.28);
    if (gas <= lower) return dense;
    const Number t = (gas - lower) / (upper - lower);
    return dense + t * t * (3.0 - 2.0 * t) * (pow(gas, d1) - dense);
  }
};

}  // namespace scree
