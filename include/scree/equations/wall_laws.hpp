/// What a wall does to the particles of a cell beside it: friction on the tangential velocities, eq. (25), and exchange
/// of fluctuation energy, eq. (26); or the stress of a wall without slip.
#pragma once

#include "scree/equations/cell_strain.hpp"

namespace scree {

/// Anchor I: a cell whose lower (upper = false) or upper `axis` face is a wall. Each tangential velocity of the cell
/// takes the part of the wall stress that lies in this cell.
template <class L, int axis, bool upper>
struct WallLaws {
  static constexpr StencilBuilder stencil = cell_stencil<L>();

  static constexpr int T_row = 2 * (L::dim - 1);
  static constexpr int row_count = T_row + (L::has_T ? 1 : 0);
  static constexpr std::array<Output, row_count> make_rows() {
    std::array<Output, row_count> rows{};
    int row = 0;
    for (int t = 0; t < L::dim; ++t) {
      if (t == axis) continue;
      rows[row++] = {L::v(t), Index{}};
      rows[row++] = {L::v(t), unit(t)};
    }
    if (L::has_T) rows[row] = {L::T, Index{}};
    return rows;
  }
  static constexpr std::array<Output, row_count> rows = make_rows();
  static constexpr bool depends(int, const Input&) { return true; }

  static Index face(const Index& I) { return upper ? I + unit(axis) : I; }
  static bool active(const Scene& scene, const Index& I) {
    if (row_count == 0 || !scene.lattice.inside(I) || !scene.barriers.at(axis, face(I))) return false;
    const BoundaryKind kind = scene.barriers.condition(axis, face(I)).kind;
    return kind == BoundaryKind::wall_johnson_jackson || kind == BoundaryKind::wall_no_slip;
  }
  static Reference resolve(const Scene&, const Index&, const Input& input) { return {input.offset, 1}; }

  template <class Number, std::size_t count>
  static void evaluate(const Scene& scene, const Index& I, const Local<WallLaws, Number>& q,
                       std::array<Number, count>& r) {
    const Condition& wall = scene.barriers.condition(axis, face(I));
    const auto strain = cell_strain<L>(scene, I, q);
    if (wall.kind == BoundaryKind::wall_no_slip)
      no_slip(scene, I, q, strain, wall, r);
    else
      johnson_jackson(scene, I, q, strain, wall, r);
  }

 private:
  /// Slip of a tangential velocity of the cell: `side` 0 lower, 1 upper face of axis t.
  template <class Q>
  static auto slip(const Q& q, const Condition& wall, int t, int side) {
    return q(L::v(t), side * unit(t)) - wall.velocity[t];
  }

  /// |v_sl|^2 at a tangential velocity: its own component there, the mean over the cell of the other one.
  template <class Number, class Q>
  static Number slip_speed_squared(const Q& q, const Condition& wall, int t, int side) {
    const auto own = slip(q, wall, t, side);
    Number sum = own * own;
    for (int other = 0; other < L::dim; ++other) {
      if (other == axis || other == t) continue;
      const auto low = slip(q, wall, other, 0), high = slip(q, wall, other, 1);
      sum += 0.5 * (low * low + high * high);
    }
    return sum;
  }

  /// Adds the stress `coefficient` v_sl to the balance of one tangential velocity.
  template <class Number, std::size_t count>
  static void add_stress(const Scene& scene, const Index& I, int t, int side, int row, const Number& coefficient_slip,
                         std::array<Number, count>& r) {
    const double below = scene.axis(t).lower_share(I[t] + side);
    const double share = side == 0 ? 1 - below : below;  // of the control volume in this cell
    r[row] += share * coefficient_slip / scene.axis(axis).width(I[axis]);
  }

  template <class Number, class Strain, std::size_t count>
  static void johnson_jackson(const Scene& scene, const Index& I, const Local<WallLaws, Number>& q,
                              const Strain& strain, const Condition& wall, std::array<Number, count>& r) {
    const KineticParameters& kinetic = scene.solids.kinetic;
    const auto [p_f, mu_f, T, sqrt_T] =
        cell_closures<L, CellClosure::frictional_pressure, CellClosure::frictional_viscosity, CellClosure::temperature,
                      CellClosure::sqrt_temperature>(scene, q, strain);
    const Number N = p_f - 2.0 * mu_f * strain.S(axis);
    Number mean_slip_squared(0.0);
    int row = 0;
    for (int t = 0; t < L::dim; ++t) {
      if (t == axis) continue;
      for (int side = 0; side < 2; ++side) {
        const Number speed_squared = slip_speed_squared<Number>(q, wall, t, side);
        const Number c = through(
            [&](const auto& nu_, const auto& sqrt_T_, const auto& N_, const auto& slip_squared) {
              return wall_traction_coefficient(nu_, sqrt_T_, N_, slip_squared, kinetic, wall.wall);
            },
            q(L::nu), sqrt_T, N, speed_squared);
        add_stress(scene, I, t, side, row++, Number(c * slip(q, wall, t, side)), r);
        const auto component = slip(q, wall, t, side);
        mean_slip_squared += 0.5 * (component * component);
      }
    }
    if constexpr (L::has_T)
      r[T_row] -= wall_heat_flux(q(L::nu), Number(T), Number(sqrt_T), mean_slip_squared, kinetic, wall.wall) /
                  scene.axis(axis).width(I[axis]);
  }

  template <class Number, class Strain, std::size_t count>
  static void no_slip(const Scene& scene, const Index& I, const Local<WallLaws, Number>& q, const Strain& strain,
                      const Condition& wall, std::array<Number, count>& r) {
    const Number mu = cell_closures<L, CellClosure::viscosity>(scene, q, strain)[0];
    const Number c = mu / (0.5 * scene.axis(axis).width(I[axis]));
    int row = 0;
    for (int t = 0; t < L::dim; ++t)
      for (int side = 0; side < 2 && t != axis; ++side)
        add_stress(scene, I, t, side, row++, Number(c * slip(q, wall, t, side)), r);
  }
};

}  // namespace scree
