/// g0 of Ma & Ahmadi (1986).
#pragma once

#include "scree/math/dual.hpp"

namespace scree {

/// (1 + 2.5 nu + 4.5904 nu^2 + 4.515439 nu^3)/(1 - (nu/nu_max)^3)^0.67802 with the case's nu_max in the place of the
/// 0.64356 of the fit; grows as (nu_max - nu)^-0.678, slower than (1.7). The difference of cubes is written as
/// (1-y)(1 + y + y^2), which does not cancel near nu_max.
struct MaAhmadi {
  static constexpr const char *name = "ma_ahmadi", *source = "Ma & Ahmadi (1986), J. Chem. Phys. 84, 3449";

  template <class Number>
  static Number g0(const Number& nu, double nu_max) {
    const Number y = nu / nu_max, to_packing = (nu_max - nu) / nu_max * (1.0 + y + y * y);
    return (1.0 + nu * (2.5 + nu * (4.5904 + 4.515439 * nu))) * pow(to_packing, -.67802);
  }
};

}  // namespace scree
