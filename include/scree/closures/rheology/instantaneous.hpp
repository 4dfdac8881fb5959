/// Flow rule met at once: (20) with chi = chi*, eq. (21).
#pragma once

#include "scree/closures/rheology.hpp"

namespace scree {

/// chi and chi^(1/(n-1)) come from one base: no power of 33 to undo the one of 0.03.
struct Instantaneous {
  static constexpr const char *name = "instantaneous", *source = "(20) with chi = chi* (21)";
  static constexpr bool has_friction = true, has_unknown = false, uses_flow_rule = true;

  template <class Number>
  static FrictionalStress<Number> stress(const FrictionalPoint<Number>& q, const FrictionParameters& p) {
    if (q.p_c == 0.0) return {Number(0.0), Number(0.0)};
    const double n = yield_exponent(q.div_v, p);
    const Number base = chi_star_base(q.div_v, q.gamma, p);
    const Number p_f = clipped_power(base, n - 1, dilation_clip_width) * q.p_c;
    return {p_f, p_f * yield_factor_of_base(base, n, p) / (2.0 * q.gamma)};
  }

  template <class Number>
  static Number steady(const FrictionalPoint<Number>& q, const FrictionParameters& p) {
    return chi_star(q.div_v, q.gamma, p);
  }
};

}  // namespace scree
