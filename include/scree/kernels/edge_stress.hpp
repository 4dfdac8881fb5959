/// Shear stress on the edges of cells, for both momentum balances that it acts on.
#pragma once

#include <utility>

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
  [[gnu::flatten]] static void evaluate(const Scene& scene, const Index& I, const Local<EdgeStress, Number>& q,
                                        std::array<Number, count>& r) {
    const auto D_ab = shear_rate<L>(scene, I, q, a, b, {});
    const auto nu = mean(scene, I, [&](const Index& cell) { return q(L::nu, cell); });
    const auto T = mean(scene, I, [&](const Index& cell) { return temperature_input<L>(q, cell); });
    const auto [div_v, S_S] = strain_invariants(scene, I, q, D_ab, T);
    const auto chi = mean(scene, I, [&](const Index& cell) { return chi_input<L>(q, cell); });
    const auto g_f = mean(scene, I, [&](const Index& cell) { return fluidity_input<L>(q, cell); });
    const auto slip_squared = edge_slip_squared<L>(scene, I, q, a, b, nu, [&](int axis, const Index& face) {
      return scene.near ? before_sides(scene, I, face, axis) : face;
    });
    const auto p_c = mean_pressure(scene, I, q);
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
  /// The pressure of friction, as the mean of that of the cells and not p_c (18) at their mean nu, which is nothing
  /// beside a partly filled cell: the row at a surface would slide on the bed without friction. Where nu is smooth the
  /// two differ by the square of the cell. A partly filled cell that rests on the one below presses on it.
  template <class Number>
  static Number mean_pressure(const Scene& scene, const Index& I, const Local<EdgeStress, Number>& q) {
    using OfOne = typename Local<EdgeStress, Number>::template Few<1>;
    Number p(0.0);
    const FrictionParameters& friction = scene.solids.friction;
    if (!friction.model->has_friction) return p;
    const std::array<OfOne, 4> nu{q(L::nu, cells[0]), q(L::nu, cells[1]), q(L::nu, cells[2]), q(L::nu, cells[3])};
    std::array<OfOne, 4> p_c;
    for (std::size_t k = 0; k < 4; ++k) p_c[k] = critical_pressure(nu[k], friction);
    const std::array<double, 4> share = shares(scene, I);
    for (std::size_t k = 0; k < 4; ++k) {
      p += share[k] * p_c[k];
      for (const int axis : {a, b}) {
        const double g = scene.gravity[axis];
        const bool upper = (cells[k][axis] == 0) == (g < 0);
        if (g == 0 || !upper || (scene.near && !touch(scene, I, axis, g, cells[k]))) continue;
        const Index below = cells[k] + (g < 0 ? -1 : 1) * unit(axis);
        const std::size_t j = place(below);
        const auto excess =
            through([](const auto&... z) { return resting_excess(z...); }, p_c[k],
                    half_weight(scene, I + cells[k], axis, nu[k]), p_c[j], half_weight(scene, I + below, axis, nu[j]));
        if (excess > 0.0) p += share[k] * excess;
      }
    }
    return p;
  }
  /// Whether a cell of the edge lies on the one below it along `axis`, with nothing between the two.
  [[gnu::noinline]] static bool touch(const Scene& scene, const Index& I, int axis, double g, const Index& upper) {
    if (on_side_of_axis(scene, axis, I)) return false;
    const Index cell = before_sides(scene, I, upper);
    return !scene.barrier(axis, I + (g < 0 ? cell : cell + unit(axis)));
  }
  /// Where a cell stands among `cells`.
  static std::size_t place(const Index& cell) { return (cell[a] == 0 ? 1 : 0) + (cell[b] == 0 ? 2 : 0); }

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
  [[gnu::noinline]] static double share_of_stress(const Scene& scene, const Index& I, int axis, int across) {
    if (on_side_of_axis(scene, across, I)) return 0;
    if (!on_side_of_axis(scene, axis, I)) return open_share(scene, I, axis, across);
    return scene.barrier(across, I + before_side(I, axis, Index{})) ? 0 : 1;
  }

  /// Open share of the face between the control volumes of momentum `axis` below and above the edge along `across`.
  static double open_share(const Scene& scene, const Index& I, int axis, int across) {
    const double below = scene.lower_share(axis, I);
    return (scene.barrier(across, I - unit(axis)) ? 0 : below) + (scene.barrier(across, I) ? 0 : 1 - below);
  }

  /// Weights of the four cells in a bilinear interpolation to the edge. The centre of a wide cell is far: the weights
  /// are crosswise.
  static std::array<double, 4> shares(const Scene& scene, const Index& I) {
    const double far_a = scene.lower_share(a, I), far_b = scene.lower_share(b, I);
    return {(1 - far_a) * (1 - far_b), far_a * (1 - far_b), (1 - far_a) * far_b, far_a * far_b};
  }
  /// The mean of a cell quantity with them. Inlined by force: where an input stands is known when this is compiled.
  template <class Value>
  [[gnu::always_inline]] static auto mean(const Scene& scene, const Index& I, Value&& value) {
    const std::array<double, 4> share = shares(scene, I);
    return share[0] * value(cells[0]) + share[1] * value(cells[1]) + share[2] * value(cells[2]) +
           share[3] * value(cells[3]);
  }

  /// {div v, S:S} at the edge: D_ab as it is, normal components as means over the four cells, other shear components
  /// as means of the squares over the edges about.
  template <class Number, class Rate, class Temperature>
  [[gnu::always_inline]] static auto strain_invariants(const Scene& scene, const Index& I,
                                                       const Local<EdgeStress, Number>& q, const Rate& D_ab,
                                                       const Temperature& T) {
    using Q = Local<EdgeStress, Number>;
    std::array<typename Q::template Few<8>, L::dim> D;
    Strain<Number> S;
    S.add(D_ab, 2);
    for (int axis = 0; axis < L::dim; ++axis) {
      if (scene.near && on_side_of_axis(scene, axis, I))
        D[axis] = normal_before_side(scene, I, q, axis);
      else
        D[axis] = mean(scene, I, [&](const Index& cell) { return normal_in_cell(scene, I, q, axis, cell); });
      S.add(D[axis], 1);
      if constexpr (L::dim > 2)
        if (axis != a && axis != b) add_other_shear(scene, I, q, axis, S);
    }
    const auto div_v = sum(D);
    S.add(div_v, -1.0 / 3);
    return std::pair(div_v, square_of_strain(scene, S, T, I, [](NewtonTangent& t) { return &t.edges[3 - a - b]; }));
  }

  /// D_aa of a cell.
  template <class Q>
  [[gnu::always_inline]] static auto normal_in_cell(const Scene& scene, const Index& I, const Q& q, int axis,
                                                    const Index& cell) {
    return difference_in_cell(scene, axis, I + cell, q(L::v(axis), cell), q(L::v(axis), cell + unit(axis)));
  }
  /// The mean of D_aa on a side of the box normal to the axis, from the cells before it.
  template <class Q>
  [[gnu::noinline]] static auto normal_before_side(const Scene& scene, const Index& I, const Q& q, int axis) {
    return mean(scene, I,
                [&](const Index& cell) { return normal_in_cell(scene, I, q, axis, before_side(I, axis, cell)); });
  }

  /// The most components of S at an edge, D_ab, D_aa, div v and D_ac, D_bc on the edges about, and of their
  /// derivatives.
  static constexpr std::size_t component_count = L::dim + 2 + (L::dim > 2 ? 8 : 0);
  static constexpr std::size_t term_count = 4 + 16 * L::dim + (L::dim > 2 ? 32 : 0);
  template <class Number>
  using Strain = StrainComponents<Number, component_count, term_count>;

  /// Whether a barrier is on the lower `c` face of cell I + at, or of the cell before the side that the edge lies on.
  [[gnu::noinline]] static bool shut(const Scene& scene, const Index& I, int c, const Index& at) {
    return scene.barrier(c, I + before_sides(scene, I, at));
  }

  static constexpr int none = -1;

  /// `at` moved before the sides that the edge lies on, but not along axis `kept`.
  static Index before_sides(const Scene& scene, const Index& I, Index at, int kept = none) {
    for (const int normal : {a, b})
      if (normal != kept && on_side_of_axis(scene, normal, I)) at = before_side(I, normal, at);
    return at;
  }

  /// D_ac and D_bc, c being the axis along the edge; edges on barriers count with zero.
  template <class Number>
  static void add_other_shear(const Scene& scene, const Index& I, const Local<EdgeStress, Number>& q, int c,
                              Strain<Number>& S) {
    for (int side = 0; side < 2; ++side)
      for (int back = 0; back < 2; ++back) {
        const auto add = [&](int axis, const Index& at) {
          if (scene.near && (shut(scene, I, c, at) || shut(scene, I, c, at - unit(axis)))) return;
          S.add(shear_rate<L>(scene, I, q, axis, c, at), 0.5);
        };
        add(a, side * unit(c) - back * e_b);
        add(b, side * unit(c) - back * e_a);
      }
  }
};

}  // namespace scree
