/// Flux of both phases through a face, for the balance of gas volume: see balances/gas_continuity.hpp.
#pragma once

#include "scree/kernels/gas_flux.hpp"

namespace scree {

/// Anchor I: the lower `axis` face of cell I.
template <class L, bool SecondOrder, int axis>
struct GasVolumeFlux {
  static constexpr Index e = unit(axis);
  static constexpr StencilBuilder make_stencil() {
    StencilBuilder s;
    add_solids_flux_inputs<L, SecondOrder>(s, axis, {});
    add_gas_flux_inputs<L>(s, axis, {});
    return s;
  }
  static constexpr StencilBuilder stencil = make_stencil();
  static constexpr std::array<Output, 2> rows{{{L::p, -1 * e}, {L::p, Index{}}}};
  static constexpr bool depends(int, const Input&) { return true; }

  static bool active(const Scene& scene, const Index& I) {
    return scene.is_face(axis, I) && !closed_to_gas(scene, axis, I);
  }
  static Reference resolve(const Scene& scene, const Index& I, const Input& input) {
    if (input.component != L::nu) return {input.offset, 1};
    return cell_before_barrier(scene, I, axis, {}, input.offset[axis]);
  }

  template <class Number, std::size_t count>
  [[gnu::flatten]] static void evaluate(const Scene& scene, const Index& I, const Local<GasVolumeFlux, Number>& q,
                                        std::array<Number, count>& r) {
    const Number flux = solids_flux<L, SecondOrder>(scene, I, q, axis, {}) + gas_flux<L>(scene, I, q, axis, {});
    r[0] += out_of_cell(scene, axis, I - e, End::upper, flux);
    r[1] -= out_of_cell(scene, axis, I, End::lower, flux);
  }
};

}  // namespace scree
