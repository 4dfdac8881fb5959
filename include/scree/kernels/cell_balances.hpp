/// What happens in a cell: storage of (1), (9) and (23), normal stresses of (3), production and dissipation of granular
/// temperature (9), relaxation of chi (23), drag (6) on both phases.
#pragma once

#include "scree/kernels/cell_strain.hpp"

namespace scree {

/// Anchor I: cell I.
template <class L>
struct CellBalances {
  static constexpr StencilBuilder stencil = cell_stencil<L>();

  static constexpr int nu_row = 2 * L::dim, T_row = nu_row + 1, chi_row = T_row + (L::has_T ? 1 : 0);
  static constexpr int u_row = chi_row + (L::has_chi ? 1 : 0);
  static constexpr int row_count = u_row + (L::has_u ? 2 * L::dim : 0);
  static constexpr std::array<Output, row_count> make_rows() {
    std::array<Output, row_count> rows{};
    for (int a = 0; a < L::dim; ++a) {
      rows[2 * a] = {L::v(a), Index{}};
      rows[2 * a + 1] = {L::v(a), unit(a)};
    }
    rows[nu_row] = {L::nu, Index{}};
    if (L::has_T) rows[T_row] = {L::T, Index{}};
    if (L::has_chi) rows[chi_row] = {L::chi, Index{}};
    for (int a = 0; a < L::dim && L::has_u; ++a) {
      rows[u_row + 2 * a] = {L::u(a), Index{}};
      rows[u_row + 2 * a + 1] = {L::u(a), unit(a)};
    }
    return rows;
  }
  static constexpr std::array<Output, row_count> rows = make_rows();
  static constexpr bool has_rates = true;
  static constexpr bool depends(int row, const Input& input) {
    if (row == nu_row) return input.component == L::nu;
    if (row < u_row) return true;
    if (input.component == L::nu || L::is_u(input.component)) return true;
    return L::is_v(input.component) && is_own_face(L::axis_of(input.component), input.offset);
  }

  static bool active(const Scene& scene, const Index& I) { return scene.inside(I); }
  static Reference resolve(const Scene&, const Index&, const Input& input) { return {input.offset, 1}; }

  template <class Number, std::size_t count>
  [[gnu::flatten]] static void evaluate(const Scene& scene, const Index& I, const Local<CellBalances, Number>& q,
                                        std::array<Number, count>& r) {
    const auto strain = cell_strain<L>(scene, I, q);
    const auto [p, mu, energy, chi_star, beta, beta_over_nu] =
        cell_closures<L, CellClosure::pressure, CellClosure::viscosity, CellClosure::energy_source,
                      CellClosure::chi_star, CellClosure::drag, CellClosure::drag_over_nu>(scene, I, q, strain);

    for (int a = 0; a < L::dim; ++a) {
      const Number sigma = SolidsMomentum::normal_stress(p, mu, strain.S(a));
      r[2 * a] += out_of_control_volume(scene, a, I, End::upper, sigma);
      r[2 * a + 1] -= out_of_control_volume(scene, a, I + unit(a), End::lower, sigma);
    }
    r[nu_row] += SolidsContinuity::storage(q.dot(L::nu));

    const auto floor = added_in_voids(scene, q(L::nu));
    const auto stored = q(L::nu) + floor;
    if constexpr (L::has_T)
      r[T_row] += GranularEnergy::storage(scene.solids.kinetic.rho_s, stored, q.dot(L::T)) - energy;
    if constexpr (L::has_chi)
      r[chi_row] += FrictionRelaxation::storage_less_source(stored, q.dot(L::chi),
                                                            chi_source(q(L::chi), chi_star, scene.solids.friction));
    if constexpr (L::has_u) add_drag(scene, I, q, beta, Number(beta + floor * beta_over_nu), r);
  }

 private:
  static constexpr bool is_own_face(int axis, const Index& at) { return at == Index{} || at == unit(axis); }

  /// beta (u - v) of (6) on the halves of the control volumes of u and v that lie in this cell. In voids, where `on_v`
  /// differs from beta, v follows u; the gas does not feel that.
  template <class Number, std::size_t count>
  static void add_drag(const Scene& scene, const Index& I, const Local<CellBalances, Number>& q, const Number& beta,
                       const Number& on_v, std::array<Number, count>& r) {
    for (int a = 0; a < L::dim; ++a)
      for (int side = 0; side < 2; ++side) {
        const auto w = share_of_cell(scene, a, I, side) * gas_slip<L>(q, a, side * unit(a));
        r[2 * a + side] -= SolidsMomentum::drag(on_v, w);
        r[u_row + 2 * a + side] += GasMomentum::drag(beta, w);
      }
  }
};

}  // namespace scree
