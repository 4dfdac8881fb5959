/// Flow rule met with a delay: (20) with the transported chi of (23).
#pragma once

#include "scree/closures/inertial.hpp"
#include "scree/closures/rheology.hpp"

namespace scree {

struct Relaxed {
  static constexpr const char *name = "relaxed", *source = "(20) with (23)";
  static constexpr bool has_friction = true, has_unknown = true, uses_flow_rule = true;

  template <class Number>
  static FrictionalStress<Number> stress(const FrictionalPoint<Number>& q, const FrictionParameters& p) {
    if (q.p_c == 0.0) return {Number(0.0), Number(0.0)};
    const Number p_f = q.chi * q.p_c;
    if (has_fluidity(p))
      return {p_f, fluid_viscosity(p_f, Number(yield_factor(q.chi, p) / friction_coefficient(p)), q.g_f)};
    if (p.coefficient != FrictionCoefficient::constant) {
      const auto at = inertial_point(p_f, q.div_v, q.gamma, p);
      return {p_f, at.ratio * p_f * yield_factor(q.chi, p) / (2.0 * q.gamma)};
    }
    return {p_f, p_f * yield_factor(q.chi, p) / (2.0 * q.gamma)};
  }

  /// With M(I), I is that of p_f as it is: what chi relaxes to then depends on chi, and is chi* once chi is there.
  template <class Number>
  static Number steady(const FrictionalPoint<Number>& q, const FrictionParameters& p) {
    if (!has_inertial_coefficient(p)) return chi_star(q.div_v, q.gamma, p);
    const auto at = inertial_point(Number(q.chi * q.p_c), q.div_v, q.gamma, p);
    return chi_star(at.div_v, at.flow_rate, p);
  }
};

}  // namespace scree
