/// The volume flux of solids nu v through a face, computed here for every balance that needs it, so that the advective
/// forms of (3), (9) and (23) are the conservative ones minus the same continuity.
#pragma once

#include "scree/assembly/kernel.hpp"
#include "scree/assembly/scene.hpp"
#include "scree/balances/solids_continuity.hpp"

namespace scree {

/// Adds the inputs of solids_flux for the lower `axis` face of anchor + at.
template <class L, bool SecondOrder>
constexpr void add_solids_flux_inputs(StencilBuilder& s, int axis, const Index& at) {
  s.add(L::v(axis), at);
  for (int reach = SecondOrder ? -2 : -1; reach <= (SecondOrder ? 1 : 0); ++reach)
    s.add(L::nu, at + reach * unit(axis));
}

/// nu v at the lower `axis` face of I + at [m/s]: 0 at walls; through sides the upstream value of cell or condition.
template <class L, bool SecondOrder, class Q>
[[gnu::always_inline]] inline auto solids_flux(const Scene& scene, const Index& I, const Q& q, int axis,
                                               const Index& at) {
  using Number = std::decay_t<decltype(q(L::nu))>;
  const Index e = unit(axis), face = I + at;
  const Number& v = q(L::v(axis), at);
  if (scene.barrier(axis, face)) {
    const Condition& condition = scene.condition(axis, face);
    if (condition.kind.stops_solids()) return Number(0.0);
    const double brought = condition.kind.brings_solids() ? condition.brought(SolidsContinuity::unknown) : 0.0;
    const bool above = box_above(scene, axis, face);
    const bool inflow = above ? v >= 0.0 : v < 0.0;
    return inflow ? Number(v * brought) : SolidsContinuity::flux(v, q(L::nu, above ? at : at - e));
  }
  if constexpr (SecondOrder) {
    return SolidsContinuity::flux(v, limited_upwind(v, q(L::nu, at - 2 * e), q(L::nu, at - e), q(L::nu, at),
                                                    q(L::nu, at + e), cell_metrics(scene, axis, face)));
  } else {
    return SolidsContinuity::flux(v, upwind(v, q(L::nu, at - e), q(L::nu, at)));
  }
}

/// Where a cell-centred input at `from` + reach e_axis (reach -2 ... 1 about the lower face of anchor + from) is read:
/// a value beyond a barrier is that of the nearest cell before it, i.e. no slope across barriers.
inline Reference cell_before_barrier(const Scene& scene, const Index& I, int axis, const Index& from, int reach) {
  const Index e = unit(axis);
  if (reach == -2 && scene.barrier(axis, I + from - e)) reach = -1;
  if (reach == 1 && scene.barrier(axis, I + from + e)) reach = 0;
  return {from + reach * e, 1};
}

}  // namespace scree
