/// No friction: kinetic stress alone.
#pragma once

#include "scree/closures/rheology.hpp"

namespace scree {

struct NoFriction {
  static constexpr const char *name = "none", *source = "absent";
  static constexpr bool has_friction = false, has_unknown = false, uses_flow_rule = false;

  template <class Number>
  static FrictionalStress<Number> stress(const FrictionalPoint<Number>&, const FrictionParameters&) {
    return {Number(0.0), Number(0.0)};
  }

  template <class Number>
  static Number steady(const FrictionalPoint<Number>&, const FrictionParameters&) {
    return Number(0.0);
  }
};

}  // namespace scree
