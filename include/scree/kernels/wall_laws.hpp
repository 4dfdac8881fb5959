/// What a wall does to the particles of a cell beside it: friction on the tangential velocities, eq. (25), and exchange
/// of fluctuation energy, eq. (26); or the stress of a wall without slip.
#pragma once

#include "scree/kernels/cell_strain.hpp"
#include "scree/kernels/surface_stress.hpp"
#include "scree/kernels/wall_pressure.hpp"

namespace scree {

/// Anchor I: a cell with a wall. Each velocity along the wall takes the part of the wall stress that lies in this cell.
template <class L>
struct WallLaws {
  static constexpr StencilBuilder make_stencil() {
    StencilBuilder s = cell_stencil<L>();
    for (int axis = 0; axis < L::dim; ++axis)
      for (int side = -1; side <= 1; side += 2) s.add(L::nu, side * unit(axis));
    return s;
  }
  static constexpr StencilBuilder stencil = make_stencil();

  static constexpr int T_row = 2 * L::dim, g_f_row = T_row + (L::has_T ? 1 : 0);
  static constexpr int row_count = g_f_row + (L::has_g_f ? 1 : 0);
  static constexpr std::array<Output, row_count> make_rows() {
    std::array<Output, row_count> rows{};
    for (int t = 0; t < L::dim; ++t) {
      rows[2 * t] = {L::v(t), Index{}};
      rows[2 * t + 1] = {L::v(t), unit(t)};
    }
    if (L::has_T) rows[T_row] = {L::T, Index{}};
    if (L::has_g_f) rows[g_f_row] = {L::g_f, Index{}};
    return rows;
  }
  static constexpr std::array<Output, row_count> rows = make_rows();
  static constexpr bool depends(int, const Input&) { return true; }

  static bool active(const Scene& scene, const Index& I) {
    if (!scene.near || !scene.inside(I)) return false;
    for (int axis = 0; axis < L::dim; ++axis)
      for (int side = 0; side < 2; ++side)
        if (acts(scene, axis, I + side * unit(axis))) return true;
    return false;
  }
  static Reference resolve(const Scene&, const Index&, const Input& input) { return {input.offset, 1}; }

  template <class Number, std::size_t count>
  static void evaluate(const Scene& scene, const Index& I, const Local<WallLaws, Number>& q,
                       std::array<Number, count>& r) {
    const auto strain = cell_strain<L>(scene, I, q);
    const auto closures = closures_at(scene, I, q, strain);
    for (int axis = 0; axis < L::dim; ++axis)
      for (int side = 0; side < 2; ++side)
        if (acts(scene, axis, I + side * unit(axis))) one_wall(scene, I, q, axis, end_of(side), strain, closures, r);
  }

  /// Shear along each axis, in the lower and upper half of the cell along it.
  using HalfShear = std::array<std::array<double, 2>, max_dim>;

  /// By what stress the particles of cell I drag a wall at its end along `axis` along with them, as the balances have
  /// it [Pa]; 0 where there is no wall, or one without shear.
  static HalfShear wall_shear(const Scene& scene, const Index& I, const Local<WallLaws, double>& q, int axis, End end) {
    HalfShear shear{};
    if (!acts(scene, axis, I + (end == End::lower ? 0 : 1) * unit(axis))) return shear;
    const auto strain = cell_strain<L>(scene, I, q);
    std::array<double, static_cast<std::size_t>(row_count)> r{};
    one_wall(scene, I, q, axis, end, strain, closures_at(scene, I, q, strain), r);
    for (int t = 0; t < L::dim; ++t)
      for (int side = 0; side < 2 && t != axis; ++side)
        shear[t][side] = scene.cell_length(axis, I) / share_of_cell(scene, t, I, side) * r[2 * t + side];
    return shear;
  }

 private:
  template <class Q, class Strain>
  static auto closures_at(const Scene& scene, const Index& I, const Q& q, const Strain& strain) {
    return cell_closures<L, CellClosure::viscosity, CellClosure::frictional_pressure, CellClosure::frictional_viscosity,
                         CellClosure::temperature, CellClosure::sqrt_temperature>(scene, I, q, strain);
  }

  template <class Number, class Strain, std::size_t count>
  static void one_wall(const Scene& scene, const Index& I, const Local<WallLaws, Number>& q, int axis, End end,
                       const Strain& strain, const std::array<Number, 5>& closures, std::array<Number, count>& r) {
    const Condition& wall = scene.condition(axis, I + (end == End::lower ? 0 : 1) * unit(axis));
    if (wall.kind.solids_tangential == SolidsTangential::no_slip)
      no_slip(scene, I, q, axis, end, strain, wall, r);
    else
      johnson_jackson(scene, I, q, axis, end, strain, closures, wall, r);
  }

  static bool acts(const Scene& scene, int axis, const Index& face) {
    return scene.barrier(axis, face) && scene.kind(axis, face).shears_solids();
  }

