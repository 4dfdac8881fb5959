/// Advection of particle momentum, rho_s nu v.grad v of (3): fluxes through the faces of the staggered control volumes,
/// carried by the mean of the mass fluxes of the two cells that a control volume spans.
#pragma once

#include "scree/equations/layout.hpp"
#include "scree/equations/mass_flux.hpp"

namespace scree {

/// Momentum `axis` carried along the same axis. Anchor I: the centre of cell I, between its two `axis` faces.
template <class L, bool SecondOrder, int axis>
struct NormalMomentumFlux {
  static constexpr Index e = unit(axis);
  static constexpr StencilBuilder make_stencil() {
    StencilBuilder s;
    for (int reach = SecondOrder ? -1 : 0; reach <= (SecondOrder ? 2 : 1); ++reach) s.add(L::v(axis), reach * e);
    add_mass_flux_inputs<L, SecondOrder>(s, axis, {});
    add_mass_flux_inputs<L, SecondOrder>(s, axis, e);
    return s;
  }
  static constexpr StencilBuilder stencil = make_stencil();
  static constexpr std::array<Output, 2> rows{{{L::v(axis), Index{}}, {L::v(axis), e}}};
  static constexpr bool depends(int, const Input&) { return true; }

  static bool active(const Scene& scene, const Index& I) { return scene.lattice.inside(I); }
  static Reference resolve(const Scene& scene, const Index& I, const Input& input) {
    const Barriers& b = scene.barriers;
    const int reach = input.offset[axis];
    if (L::is_velocity(input.component)) {
      if (reach == -1 && b.at(axis, I)) return beyond(b.condition(axis, I), 0, 1);
      if (reach == 2 && b.at(axis, I + e)) return beyond(b.condition(axis, I + e), 1, 0);
      return {input.offset, 1};
    }
    if (reach < 0 && b.at(axis, I)) return {Index{}, 1};
    if (reach > 0 && b.at(axis, I + e)) return {Index{}, 1};
    if (reach == -2 && b.at(axis, I - e)) return {-1 * e, 1};
    if (reach == 2 && b.at(axis, I + 2 * e)) return {e, 1};
    return {input.offset, 1};
  }

  template <class Number, std::size_t count>
  static void evaluate(const Scene& scene, const Index& I, const Local<NormalMomentumFlux, Number>& q,
                       std::array<Number, count>& r) {
    const double rho_s = scene.solids.kinetic.rho_s;
    const Axis& x = scene.axis(axis);
    const int i = I[axis];
    const Number F =
        0.5 * (mass_flux<L, SecondOrder>(scene, I, q, axis, {}) + mass_flux<L, SecondOrder>(scene, I, q, axis, e));
    const Number &below = q(L::v(axis)), &above = q(L::v(axis), e);
    Number carried;
    if constexpr (SecondOrder) {
      const Barriers& barrier = scene.barriers;  // what is mirrored at a plate lies a width of this cell beyond it
      const double far_lower = x.width(barrier.at(axis, I) ? i : i - 1);
      const double far_upper = x.width(barrier.at(axis, I + e) ? i : i + 1);
      const AdvectionMetrics h{far_lower, x.width(i), far_upper, 0.5 * x.width(i), 0.5 * x.width(i)};
      carried = limited_upwind(F, q(L::v(axis), -1 * e), below, above, q(L::v(axis), 2 * e), h);
    } else {
      carried = upwind(F, below, above);
    }
    r[0] += rho_s * F * (carried - below) / x.distance(i);
    r[1] -= rho_s * F * (carried - above) / x.distance(i + 1);
  }

