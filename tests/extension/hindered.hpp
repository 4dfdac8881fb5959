/// A drag law from outside: creeping flow, hindered as (1-nu)^-3 at any Re.
#pragma once

#include "scree/closures/drag/drag_law.hpp"

struct Hindered {
  static constexpr const char *name = "hindered", *source = "made up for this test";

  template <class Number>
  static Number factor(const Number& nu, const Number&) {
    const Number gas = 1.0 - nu;
    return 1.0 / (gas * gas * gas);
  }
};
