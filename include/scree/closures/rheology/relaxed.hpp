/// Flow rule met with a delay: (20) with the transported chi of (23).
#pragma once

#include "scree/closures/rheology.hpp"

namespace scree {

struct Relaxed {
  static constexpr const char *name = "relaxed", *source = "(20) with (23)";
  static constexpr bool has_friction = true, has_unknown = true, uses_flow_rule = true;

  template <class Number>
  static FrictionalStress<Number> stress(const FrictionalPoint<Number>& q, const FrictionParameters& p) {
    if (q.p_c == 0.0) return {Number(0.0), Number(0.0)};
    const Number p_f = q.chi * q.p_c;
    return {p_f, p_f * yield_factor(q.chi, p) / (2.0 * q.gamma)};
  }

  template <class Number>
  static Number steady(const FrictionalPoint<Number>& q, const FrictionParameters& p) {
    return chi_star(q.div_v, q.gamma, p);
  }
};

}  // namespace scree
