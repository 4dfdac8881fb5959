/// Critical state at any rate of dilation: chi = 1, eq. (22).
#pragma once

#include "scree/closures/inertial.hpp"
#include "scree/closures/rheology.hpp"

namespace scree {

struct CriticalState {
  static constexpr const char *name = "critical_state", *source = "(22)";
  static constexpr bool has_friction = true, has_unknown = false, uses_flow_rule = false;

  template <class Number>
  static FrictionalStress<Number> stress(const FrictionalPoint<Number>& q, const FrictionParameters& p) {
    if (q.p_c == 0.0) return {Number(0.0), Number(0.0)};
    const Number viscosity = friction_coefficient(p) * q.p_c / (2.0 * q.gamma);
    if (p.coefficient == FrictionCoefficient::constant) return {q.p_c, viscosity};
    return {q.p_c, inertial_point(q.p_c, q.div_v, q.gamma, p).ratio * viscosity};
  }

  template <class Number>
  static Number steady(const FrictionalPoint<Number>&, const FrictionParameters&) {
    return Number(1.0);
  }
};

}  // namespace scree
