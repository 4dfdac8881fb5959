/// Drag of Gidaspow (1994): a packed bed by Ergun, dilute flow by Wen & Yu.
#pragma once

#include "scree/closures/drag/ergun.hpp"
#include "scree/closures/drag/wen_yu.hpp"

namespace scree {

/// Ergun above nu = 0.2, Wen & Yu below. The two differ at 0.2, by 15 % in creeping flow and by a factor of 3.7 at
/// large Re: as published the drag jumps. Here a smoothstep over nu = 0.18 ... 0.22 leads from one to the other, so
/// that Newton's method sees no jump; outside of it the law is as published.
struct Gidaspow {
  static constexpr const char *name = "gidaspow",
                              *source = "Gidaspow (1994): Ergun above nu = .2, Wen & Yu below, joined over .18 ... .22";

  template <class Number>
  static Number factor(const Number& nu, const Number& Re) {
    constexpr double lower = .18, upper = .22;
    if (nu <= lower) return WenYu::factor(nu, Re);
    const Number bed = ergun_factor(nu, Re);
    if (nu >= upper) return bed;
    const Number dilute = WenYu::factor(nu, Re), t = (nu - lower) / (upper - lower);
    return dilute + t * t * (3.0 - 2.0 * t) * (bed - dilute);
  }
};

}  // namespace scree
