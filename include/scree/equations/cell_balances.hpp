/// What happens in a cell: storage of (1), (9) and (23), normal stresses of (3), production and dissipation of granular
/// temperature (9), relaxation of chi (23).
#pragma once

#include "scree/equations/cell_strain.hpp"

namespace scree {

/// Anchor I: cell I.
template <class L>
struct CellBalances {
  static constexpr StencilBuilder stencil = cell_stencil<L>();

  static constexpr int nu_row = 2 * L::dim, T_row = nu_row + 1, chi_row = T_row + (L::has_T ? 1 : 0);
  static constexpr int row_count = chi_row + (L::has_chi ? 1 : 0);
  static constexpr std::array<Output, row_count> make_rows() {
    std::array<Output, row_count> rows{};
    for (int a = 0; a < L::dim; ++a) {
      rows[2 * a] = {L::v(a), Index{}};
      rows[2 * a + 1] = {L::v(a), unit(a)};
    }
    rows[nu_row] = {L::nu, Index{}};
    if (L::has_T) rows[T_row] = {L::T, Index{}};
    if (L::has_chi) rows[chi_row] = {L::chi, Index{}};
    return rows;
  }
  static constexpr std::array<Output, row_count> rows = make_rows();
  static constexpr bool depends(int row, const Input& input) { return row != nu_row || input.component == L::nu; }

  static bool active(const Scene& scene, const Index& I) { return scene.lattice.inside(I); }
  static Reference resolve(const Scene&, const Index&, const Input& input) { return {input.offset, 1}; }

  template <class Number, std::size_t count>
  static void evaluate(const Scene& scene, const Index& I, const Local<CellBalances, Number>& q,
                       std::array<Number, count>& r) {
    const auto strain = cell_strain<L>(scene, I, q);
    const auto [p, mu, energy, chi_star] =
        cell_closures<L, CellClosure::pressure, CellClosure::viscosity, CellClosure::energy_source,
                      CellClosure::chi_star>(scene, q, strain);

    for (int a = 0; a < L::dim; ++a) {
      const Number sigma = p - 2.0 * mu * strain.S(a);
      r[2 * a] += sigma / scene.axis(a).distance(I[a]);
      r[2 * a + 1] -= sigma / scene.axis(a).distance(I[a] + 1);
    }
    r[nu_row] += q.dot(L::nu);

    const Number stored = q(L::nu) + scene.model.void_fraction_floor;
    if constexpr (L::has_T) r[T_row] += 1.5 * scene.solids.kinetic.rho_s * stored * q.dot(L::T) - energy;
    if constexpr (L::has_chi)
      r[chi_row] += stored * (q.dot(L::chi) - chi_source(q(L::chi), chi_star, scene.solids.friction));
  }
};

}  // namespace scree