  /// A frictional stress normal to the wall, from that of the cell [Pa].
  template <class Number>
  static Number at_wall(const Scene& scene, const Index& I, const Local<WallLaws, Number>& q, int axis, End end,
                        const Number& in_cell) {
    const Number p = extrapolated(scene, I, q, axis, end, in_cell);
    const double g = scene.gravity[axis];
    const bool floor = g != 0 && (g < 0) == (end == End::lower);
    if (!floor) return p;
    return pressure_on_floor(p, Number(surface_stress<L>(scene, I, q, axis)),
                             half_weight(scene, I, axis, Number(q(L::nu))));
  }

  /// The same without the weight of thin layers: pressure_at_wall, unless there is no next cell.
  template <class Number>
  static Number extrapolated(const Scene& scene, const Index& I, const Local<WallLaws, Number>& q, int axis, End end,
                             const Number& in_cell) {
    const FrictionParameters& friction = scene.solids.friction;
    if (!friction.model->has_friction || is_alone(scene, I, axis, end)) return in_cell;
    return pressure_at_wall(in_cell, Number(critical_pressure(q(L::nu), friction)),
                            Number(critical_pressure(q(L::nu, inward(axis, end)), friction)),
                            to_wall(scene, I, axis, end));
  }

  /// nu on the wall, or that of the cell if there is no next one.
  template <class Number>
  static Number nu_at_wall(const Scene& scene, const Index& I, const Local<WallLaws, Number>& q, int axis, End end) {
    if (is_alone(scene, I, axis, end)) return q(L::nu);
    return through(
        [&](const auto& nu, const auto& next) {
          return solids_fraction_at_wall(nu, next, scene.solids.kinetic.nu_max, to_wall(scene, I, axis, end));
        },
        q(L::nu), q(L::nu, inward(axis, end)));
  }

  /// From the cell to the next one away from the wall.
  static Index inward(int axis, End end) { return end == End::lower ? unit(axis) : -1 * unit(axis); }
  /// The face between the two.
  static Index between(const Index& I, int axis, End end) { return end == End::lower ? I + unit(axis) : I; }
  static bool is_alone(const Scene& scene, const Index& I, int axis, End end) {
    return scene.barrier(axis, between(I, axis, end));
  }
  /// Distance to the wall over that to the next cell's centre [-].
  static double to_wall(const Scene& scene, const Index& I, int axis, End end) {
    return scene.distance_to_face(axis, I) / scene.centre_distance(axis, between(I, axis, end));
  }

  /// Slip of a tangential velocity of the cell: `side` 0 lower, 1 upper face of axis t.
  template <class Q>
  static auto wall_slip(const Q& q, const Condition& wall, int t, int side) {
    return q(L::v(t), side * unit(t)) - wall.velocity[t];
  }

  /// |v_sl|^2 at a tangential velocity: its own component there, the mean over the cell of the other one.
  template <class Number, class Q>
  static Number slip_speed_squared(const Q& q, const Condition& wall, int axis, int t, int side) {
    const auto own = wall_slip(q, wall, t, side);
    Number sum = own * own;
    for (int other = 0; other < L::dim; ++other) {
      if (other == axis || other == t) continue;
      const auto low = wall_slip(q, wall, other, 0), high = wall_slip(q, wall, other, 1);
      sum += 0.5 * (low * low + high * high);
    }
    return sum;
  }

  /// Adds a stress to the balance of one tangential velocity.
  template <class Number, std::size_t count>
  static void add_stress(const Scene& scene, const Index& I, int axis, End end, int t, int side, const Number& stress,
                         std::array<Number, count>& r) {
    r[2 * t + side] += out_of_cell(scene, axis, I, end, Number(share_of_cell(scene, t, I, side) * stress));
  }

  /// (25) and (26) with slip and T at the wall, half a cell from where they are known: wall_slip_share and
  /// wall_sqrt_temperature lead there, nu_at_wall and at_wall for nu and the normal stress.
  template <class Number, class Strain, std::size_t count>
  static void johnson_jackson(const Scene& scene, const Index& I, const Local<WallLaws, Number>& q, int axis, End end,
                              const Strain& strain, const std::array<Number, 5>& closures, const Condition& wall,
                              std::array<Number, count>& r) {
    const KineticParameters& kinetic = scene.solids.kinetic;
    const auto& [mu, p_f, mu_f, T, sqrt_T] = closures;
    const Number N = at_wall(scene, I, q, axis, end, SolidsMomentum::normal_stress(p_f, mu_f, strain.S(axis)));
    const Number nu = nu_at_wall(scene, I, q, axis, end), k = mu / scene.distance_to_face(axis, I);
    Number sqrt_T_wall = sqrt_T;
    if constexpr (L::has_T) {
      const auto [at_wall, heat] = heat_from_wall(scene, I, q, axis, nu, k, N, sqrt_T, wall);
      sqrt_T_wall = at_wall;
      r[T_row] -= out_of_cell(scene, axis, I, end, heat);
    }
    for (int t = 0; t < L::dim; ++t)
      for (int side = 0; side < 2 && t != axis; ++side) {
        const Number c = through(
            [&](const auto& nu_, const auto& sqrt_T_, const auto& N_, const auto& k_, const auto& slip_squared) {
              const auto collisions = wall.wall.specularity * wall_collision_rate(nu_, sqrt_T_, kinetic, wall.wall);
              const auto share = wall_slip_share(k_, N_, collisions, slip_squared, wall.wall);
              return share *
                     wall_traction_coefficient(nu_, sqrt_T_, N_, share * share * slip_squared, kinetic, wall.wall);
            },
            nu, sqrt_T_wall, N, k, slip_speed_squared<Number>(q, wall, axis, t, side));
        add_stress(scene, I, axis, end, t, side, Number(c * wall_slip(q, wall, t, side)), r);
      }
  }

