/// Solids pressure of Syamlal, Rogers & O'Brien (1993), which MFIX and OpenFOAM pair with Schaeffer's (1987) stress.
#pragma once

#include "scree/closures/friction.hpp"

namespace scree {

/// 1e24 (nu - nu_min)^10 [Pa]; MFIX has 1e25 in dyn/cm2 and calls 1 - nu_min the packed void fraction. A penalty on
/// packing beyond nu_min rather than a measured pressure: its constants belong to no material, the bed's weight is
/// carried within 0.01 of nu_min whatever it is, and stays finite at nu_max. Put nu_min at the packing of the bed.
struct SchaefferPressure {
  static constexpr const char *name = "schaeffer",
                              *source =
                                  "Syamlal, Rogers & O'Brien (1993): 1e24 Pa (nu - nu_min)^10, to compare with "
                                  "MFIX's Schaeffer; nu_min is then the packing of the bed";

  template <class Number>
  static Number pressure(const Number& nu, const FrictionParameters& p) {
    return 1e24 * integer_power(nu - p.nu_min, 10);
  }
};

}  // namespace scree
