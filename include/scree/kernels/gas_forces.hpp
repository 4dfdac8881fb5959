/// What gas does at a face: its inertia (4) and its pressure gradient, which acts on both phases.
#pragma once

#include "scree/kernels/gas_slip.hpp"

namespace scree {

/// Anchor I: the lower `axis` face of cell I. p_g is what exceeds the pressure of still gas, so that gravity is not in
/// (4), and acts on rho_s - rho_g in (3). Without gas inertia (darcy) drag is -(1-nu) grad p_g; what the floor of nu in
/// voids adds to that acts on no particle.
template <class L, int axis>
struct GasForces {
  static constexpr Index e = unit(axis);
  static constexpr StencilBuilder make_stencil() {
    StencilBuilder s;
    for (const Index& cell : {-1 * e, Index{}}) {
      s.add(L::nu, cell);
      s.add(L::p, cell);
    }
    s.add(L::u(axis), {});
    return s;
  }
  static constexpr StencilBuilder stencil = make_stencil();
  static constexpr int row_count = L::has_u ? 2 : 1;
  static constexpr std::array<Output, row_count> make_rows() {
    std::array<Output, row_count> rows{};
    rows[0] = {L::v(axis), Index{}};
    if (L::has_u) rows[row_count - 1] = {L::u(axis), Index{}};
    return rows;
  }
  static constexpr std::array<Output, row_count> rows = make_rows();
  static constexpr bool has_rates = true;
  static constexpr bool depends(int row, const Input& input) { return row > 0 || !L::is_u(input.component); }

  static bool active(const Scene& scene, const Index& I) { return scene.is_face(axis, I); }
  static Reference resolve(const Scene&, const Index&, const Input& input) { return {input.offset, 1}; }

  template <class Number, std::size_t count>
  [[gnu::flatten]] static void evaluate(const Scene& scene, const Index& I, const Local<GasForces, Number>& q,
                                        std::array<Number, count>& r) {
    const auto nu = face_solids_fraction<L>(scene, I, q, axis, Index{});
    const auto gradient = pressure_gradient<L>(scene, I, q, axis, Index{});
    if constexpr (L::has_u) {
      r[0] += SolidsMomentum::gas_pressure(nu, gradient);
      r[1] +=
          GasMomentum::pressure_and_inertia(nu, gradient, GasMomentum::inertia(scene.gas().rho_g, q.dot(L::u(axis))));
    } else {
      const double floor = scene.model.darcy_solids_fraction;
      const auto with_drag =
          through([&](const auto& x) { return x * (1.0 + (1.0 - x) / sqrt(x * x + floor * floor)); }, nu);
      r[0] += SolidsMomentum::gas_pressure(with_drag, gradient);
    }
  }
};

}  // namespace scree