 private:
  /// The normal velocity beyond a face: odd about a wall at rest, constant otherwise.
  static Reference beyond(const Condition& condition, int at_face, int mirrored) {
    if (is_wall(condition.kind) && condition.velocity[axis] == 0) return {mirrored * e, -1};
    return {at_face * e, 1};
  }
};

/// Momentum `axis` carried along another axis, `across`. Anchor I: edge I of the two axes.
template <class L, bool SecondOrder, int axis, int across>
struct CrossMomentumFlux {
  static constexpr Index a = unit(axis), b = unit(across);
  static constexpr StencilBuilder make_stencil() {
    StencilBuilder s;
    for (int reach = SecondOrder ? -2 : -1; reach <= (SecondOrder ? 1 : 0); ++reach) s.add(L::v(axis), reach * b);
    add_mass_flux_inputs<L, SecondOrder>(s, across, {});
    add_mass_flux_inputs<L, SecondOrder>(s, across, -1 * a);
    return s;
  }
  static constexpr StencilBuilder stencil = make_stencil();
  static constexpr std::array<Output, 2> rows{{{L::v(axis), -1 * b}, {L::v(axis), Index{}}}};
  static constexpr bool depends(int, const Input&) { return true; }

  static bool active(const Scene& scene, const Index& I) {
    return scene.lattice.is_face(across, I) && scene.lattice.is_face(across, I - a) &&
           !(scene.barriers.wall(across, I) && scene.barriers.wall(across, I - a));
  }
  static Reference resolve(const Scene& scene, const Index& I, const Input& input) {
    const int reach = input.offset[across];
    if (input.component == L::v(across)) return {input.offset, 1};
    if (input.component == L::nu) {
      const Index column = input.offset - reach * b;
      return cell_before_barrier(scene, I, across, column, reach);
    }
    const auto blocked = [&](const Index& face) {
      return scene.barriers.at(across, face) || scene.barriers.at(across, face - a);
    };
    if (reach == -2 && blocked(I - b)) return {-1 * b, 1};
    if (reach == 1 && blocked(I + b)) return {Index{}, 1};
    return {input.offset, 1};
  }

  template <class Number, std::size_t count>
  static void evaluate(const Scene& scene, const Index& I, const Local<CrossMomentumFlux, Number>& q,
                       std::array<Number, count>& r) {
    const double rho_s = scene.solids.kinetic.rho_s;
    const Number &below = q(L::v(axis), -1 * b), &above = q(L::v(axis));
    const Axis& x = scene.axis(across);
    if (!scene.lattice.inside(I - b)) {
      r[1] -= rho_s * brought_in(scene, I, q, above) / x.width(I[across]);
    } else if (!scene.lattice.inside(I)) {
      r[0] += rho_s * brought_in(scene, I, q, below) / x.width(I[across] - 1);
    } else {
      const Number F = face_mean(scene, axis, I, mass_flux<L, SecondOrder>(scene, I, q, across, -1 * a),
                                 mass_flux<L, SecondOrder>(scene, I, q, across, {}));
      const Number v = carried(scene, I, q, F);
      r[0] += rho_s * F * (v - below) / x.width(I[across] - 1);
      r[1] -= rho_s * F * (v - above) / x.width(I[across]);
    }
  }

 private:
  /// F (v - own) through a side of the box, `own` being the velocity before it: each half of the face brings the
  /// velocity of its own condition, and what leaves takes that of the box along.
  template <class Number>
  static Number brought_in(const Scene& scene, const Index& I, const Local<CrossMomentumFlux, Number>& q,
                           const Number& own) {
    const auto half = [&](const Index& at) {
      const Condition& condition = scene.barriers.condition(across, I + at);
      const Number F = mass_flux<L, SecondOrder>(scene, I, q, across, at);
      const bool inflow = box_above(scene, across, I) ? F >= 0.0 : F < 0.0;
      if (!inflow || condition.kind != BoundaryKind::inlet) return Number(0.0);
      return Number(F * (condition.velocity[axis] - own));
    };
    return face_mean(scene, axis, I, half(-1 * a), half({}));
  }

  /// The velocity that the flux F carries between two cells.
  template <class Number>
  static Number carried(const Scene& scene, const Index& I, const Local<CrossMomentumFlux, Number>& q,
                        const Number& F) {
    const Number &below = q(L::v(axis), -1 * b), &above = q(L::v(axis));
    if constexpr (SecondOrder) {
      return limited_upwind(F, q(L::v(axis), -2 * b), below, above, q(L::v(axis), b),
                            cell_metrics(scene.axis(across), I[across]));
    } else {
      return upwind(F, below, above);
    }
  }
};

}  // namespace scree
