/// g0 of Lun & Savage (1986) in the form of eq. (1.7).
#pragma once

#include "scree/math/dual.hpp"

namespace scree {

/// 1/(1 - (nu/nu_max)^(1/3)); grows as 3 nu_max/(nu_max - nu).
/// Written with 1 - r = (1 - r^3)/(1 + r + r^2), which does not cancel near nu_max. The cube root has an infinite slope
/// at nu = 0, here limited by a width of 1e-5, the one of the void regularisation of the balances (relative change of
/// g0: 5e-11 at nu = 0.5, 1e-9 at 0.1, 4e-8 at 0.01).
struct LunSavage {
  static constexpr const char *name = "lun_savage", *source = "Lun & Savage (1986), eq. (1.7)";

  template <class Number>
  static Number g0(const Number& nu, double nu_max) {
    constexpr double width = 1e-5;
    const Number y = nu / nu_max;
    const Number r = y / cbrt(y * y + width * width);
    return nu_max * (1.0 + r + r * r) / (nu_max - nu);
  }
};

}  // namespace scree
