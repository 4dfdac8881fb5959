/// Advection of momentum, rho_s nu v.grad v of (3) and rho_g (1-nu) u.grad u of (4): fluxes through the faces of the
/// staggered control volumes, carried by the mean of the volume fluxes of the two cells that a control volume spans.
#pragma once

#include "scree/kernels/gas_flux.hpp"

namespace scree {

/// The particles as a phase that carries momentum.
template <class L, bool SecondOrder>
struct ParticlePhase {
  using Balance = SolidsMomentum;
  static constexpr int dim = L::dim, nu = L::nu;
  static constexpr bool second_order = SecondOrder;
  static constexpr int velocity(int axis) { return L::v(axis); }
  static double density(const Scene& scene) { return scene.solids.kinetic.rho_s; }
  static constexpr void add_flux_inputs(StencilBuilder& s, int axis, const Index& at) {
    add_solids_flux_inputs<L, SecondOrder>(s, axis, at);
  }
  template <class Q>
  static auto flux(const Scene& scene, const Index& I, const Q& q, int axis, const Index& at) {
    return solids_flux<L, SecondOrder>(scene, I, q, axis, at);
  }
  static bool stops(const BoundaryKind& kind) { return kind.stops_solids(); }
  static bool brings(const BoundaryKind& kind) { return kind.brings_solids(); }
  /// Component `axis` of the velocity with which the lower `across` face of I lets the phase in.
  static double brought(const Scene& scene, int axis, int across, const Index& I) {
    return prescribed_velocity(scene, axis, across, I);
  }
  static constexpr bool enters_from_rest = false;  // particles fall in as they fell before
};

/// The gas as such a phase.
template <class L, bool SecondOrder>
struct GasPhase {
  using Balance = GasMomentum;
  static constexpr int dim = L::dim, nu = L::nu;
  static constexpr bool second_order = SecondOrder;
  static constexpr int velocity(int axis) { return L::u(axis); }
  static double density(const Scene& scene) { return scene.gas().rho_g; }
  static constexpr void add_flux_inputs(StencilBuilder& s, int axis, const Index& at) {
    add_gas_flux_inputs<L>(s, axis, at);
  }
  template <class Q>
  static auto flux(const Scene& scene, const Index& I, const Q& q, int axis, const Index& at) {
    return gas_flux<L>(scene, I, q, axis, at);
  }
  static bool stops(const BoundaryKind& kind) { return kind.stops_gas(); }
  static bool brings(const BoundaryKind& kind) { return kind.brings_gas(); }
  static double brought(const Scene&, int, int, const Index&) { return 0; }  // inlets blow straight in
  static constexpr bool enters_from_rest = true;  // through open sides, from still gas outside
};

/// limited_upwind with the velocities as they stand among the inputs of a kernel.
template <class Flux, class Far, class Value>
[[gnu::always_inline]] inline auto carried_with_slope(const Flux& F, const Far& far_below, const Value& below,
                                                      const Value& above, const Far& far_above,
                                                      const AdvectionMetrics& h) {
  return through(
      [&](const auto& far_below_, const auto& below_, const auto& above_, const auto& far_above_) {
        return limited_upwind(value_of(F), far_below_, below_, above_, far_above_, h);
      },
      far_below, below, above, far_above);
}

/// Momentum `axis` carried along the same axis. Anchor I: the centre of cell I, between its two `axis` faces.
template <class Phase, int axis>
struct NormalMomentumFlux {
  static constexpr Index e = unit(axis);
  static constexpr StencilBuilder make_stencil() {
    StencilBuilder s;
    for (int reach = Phase::second_order ? -1 : 0; reach <= (Phase::second_order ? 2 : 1); ++reach)
      s.add(Phase::velocity(axis), reach * e);
    Phase::add_flux_inputs(s, axis, {});
    Phase::add_flux_inputs(s, axis, e);
    return s;
  }
  static constexpr StencilBuilder stencil = make_stencil();
  static constexpr std::array<Output, 2> rows{{{Phase::velocity(axis), Index{}}, {Phase::velocity(axis), e}}};
  static constexpr bool depends(int, const Input&) { return true; }

