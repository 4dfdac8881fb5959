/// Shear stress on the edges of cells, for both momentum balances that it acts on.
#pragma once

#include "scree/kernels/cell_strain.hpp"
#include "scree/kernels/surface_stress.hpp"

namespace scree {

/// sigma_ab of (8) at edge I of axes a < b. It acts on momentum a across the lower b faces of I - e_a and I, and on
/// momentum b across the lower a faces of I - e_b and I; where one of the two faces is a plate only the other half
/// remains, and the wall law acts on the rest. On a side of the box edges carry a stress only where an open part of it
/// is beside: there it acts on the momentum along the normal, whose control volume is the half cell before the side,
/// with all that it depends on as it is in the cells before the side. It is what the lip of an orifice holds back.
template <class L, int a, int b>
struct EdgeStress {
  static constexpr Index e_a = unit(a), e_b = unit(b);
  static constexpr std::array<Index, 4> cells{{-1 * e_a - e_b, Index{} - e_b, Index{} - e_a, Index{}}};

  static constexpr StencilBuilder make_stencil() {
    StencilBuilder s;
    for (const Index& cell : cells) {
      s.add(L::nu, cell);
      s.add(L::T, cell);
      s.add(L::chi, cell);
      s.add(L::g_f, cell);
      for (int axis = 0; axis < L::dim; ++axis) {
        s.add(L::v(axis), cell);
        s.add(L::v(axis), cell + unit(axis));
        if (axis == a || axis == b) continue;
        for (int side = -1; side <= 1; side += 2) {  // D_ac and D_bc on the edges about
          if (cell[a] == 0) s.add(L::v(a), cell + side * unit(axis));
          if (cell[b] == 0) s.add(L::v(b), cell + side * unit(axis));
        }
      }
    }
    add_edge_slip_inputs<L>(s, a, b);
    return s;
  }
  static constexpr StencilBuilder stencil = make_stencil();
  static constexpr std::array<Output, 4> rows{
      {{L::v(a), -1 * e_b}, {L::v(a), Index{}}, {L::v(b), -1 * e_a}, {L::v(b), Index{}}}};
  static constexpr bool depends(int, const Input&) { return true; }

  static bool active(const Scene& scene, const Index& I) {
    if (!scene.near) return true;
    if (on_side_of_axis(scene, a, I) || on_side_of_axis(scene, b, I)) return beside_opening(scene, I);
    for (const Index& cell : cells)
      if (!scene.inside(I + cell)) return false;
    return open_share(scene, I, a, b) > 0 || open_share(scene, I, b, a) > 0;
  }
  /// What lies beyond a side is read before it, velocities along the normal excepted.
  static Reference resolve(const Scene& scene, const Index& I, const Input& input) {
    for (const int normal : {a, b})
      if (on_side_of_axis(scene, normal, I) && input.component != L::v(normal) && input.component != L::u(normal))
        return {before_side(I, normal, input.offset), 1};
    return {input.offset, 1};
  }

