/// Fluxes through a face of the balances that live at cells: solids continuity (1), advection and conduction of
/// granular temperature (9), advection of chi (23).
#pragma once

#include "scree/kernels/gas_slip.hpp"
#include "scree/kernels/solids_flux.hpp"

namespace scree {

/// Value of a scalar of the particles that the volume flux `flux` carries through the lower `axis` face of I, an open
/// side of the box: that of the cell inside, or what the condition brings in.
template <class Number>
[[gnu::noinline]] Number carried_through_barrier(const Scene& scene, int axis, const Index& I, const Unknown& unknown,
                                                 double flux, const Number& below, const Number& above) {
  const Condition& condition = scene.condition(axis, I);
  if (condition.kind.brings_solids() && comes_in(scene, axis, I, flux)) return Number(condition.brought(unknown));
  return box_above(scene, axis, I) ? above : below;
}

/// Value of a scalar of the particles that the volume flux F carries through the lower `axis` face of I: upstream of
/// it, or what the condition brings in.
template <class L, bool SecondOrder, class Balance, class Q, class Flux>
[[gnu::always_inline]] inline auto carried(const Scene& scene, const Index& I, const Q& q, int axis, const Flux& F) {
  using Value = typename Q::template Few<carried_terms(SecondOrder)>;
  constexpr int component = L::template first<Balance>();
  const Index e = unit(axis);
  const auto below = q(component, -1 * e), above = q(component);
  if (scene.barrier(axis, I))
    return Value(carried_through_barrier(scene, axis, I, Balance::unknown, value_of(F), below, above));
  if constexpr (SecondOrder) {
    return Value(carried_input(scene, axis, I, Balance::unknown, value_of(F), q, component, Index{}));
  } else {
    return Value(upwind(F, below, above));
  }
}

/// Anchor I: the lower `axis` face of cell I.
template <class L, bool SecondOrder, int axis>
struct ScalarFluxes {
  static constexpr Index e = unit(axis);
  static constexpr int first = SecondOrder ? -2 : -1, last = SecondOrder ? 1 : 0;

  static constexpr StencilBuilder make_stencil() {
    StencilBuilder s;
    add_solids_flux_inputs<L, SecondOrder>(s, axis, {});
    for (int reach = first; reach <= last; ++reach) {
      s.add(L::T, reach * e);
      s.add(L::chi, reach * e);
    }
    if (L::has_T) add_face_slip_inputs<L>(s, axis);
    return s;
  }
  static constexpr StencilBuilder stencil = make_stencil();

  static constexpr int row_count = 2 + (L::has_T ? 2 : 0) + (L::has_chi ? 2 : 0);
  static constexpr int T_row = 2, chi_row = 2 + (L::has_T ? 2 : 0);
  static constexpr std::array<Output, row_count> make_rows() {
    std::array<Output, row_count> rows{};
    for (int side = 0; side < 2; ++side) {
      const Index cell = (side - 1) * e;
      rows[side] = {L::nu, cell};
      if (L::has_T) rows[T_row + side] = {L::T, cell};
      if (L::has_chi) rows[chi_row + side] = {L::chi, cell};
    }
    return rows;
  }
  static constexpr std::array<Output, row_count> rows = make_rows();
  static constexpr bool depends(int row, const Input& input) {
    if (input.component == L::nu || (input.component == L::v(axis) && input.offset == Index{})) return true;
    if (input.component == L::T || input.component == L::chi) return input.component == rows[row].component;
    return L::has_T && rows[row].component == L::T;  // slip of the gas, in the conductivity
  }

  static bool active(const Scene& scene, const Index& I) { return scene.is_face(axis, I) && !scene.wall(axis, I); }
  static Reference resolve(const Scene& scene, const Index& I, const Input& input) {
    const bool carried = input.component == L::nu || input.component == L::T || input.component == L::chi;
    if (!carried) return {input.offset, 1};
    return cell_before_barrier(scene, I, axis, {}, input.offset[axis]);
  }

  template <class Number, std::size_t count>
  [[gnu::flatten]] static void evaluate(const Scene& scene, const Index& I, const Local<ScalarFluxes, Number>& q,
                                        std::array<Number, count>& r) {
    const Number F = solids_flux<L, SecondOrder>(scene, I, q, axis, {});
    r[0] += out_of_cell(scene, axis, I - e, End::upper, F);
    r[1] -= out_of_cell(scene, axis, I, End::lower, F);

    if constexpr (L::has_T) {
      const double rho_s = scene.solids.kinetic.rho_s;
      const Number T = carried<L, SecondOrder, GranularEnergy>(scene, I, q, axis, F);
      const Number conducted = heat_flux(scene, I, q);
      r[T_row] += out_of_cell(scene, axis, I - e, End::upper,
                              GranularEnergy::advection(rho_s, F, T, q(L::T, -1 * e)) + conducted);
      r[T_row + 1] -=
          out_of_cell(scene, axis, I, End::lower, GranularEnergy::advection(rho_s, F, T, q(L::T)) + conducted);
    }
    if constexpr (L::has_chi) {
      const Number chi = carried<L, SecondOrder, FrictionRelaxation>(scene, I, q, axis, F);
      r[chi_row] +=
          out_of_cell(scene, axis, I - e, End::upper, FrictionRelaxation::advection(F, chi, q(L::chi, -1 * e)));
      r[chi_row + 1] -= out_of_cell(scene, axis, I, End::lower, FrictionRelaxation::advection(F, chi, q(L::chi)));
    }
  }

 private:
  /// q of (1.3) along the axis [W/m2]; none through sides of the box.
  template <class Number>
  static Number heat_flux(const Scene& scene, const Index& I, const Local<ScalarFluxes, Number>& q) {
    if (scene.barrier(axis, I)) return Number(0.0);
    const auto below = q(L::T, -1 * e), above = q(L::T);
    const auto nu_face = face_mean(scene, axis, I, q(L::nu, -1 * e), q(L::nu));
    const auto T_face = face_mean(scene, axis, I, below, above);
    const auto slip_squared = face_slip_squared<L>(scene, I, q, axis, nu_face);
    const auto kappa = through(
        [&](const auto& nu, const auto& T, const auto& slip_) { return face_conductivity(nu, T, slip_, scene.solids); },
        nu_face, T_face, slip_squared);
    return GranularEnergy::conduction(kappa, difference_at_face(scene, axis, I, below, above));
  }
};

}  // namespace scree
