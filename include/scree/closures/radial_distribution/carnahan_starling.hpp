/// g0 of Carnahan & Starling (1969), the standard one of MFIX.
#pragma once

#include "scree/math/dual.hpp"

namespace scree {

/// (1 - nu/2)/(1-nu)^3 = 1/(1-nu) + 3/2 nu/(1-nu)^2 + 1/2 nu^2/(1-nu)^3. Knows no nu_max: 15.7 at nu = 0.65. Collisions
/// alone do not stop compaction there; p_c does, and without friction nothing but the solver's refusal of nu >= nu_max.
struct CarnahanStarling {
  static constexpr const char *name = "carnahan_starling",
                              *source = "Carnahan & Starling (1969), finite at nu_max: p_c has to hold the bed";

  template <class Number>
  static Number g0(const Number& nu, double) {
    const Number gas = 1.0 - nu;
    return (1.0 - .5 * nu) / (gas * gas * gas);
  }
};

}  // namespace scree