  template <class Number, std::size_t count>
  static void evaluate(const Scene& scene, const Index& I, const Local<EdgeStress, Number>& q,
                       std::array<Number, count>& r) {
    const Number D_ab = shear_rate<L>(scene, I, q, a, b, {});
    const Number nu = mean(scene, I, [&](const Index& cell) { return q(L::nu, cell); });
    const auto T = mean(scene, I, [&](const Index& cell) { return temperature_input<L>(q, cell); });
    const auto [div_v, S_S] = strain_invariants(scene, I, q, D_ab, T);
    const auto chi = mean(scene, I, [&](const Index& cell) { return chi_input<L>(q, cell); });
    const auto g_f = mean(scene, I, [&](const Index& cell) { return fluidity_input<L>(q, cell); });
    const auto slip_squared = edge_slip_squared<L>(
        scene, I, q, a, b, nu, [&](int axis, const Index& face) { return before_sides(scene, I, face, axis); });
    const Number p_c = mean(scene, I, [&](const Index& cell) { return pressure_in(scene, I, q, cell); });
    const Number mu = through(
        [&](const auto& nu_, const auto& p_c_, const auto& T_, const auto& chi_, const auto& div_v_, const auto& S_S_,
            const auto& slip_,
            const auto& g_f_) { return edge_closure(nu_, p_c_, T_, chi_, div_v_, S_S_, slip_, g_f_, scene.solids); },
        nu, p_c, T, chi, div_v, S_S, slip_squared, g_f);
    const Number sigma = SolidsMomentum::shear_stress(mu, D_ab);

    const bool near = scene.near;
    const Number on_a = (near ? share_of_stress(scene, I, a, b) : 1.0) * sigma;
    const Number on_b = (near ? share_of_stress(scene, I, b, a) : 1.0) * sigma;
    r[0] += out_of_cell(scene, b, I - e_b, End::upper, on_a);
    r[1] -= out_of_cell(scene, b, I, End::lower, on_a);
    r[2] += out_of_cell(scene, a, I - e_a, End::upper, on_b);
    r[3] -= out_of_cell(scene, a, I, End::lower, on_b);
  }

 private:
  /// The pressure of friction in a cell. An edge takes the mean of its cells, not p_c (18) at their mean nu, which is
  /// nothing beside a partly filled cell: the row at a surface would slide on the bed without friction. Where nu is
  /// smooth the two differ by the square of the cell. A partly filled cell that rests on the one below presses on it.
  template <class Number>
  static Number pressure_in(const Scene& scene, const Index& I, const Local<EdgeStress, Number>& q, const Index& cell) {
    const FrictionParameters& friction = scene.solids.friction;
    if (!friction.model->has_friction) return Number(0.0);
    const Number p_c = critical_pressure(q(L::nu, cell), friction);
    Number p = p_c;
    for (const int axis : {a, b}) {
      const double g = scene.gravity[axis];
      const bool upper = (cell[axis] == 0) == (g < 0);
      if (g == 0 || !upper || on_side_of_axis(scene, axis, I)) continue;
      const Index below = cell + (g < 0 ? -1 : 1) * unit(axis);
      if (scene.barrier(axis, I + (g < 0 ? cell : below))) continue;
      p += resting_excess(p_c, half_weight(scene, I + cell, axis, q(L::nu, cell)),
                          critical_pressure(q(L::nu, below), friction),
                          half_weight(scene, I + below, axis, q(L::nu, below)));
    }
    return p;
  }

  /// Whether the edge lies on one side of the box, between two cells, and an open part of that side is beside it.
  static bool beside_opening(const Scene& scene, const Index& I) {
    if (on_side_of_axis(scene, a, I) && on_side_of_axis(scene, b, I)) return false;
    const int normal = on_side_of_axis(scene, a, I) ? a : b;
    const Index along = unit(normal == a ? b : a);
    if (!scene.is_face(normal, I) || !scene.is_face(normal, I - along)) return false;
    if (share_of_stress(scene, I, normal, normal == a ? b : a) == 0) return false;
    for (const Index& face : {I, I - along})
      if (scene.barrier(normal, face) && scene.kind(normal, face).lets_solids_out()) return true;
    return false;
  }

  /// `at`, a cell relative to the edge, moved from beyond the side of the box that the edge lies on to before it.
  static Index before_side(const Index& I, int normal, const Index& at) {
    const int from = I[normal] == 0 ? 0 : -1;
    const bool beyond = from == 0 ? at[normal] < 0 : at[normal] >= 0;
    return beyond ? at + (from - at[normal]) * unit(normal) : at;
  }

  /// Share of the stress that acts on momentum `axis`: of the face between its control volumes along `across`.
  static double share_of_stress(const Scene& scene, const Index& I, int axis, int across) {
    if (on_side_of_axis(scene, across, I)) return 0;
    if (!on_side_of_axis(scene, axis, I)) return open_share(scene, I, axis, across);
    return scene.barrier(across, I + before_side(I, axis, Index{})) ? 0 : 1;
  }