  static bool active(const Scene& scene, const Index& I) { return scene.inside(I); }
  static Reference resolve(const Scene& scene, const Index& I, const Input& input) {
    const Barriers& b = scene.barriers;
    const int reach = input.offset[axis];
    if (input.component == Phase::velocity(axis)) {
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
  [[gnu::flatten]] static void evaluate(const Scene& scene, const Index& I, const Local<NormalMomentumFlux, Number>& q,
                                        std::array<Number, count>& r) {
    using Balance = typename Phase::Balance;
    const double rho = Phase::density(scene);
    const Number F = 0.5 * (Phase::flux(scene, I, q, axis, {}) + Phase::flux(scene, I, q, axis, e));
    const auto below = q(Phase::velocity(axis)), above = q(Phase::velocity(axis), e);
    const auto carried = carried_by(scene, I, q, F, below, above);
    r[0] += out_of_control_volume(scene, axis, I, End::upper, Balance::advection(rho, F, carried, below));
    r[1] -= out_of_control_volume(scene, axis, I + e, End::lower, Balance::advection(rho, F, carried, above));
    if constexpr (Phase::enters_from_rest) {
      // What is accelerated from rest outside has lost rho u^2/2 of pressure at an open side. Without that eddies which
      // reach through the side feed on themselves.
      if (lets_in_from_rest(scene, I)) {
        const Number inflow = positive(Phase::flux(scene, I, q, axis, {}));
        r[0] += out_of_control_volume(scene, axis, I, End::upper, Balance::entry_loss(rho, inflow, below));
      }
      if (lets_in_from_rest(scene, I + e)) {
        const Number inflow = positive(Number(-Phase::flux(scene, I, q, axis, e)));
        r[1] += out_of_control_volume(scene, axis, I + e, End::lower, Balance::entry_loss(rho, inflow, above));
      }
    }
  }

 private:
  /// The velocity that the flux F carries through the middle of the cell.
  template <class Q, class Flux, class Value>
  static auto carried_by(const Scene& scene, const Index& I, const Q& q, const Flux& F, const Value& below,
                         const Value& above) {
    if constexpr (Phase::second_order) {
      const AdvectionMetrics h = face_metrics(scene, axis, I, scene.barrier(axis, I), scene.barrier(axis, I + e));
      auto far_below = 2.0 * below - above, far_above = 2.0 * above - below;
      // What comes in is given at the face: the line through both goes on beyond it.
      if (!comes_in(scene, I)) far_below = q(Phase::velocity(axis), -1 * e);
      if (!comes_in(scene, I + e)) far_above = q(Phase::velocity(axis), 2 * e);
      return carried_with_slope(F, far_below, below, above, far_above, h);
    } else {
      return Value(upwind(F, below, above));
    }
  }
  [[gnu::noinline]] static bool comes_in(const Scene& scene, const Index& face) {
    return scene.barrier(axis, face) && Phase::brings(scene.kind(axis, face));
  }
  [[gnu::noinline]] static bool lets_in_from_rest(const Scene& scene, const Index& face) {
    if (!scene.barrier(axis, face)) return false;
    const Condition& condition = scene.condition(axis, face);
    return condition.kind.open_to_gas() && condition.gas_enters_at_rest;
  }
  template <class Number>
  static Number positive(const Number& x) {
    return x > 0.0 ? x : Number(0.0);
  }
  /// The normal velocity beyond a face: odd about a wall at rest, constant otherwise.
  static Reference beyond(const Condition& condition, int at_face, int mirrored) {
    if (Phase::stops(condition.kind) && condition.velocity[axis] == 0) return {mirrored * e, -1};
    return {at_face * e, 1};
  }
};

/// Momentum `axis` carried along another axis, `across`. Anchor I: edge I of the two axes.
template <class Phase, int axis, int across>
struct CrossMomentumFlux {
  static constexpr Index a = unit(axis), b = unit(across);
  static constexpr StencilBuilder make_stencil() {
    StencilBuilder s;
    for (int reach = Phase::second_order ? -2 : -1; reach <= (Phase::second_order ? 1 : 0); ++reach)
      s.add(Phase::velocity(axis), reach * b);
    Phase::add_flux_inputs(s, across, {});
    Phase::add_flux_inputs(s, across, -1 * a);
    return s;
  }
  static constexpr StencilBuilder stencil = make_stencil();
  static constexpr std::array<Output, 2> rows{{{Phase::velocity(axis), -1 * b}, {Phase::velocity(axis), Index{}}}};
  static constexpr bool depends(int, const Input&) { return true; }

  static bool active(const Scene& scene, const Index& I) {
    const auto closed = [&](const Index& face) {
      return scene.barrier(across, face) && Phase::stops(scene.kind(across, face));
    };
    return scene.is_face(across, I) && scene.is_face(across, I - a) && !(closed(I) && closed(I - a));
  }
  static Reference resolve(const Scene& scene, const Index& I, const Input& input) {
    const int reach = input.offset[across];
    if (input.component == Phase::velocity(across)) return {input.offset, 1};
    if (input.component == Phase::nu) {
      const Index column = input.offset - reach * b;
      return cell_before_barrier(scene, I, across, column, reach);
    }
    const auto blocked = [&](const Index& face) {
      return scene.barrier(across, face) || scene.barrier(across, face - a);
    };
    if (reach == -2 && blocked(I - b)) return {-1 * b, 1};
    if (reach == 1 && blocked(I + b)) return {Index{}, 1};
    return {input.offset, 1};
  }

  template <class Number, std::size_t count>
  [[gnu::flatten]] static void evaluate(const Scene& scene, const Index& I, const Local<CrossMomentumFlux, Number>& q,
                                        std::array<Number, count>& r) {
    using Balance = typename Phase::Balance;
    const double rho = Phase::density(scene);
    const auto below = q(Phase::velocity(axis), -1 * b), above = q(Phase::velocity(axis));
    if (!scene.inside(I - b)) {
      r[1] -= out_of_cell(scene, across, I, End::lower, rho * brought_in(scene, I, q, above));
    } else if (!scene.inside(I)) {
      r[0] += out_of_cell(scene, across, I - b, End::upper, rho * brought_in(scene, I, q, below));
    } else {
      const Number F =
          face_mean(scene, axis, I, Phase::flux(scene, I, q, across, -1 * a), Phase::flux(scene, I, q, across, {}));
      const auto v = carried(scene, I, q, F);
      r[0] += out_of_cell(scene, across, I - b, End::upper, Balance::advection(rho, F, v, below));
      r[1] -= out_of_cell(scene, across, I, End::lower, Balance::advection(rho, F, v, above));
    }
  }

 private:
  /// F (v - own) through a side of the box, `own` being the velocity before it: each half of the face brings the
  /// velocity of its own condition, and what leaves takes that of the box along.
  template <class Number, class Value>
  [[gnu::noinline]] static Number brought_in(const Scene& scene, const Index& I,
                                             const Local<CrossMomentumFlux, Number>& q, const Value& own) {
    const auto half = [&](const Index& at) {
      const Condition& condition = scene.condition(across, I + at);
      const auto F = Phase::flux(scene, I, q, across, at);
      if (!Phase::brings(condition.kind) || !scree::comes_in(scene, across, I, value_of(F))) return Number(0.0);
      return Number(F * (Phase::brought(scene, axis, across, I + at) - own));
    };
    return face_mean(scene, axis, I, half(-1 * a), half({}));
  }

  /// Whether both halves of the edge's side at `face` bring in a velocity of their own.
  [[gnu::noinline]] static bool comes_in(const Scene& scene, const Index& face) {
    const auto brings = [&](const Index& half) {
      return scene.barrier(across, half) && Phase::brings(scene.kind(across, half));
    };
    return brings(face) && brings(face - a);
  }
  [[gnu::noinline]] static double brought_at(const Scene& scene, const Index& face) {
    return face_mean(scene, axis, face, Phase::brought(scene, axis, across, face - a),
                     Phase::brought(scene, axis, across, face));
  }
  /// The velocity that the flux F carries between two cells.
  template <class Q, class Flux>
  static auto carried(const Scene& scene, const Index& I, const Q& q, const Flux& F) {
    const auto below = q(Phase::velocity(axis), -1 * b), above = q(Phase::velocity(axis));
    if constexpr (Phase::second_order) {
      AdvectionMetrics h = cell_metrics(scene, across, I);
      auto far_below = q(Phase::velocity(axis), -2 * b), far_above = q(Phase::velocity(axis), b);
      if (comes_in(scene, I - b)) far_below = brought_at(scene, I - b), h.far_lower = h.lower_reach;
      if (comes_in(scene, I + b)) far_above = brought_at(scene, I + b), h.far_upper = h.upper_reach;
      return carried_with_slope(F, far_below, below, above, far_above, h);
    } else {
      return std::decay_t<decltype(below)>(upwind(F, below, above));
    }
  }
};

}  // namespace scree
