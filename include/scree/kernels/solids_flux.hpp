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

/// The slope along `axis` of a quantity of the particles in a cell, out of whose face `End end` it is carried. `own`:
/// its value there, `far`: that in the cell beyond the other face, `far_distance` away, `middle`: the slope across
/// `end`. Beside an inlet the far value is the one that is brought in; beside other sides there is none.
template <class Number>
Number slope_in_cell(const Scene& scene, int axis, const Index& cell, End end, const Unknown& unknown,
                     const Number& own, const Number& far, double far_distance, const Number& middle) {
  const double sign = end == End::upper ? 1 : -1;
  const Index far_face = end == End::upper ? cell : cell + unit(axis);
  if (!scene.barrier(axis, far_face)) return van_albada(Number(sign * (own - far) / far_distance), middle);
  const double reach = 0.5 * scene.axis(axis).width(cell[axis]);
  const Condition& condition = scene.condition(axis, far_face);
  if (condition.kind.brings_solids())
    return van_albada(Number(sign * (own - condition.brought(unknown)) / reach), middle);
  return one_sided_slope(middle, Number((own < 0.0 ? Number(-own) : own) / reach));
}

/// The value of a quantity of the particles that a flow carries through the lower `axis` face of I, which is no
/// barrier, to second order. `far_lower` to `far_upper`: its values in the cells I - 2 to I + 1 along the axis.
template <class Number>
[[gnu::flatten, gnu::noinline]] Number carried_through(const Scene& scene, int axis, const Index& I,
                                                       const Unknown& unknown, double flow, const Number& far_lower,
                                                       const Number& lower, const Number& upper,
                                                       const Number& far_upper) {
  const AdvectionMetrics h = cell_metrics(scene, axis, I);
  const auto slope = [&](const Index& cell, End end, const Number& own, const Number& far, double far_distance,
                         const Number& middle) {
    return slope_in_cell(scene, axis, cell, end, unknown, own, far, far_distance, middle);
  };
  return along_slope(
      flow, lower, upper, h,
      [&](const Number& middle) { return slope(I - unit(axis), End::upper, lower, far_lower, h.far_lower, middle); },
      [&](const Number& middle) { return slope(I, End::lower, upper, far_upper, h.far_upper, middle); });
}

/// The same with the values as they stand among the inputs of a kernel.
template <class Q>
[[gnu::always_inline]] inline auto carried_input(const Scene& scene, int axis, const Index& I, const Unknown& unknown,
                                                 double flow, const Q& q, int component, const Index& at) {
  const Index e = unit(axis);
  return through([&](const auto&... value) { return carried_through(scene, axis, I, unknown, flow, value...); },
                 q(component, at - 2 * e), q(component, at - e), q(component, at), q(component, at + e));
}
/// On how many inputs the value that is carried depends.
constexpr int carried_terms(bool second_order) { return second_order ? 4 : 1; }

/// Whether a flow through the lower `axis` face of I, on a side of the box, comes in. None at all counts as one along
/// +axis, as for upwind.
inline bool comes_in(const Scene& scene, int axis, const Index& I, double flow) {
  return box_above(scene, axis, I) ? flow >= 0 : flow < 0;
}

/// nu v at the lower `axis` face of I, a barrier: 0 at walls; through sides the upstream value of cell or condition.
template <class Number>
[[gnu::noinline]] auto flux_through_barrier(const Scene& scene, int axis, const Index& I, const Number& v,
                                            const Number& below, const Number& above) {
  using Flux = decltype(SolidsContinuity::flux(v, above));
  const Condition& condition = scene.condition(axis, I);
  if (condition.kind.stops_solids()) return Flux(0.0);
  if (!comes_in(scene, axis, I, value_of(v)))
    return SolidsContinuity::flux(v, box_above(scene, axis, I) ? above : below);
  return Flux(v * (condition.kind.brings_solids() ? condition.brought(SolidsContinuity::unknown) : 0.0));
}

/// nu v at the lower `axis` face of I + at [m/s]: 0 at walls; through sides the upstream value of cell or condition.
template <class L, bool SecondOrder, class Q>
[[gnu::always_inline]] inline auto solids_flux(const Scene& scene, const Index& I, const Q& q, int axis,
                                               const Index& at) {
  using Flux = typename Q::template Few<1 + carried_terms(SecondOrder)>;
  const Index e = unit(axis), face = I + at;
  const auto v = q(L::v(axis), at);
  if (scene.barrier(axis, face))
    return Flux(flux_through_barrier(scene, axis, face, v, q(L::nu, at - e), q(L::nu, at)));
  if constexpr (SecondOrder)
    return Flux(SolidsContinuity::flux(
        v, carried_input(scene, axis, face, SolidsContinuity::unknown, value_of(v), q, L::nu, at)));
  else
    return Flux(SolidsContinuity::flux(v, upwind(v, q(L::nu, at - e), q(L::nu, at))));
}

/// Where a cell-centred input at `from` + reach e_axis (reach -2 ... 1 about the lower face of anchor + from) is read:
/// not beyond a barrier but in the nearest cell before it.
inline Reference cell_before_barrier(const Scene& scene, const Index& I, int axis, const Index& from, int reach) {
  const Index e = unit(axis);
  if (reach == -2 && scene.barrier(axis, I + from - e)) reach = -1;
  if (reach == 1 && scene.barrier(axis, I + from + e)) reach = 0;
  return {from + reach * e, 1};
}

}  // namespace scree