  /// Open share of the face between the control volumes of momentum `axis` below and above the edge along `across`.
  static double open_share(const Scene& scene, const Index& I, int axis, int across) {
    const double below = scene.lower_share(axis, I);
    return (scene.barrier(across, I - unit(axis)) ? 0 : below) + (scene.barrier(across, I) ? 0 : 1 - below);
  }

  static constexpr int none = -1;

  /// Bilinear interpolation of a cell quantity to the edge. The centre of a wide cell is far: the weights are
  /// crosswise.
  template <class Value>
  static auto mean(const Scene& scene, const Index& I, Value&& value) {
    const double far_a = scene.lower_share(a, I), far_b = scene.lower_share(b, I);
    const auto at = [&](const Index& cell) { return value(before_sides(scene, I, cell, none)); };
    return std::decay_t<decltype(value(Index{}))>((1 - far_a) * (1 - far_b) * at(cells[0]) +
                                                  far_a * (1 - far_b) * at(cells[1]) +
                                                  (1 - far_a) * far_b * at(cells[2]) + far_a * far_b * at(cells[3]));
  }

  /// {div v, S:S} at the edge: D_ab as it is, normal components as means over the four cells, other shear components
  /// as means of the squares over the edges about.
  template <class Number, class Temperature>
  static std::array<Number, 2> strain_invariants(const Scene& scene, const Index& I, const Local<EdgeStress, Number>& q,
                                                 const Number& D_ab, const Temperature& T) {
    Number div_v(0.0);
    StrainComponents<Number, component_count> S;
    S.add(D_ab, 2);
    for (int axis = 0; axis < L::dim; ++axis) {
      const Number D = mean(scene, I, [&](const Index& cell) {
        return difference_in_cell(scene, axis, I + cell, q(L::v(axis), cell), q(L::v(axis), cell + unit(axis)));
      });
      div_v += D;
      S.add(D, 1);
      if constexpr (L::dim > 2)
        if (axis != a && axis != b) add_other_shear(scene, I, q, axis, S);
    }
    S.add(div_v, -1.0 / 3);
    return {div_v, square_of_strain(scene, S, T, I, [](NewtonTangent& t) { return &t.edges[3 - a - b]; })};
  }

  /// The most components of S at an edge: D_ab, D_aa, div v and D_ac, D_bc on the edges about.
  static constexpr std::size_t component_count = L::dim + 2 + (L::dim > 2 ? 8 : 0);

  /// Whether a barrier is on the lower `c` face of cell I + at, or of the cell before the side that the edge lies on.
  static bool shut(const Scene& scene, const Index& I, int c, const Index& at) {
    return scene.barrier(c, I + before_sides(scene, I, at, c));
  }

  /// `at` moved before the sides that the edge lies on, but not along axis `kept`.
  static Index before_sides(const Scene& scene, const Index& I, Index at, int kept) {
    if (!scene.near) return at;
    if (a != kept && on_side_of_axis(scene, a, I)) at = before_side(I, a, at);
    if (b != kept && on_side_of_axis(scene, b, I)) at = before_side(I, b, at);
    return at;
  }

  /// D_ac and D_bc, c being the axis along the edge; edges on barriers count with zero.
  template <class Number>
  static void add_other_shear(const Scene& scene, const Index& I, const Local<EdgeStress, Number>& q, int c,
                              StrainComponents<Number, component_count>& S) {
    for (int side = 0; side < 2; ++side)
      for (int back = 0; back < 2; ++back) {
        const auto add = [&](int axis, const Index& at) {
          if (shut(scene, I, c, at) || shut(scene, I, c, at - unit(axis))) return;
          S.add(shear_rate<L>(scene, I, q, axis, c, at), 0.5);
        };
        add(a, side * unit(c) - back * e_b);
        add(b, side * unit(c) - back * e_a);
      }
  }
};

}  // namespace scree