  /// {sqrt(T) at the wall, heat flux from it (26)}, with the mean of the slip over the cell.
  template <class Number>
  static std::array<Number, 2> heat_from_wall(const Scene& scene, const Index& I, const Local<WallLaws, Number>& q,
                                              int axis, const Number& nu, const Number& k, const Number& N,
                                              const Number& sqrt_T, const Condition& wall) {
    Number mean_slip_squared(0.0);
    for (int t = 0; t < L::dim; ++t)
      for (int side = 0; side < 2 && t != axis; ++side) {
        const Number component = wall_slip(q, wall, t, side);
        mean_slip_squared += 0.5 * (component * component);
      }
    const KineticParameters& kinetic = scene.solids.kinetic;
    const double distance = scene.distance_to_face(axis, I);
    const auto gas_slip_squared = cell_slip_squared<L>(scene, I, q);
    const Number kappa = through([&](const auto& nu_, const auto& T_,
                                     const auto& slip_) { return face_conductivity(nu_, T_, slip_, scene.solids); },
                                 q(L::nu), q(L::T), gas_slip_squared);
    return through(
        [&](const auto& nu_, const auto& sqrt_T_, const auto& kappa_, const auto& k_, const auto& N_,
            const auto& slip_squared) {
          using Inner = std::decay_t<decltype(nu_)>;
          const Inner collisions = wall.wall.specularity * wall_collision_rate(nu_, sqrt_T_, kinetic, wall.wall);
          const Inner share = wall_slip_share(k_, N_, collisions, slip_squared, wall.wall);
          const Inner at_wall_squared = share * share * slip_squared;
          const Inner at_wall = wall_sqrt_temperature(nu_, sqrt_T_, Inner(kappa_ / sqrt_T_), at_wall_squared, distance,
                                                      kinetic, wall.wall);
          const Inner heat =
              wall_heat_flux(nu_, Inner(at_wall * at_wall), at_wall, at_wall_squared, kinetic, wall.wall);
          return std::array<Inner, 2>{at_wall, heat};
        },
        nu, sqrt_T, kappa, k, N, mean_slip_squared);
  }

  /// The mean fluidity between a wall without slip and the centre of the cell, or a constant.
  template <class Q>
  static auto fluidity_before_rough_wall(const Scene& scene, const Q& q) {
    const FluidityParameters& p = scene.solids.friction.fluidity;
    const auto in_cell = fluidity_input<L>(q);
    return std::decay_t<decltype(in_cell)>(p.held_at_rough ? 0.5 * (in_cell + p.at_rough) : in_cell);
  }

  /// The stress of particles that stick to the wall, with the viscosity that the shear between wall and cell leaves
  /// them: friction bounds it by p_f sin(phi), however fast they are drawn along.
  template <class Number, class Strain, std::size_t count>
  static void no_slip(const Scene& scene, const Index& I, const Local<WallLaws, Number>& q, int axis, End end,
                      const Strain& strain, const Condition& wall, std::array<Number, count>& r) {
    const FrictionParameters& friction = scene.solids.friction;
    const Number p_c = friction.model->has_friction
                           ? at_wall(scene, I, q, axis, end, Number(critical_pressure(q(L::nu), friction)))
                           : Number(0.0);
    const auto gas_slip_squared = cell_slip_squared<L>(scene, I, q);
    const double h = scene.distance_to_face(axis, I);
    if constexpr (L::has_g_f)
      if (friction.fluidity.held_at_rough)
        r[g_f_row] -=
            out_of_cell(scene, axis, I, end, Fluidity::from_wall(scene, Number(q(L::nu)), Number(q(L::g_f)), h));
    for (int t = 0; t < L::dim; ++t)
      for (int side = 0; side < 2 && t != axis; ++side) {
        const Number S_S = strain.normal_square() + 0.5 * slip_speed_squared<Number>(q, wall, axis, t, side) / (h * h);
        const Number mu = through(
            [&](const auto& nu_, const auto& p_c_, const auto& T_, const auto& chi_, const auto& div_v_,
                const auto& S_S_, const auto& slip_, const auto& g_f_) {
              return edge_closure(nu_, p_c_, T_, chi_, div_v_, S_S_, slip_, g_f_, scene.solids);
            },
            q(L::nu), p_c, temperature_input<L>(q), chi_input<L>(q), strain.div_v, S_S, gas_slip_squared,
            fluidity_before_rough_wall(scene, q));
        add_stress(scene, I, axis, end, t, side, Number(mu * wall_slip(q, wall, t, side) / h), r);
      }
  }
};

}  // namespace scree
