/// Critical-state pressure of Johnson & Jackson (1987), eq. (18).
#pragma once

#include "scree/closures/friction.hpp"

namespace scree {

/// F (nu - nu_min)^r/(nu_max - nu)^s [Pa]: starts with zero slope (r > 1) and diverges at nu_max.
struct PowerPressure {
  static constexpr const char *name = "power", *source = "Johnson & Jackson (1987), eq. (18), diverges at nu_max";

  template <class Number>
  static Number pressure(const Number& nu, const FrictionParameters& p) {
    return p.F * real_power(nu - p.nu_min, p.r) / real_power(p.nu_max - nu, p.s);
  }
};

}  // namespace scree
