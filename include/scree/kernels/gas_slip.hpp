/// |u - v|^2 at cells, faces and edges, for drag and for what it does to the granular temperature: from the velocities
/// where u is an unknown, from the gradient of p_g where it is not (gas darcy).
#pragma once

#include "scree/assembly/kernel.hpp"
#include "scree/assembly/scene.hpp"
#include "scree/balances/layout.hpp"
#include "scree/closures/drag.hpp"

namespace scree {

// ---- the gradient of p_g ----

/// d p_g/d axis at the lower `axis` face of I + at [Pa/m]: 0 across walls and inlets, where no balance asks for it;
/// towards the pressure outside at an open side. Along periodic axes the given mean gradient comes on top of that of
/// p_g, which is periodic.
template <class L, class Q>
[[gnu::always_inline]] inline auto pressure_gradient(const Scene& scene, const Index& I, const Q& q, int axis,
                                                     const Index& at) {
  using Gradient = typename Q::template Few<2>;
  const Index face = I + at;
  if (scene.barrier(axis, face)) {
    const Condition& condition = scene.condition(axis, face);
    if (condition.kind.gas_pressure != GasPressure::prescribed) return Gradient(0.0);
    const double outside = condition.gas_pressure;
    return box_above(scene, axis, face)
               ? Gradient(difference_to_side(scene, axis, face, outside, q(L::p, at)))
               : Gradient(difference_to_side(scene, axis, face, q(L::p, at - unit(axis)), outside));
  }
  return Gradient(scene.model.mean_pressure_gradient[axis] +
                  difference_at_face(scene, axis, face, q(L::p, at - unit(axis)), q(L::p, at)));
}

/// Inputs of pressure_gradient_squared at the lower `axis` face of anchor + at.
template <class L>
constexpr void add_pressure_gradient_inputs(StencilBuilder& s, int axis, const Index& at) {
  for (const Index& cell : {at - unit(axis), at}) {
    s.add(L::p, cell);
    for (int b = 0; b < L::dim; ++b)
      for (int side = -1; side <= 1; side += 2)
        if (b != axis) s.add(L::p, cell + side * unit(b));
  }
}

/// Component b of grad p_g in cell I + at: the mean of its two faces, or that of one where the other lets gas in.
template <class L, class Q>
auto cell_gradient(const Scene& scene, const Index& I, const Q& q, int b, const Index& at) {
  const auto lower = pressure_gradient<L>(scene, I, q, b, at),
             upper = pressure_gradient<L>(scene, I, q, b, at + unit(b));
  const auto is_inlet = [&](const Index& face) { return scene.barrier(b, face) && scene.kind(b, face).brings_gas(); };
  const double share = is_inlet(I + at) ? 0 : is_inlet(I + at + unit(b)) ? 1 : 0.5;
  return share * lower + (1 - share) * upper;
}

/// |grad p_g|^2 at the lower `axis` face of I + at: other components are means over the cells about it.
template <class L, class Q>
auto pressure_gradient_squared(const Scene& scene, const Index& I, const Q& q, int axis, const Index& at) {
  const auto own = pressure_gradient<L>(scene, I, q, axis, at);
  typename Q::Number sum = square(own);
  const bool below = scene.inside(I + at - unit(axis)), above = scene.inside(I + at);
  for (int b = 0; b < L::dim; ++b) {
    if (b == axis) continue;
    typename Q::Number g(0.0);
    if (below) g += (above ? 0.5 : 1.0) * cell_gradient<L>(scene, I, q, b, at - unit(axis));
    if (above) g += (below ? 0.5 : 1.0) * cell_gradient<L>(scene, I, q, b, at);
    sum += square(g);
  }
  return sum;
}

/// |u - v|^2 that balances a gradient of p_g.
template <class Fraction, class Number>
auto slip_squared_of_gradient(const Scene& scene, const Fraction& nu, const Number& gradient_squared) {
  return through(
      [&](const auto& nu_, const auto& squared) {
        return darcy_slip_squared(nu_, squared, scene.model.darcy_solids_fraction, scene.solids.kinetic.d, scene.gas());
      },
      nu, gradient_squared);
}

// ---- |u - v|^2 at the anchor cell ----

template <class L>
constexpr void add_cell_slip_inputs(StencilBuilder& s) {
  for (int a = 0; a < L::dim; ++a)
    for (int side = -1; side <= 1; ++side) {
      if (side >= 0) s.add(L::u(a), side * unit(a));
      if (L::has_gas && !L::has_u) s.add(L::p, side * unit(a));
    }
}

/// u_a - v_a at the lower a face of anchor + at.
template <class L, class Q>
auto gas_slip(const Q& q, int a, const Index& at) {
  return q(L::u(a), at) - q(L::v(a), at);
}

/// |u - v|^2 in cell I, nu being its solids fraction; a plain 0 without gas.
template <class L, class Q>
auto cell_slip_squared(const Scene& scene, const Index& I, const Q& q) {
  if constexpr (!L::has_gas) {
    return 0.0;
  } else {
    typename Q::Number sum(0.0);
    for (int a = 0; a < L::dim; ++a) {
      if constexpr (L::has_u)
        sum += square(0.5 * (gas_slip<L>(q, a, {}) + gas_slip<L>(q, a, unit(a))));
      else
        sum += square(cell_gradient<L>(scene, I, q, a, {}));
    }
    if constexpr (L::has_u)
      return sum;
    else
      return slip_squared_of_gradient(scene, q(L::nu), sum);
  }
}

// ---- |u - v|^2 at the lower `axis` face of the anchor, between two cells ----

template <class L>
constexpr void add_face_slip_inputs(StencilBuilder& s, int axis) {
  if (!L::has_gas) return;
  if (!L::has_u) return add_pressure_gradient_inputs<L>(s, axis, {});
  s.add(L::u(axis), {});
  s.add(L::v(axis), {});
  for (int b = 0; b < L::dim; ++b)
    for (int side = 0; side < 2 && b != axis; ++side)
      for (int back = 0; back < 2; ++back) {
        s.add(L::u(b), side * unit(b) - back * unit(axis));
        s.add(L::v(b), side * unit(b) - back * unit(axis));
      }
}

template <class L, class Q, class Number>
auto face_slip_squared(const Scene& scene, const Index& I, const Q& q, int axis, const Number& nu) {
  if constexpr (!L::has_gas) {
    return 0.0;
  } else if constexpr (!L::has_u) {
    return slip_squared_of_gradient(scene, nu, pressure_gradient_squared<L>(scene, I, q, axis, Index{}));
  } else {
    typename Q::Number sum = square(gas_slip<L>(q, axis, {}));
    for (int b = 0; b < L::dim; ++b) {
      if (b == axis) continue;
      typename Q::Number w(0.0);
      for (int side = 0; side < 2; ++side)
        for (int back = 0; back < 2; ++back) w += 0.25 * gas_slip<L>(q, b, side * unit(b) - back * unit(axis));
      sum += square(w);
    }
    return sum;
  }
}

// ---- |u - v|^2 at the edge of axes a, b of the anchor, between four cells ----

template <class L>
constexpr void add_edge_slip_inputs(StencilBuilder& s, int a, int b) {
  if (!L::has_gas) return;
  const Index cells[4] = {-1 * unit(a) - unit(b), Index{} - unit(b), Index{} - unit(a), Index{}};
  if (L::has_u)
    for (const Index& at : {Index{}, Index{} - unit(b)}) s.add(L::u(a), at);
  if (L::has_u)
    for (const Index& at : {Index{}, Index{} - unit(a)}) s.add(L::u(b), at);
  for (const Index& cell : cells) {
    if (!L::has_u) s.add(L::p, cell);
    for (int c = 0; c < L::dim; ++c) {
      if (c == a || c == b) continue;
      for (int side = -1; side <= 1; ++side) {
        if (side >= 0) s.add(L::u(c), cell + side * unit(c));
        if (!L::has_u) s.add(L::p, cell + side * unit(c));
      }
    }
  }
}

/// `before` moves a face of an axis, relative to the anchor, from beyond a side that the edge lies on to before it, for
/// the conditions there; inputs are read there anyway.
template <class L, class Q, class Number, class Before>
auto edge_slip_squared(const Scene& scene, const Index& I, const Q& q, int a, int b, const Number& nu,
                       Before&& before) {
  if constexpr (!L::has_gas) {
    return 0.0;
  } else {
    typename Q::Number sum(0.0);
    const auto component = [&](int axis, const Index& face) {
      if constexpr (L::has_u)
        return gas_slip<L>(q, axis, face);
      else
        return pressure_gradient<L>(scene, I, q, axis, before(axis, face));
    };
    for (int c = 0; c < L::dim; ++c) {
      typename Q::Number w(0.0);
      if (c == a || c == b) {
        const Index across = unit(c == a ? b : a);
        w += 0.5 * (component(c, Index{}) + component(c, Index{} - across));
      } else {
        for (const Index& cell : {-1 * unit(a) - unit(b), Index{} - unit(b), Index{} - unit(a), Index{}})
          w += 0.125 * (component(c, cell) + component(c, cell + unit(c)));
      }
      sum += square(w);
    }
    if constexpr (L::has_u)
      return sum;
    else
      return slip_squared_of_gradient(scene, nu, sum);
  }
}

}  // namespace scree
