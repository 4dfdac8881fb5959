/// What acts at a velocity of the particles: inertia and weight of (3), and the regularisation of voids.
#pragma once

#include <cmath>

#include "scree/assembly/kernel.hpp"
#include "scree/assembly/scene.hpp"
#include "scree/balances/layout.hpp"

namespace scree {

/// Anchor I: the lower `axis` face of cell I, between two cells or on an open side. Without particles (3) says nothing:
/// void_floor is added to nu in the inertia, and in a drag floor rho_s v/t_d that lets the velocity there decay
/// (towards that of the gas, by the gas's own drag, where u is an unknown: cell_balances.hpp); gravity acts on nu
/// alone. With gas it is reduced by buoyancy, since p_g is what exceeds the pressure of still gas.
/// nu is that before the step, where the scheme is backward Euler and there is no gas: see solids_momentum.hpp.
/// On an open side the control volume is half a cell, and moves with it as much of the particles that have just left:
/// what falls out of an orifice is not held back by the stress inside alone.
template <class L, int axis>
struct FaceForces {
  static constexpr Index e = unit(axis);
  static constexpr StencilBuilder make_stencil() {
    StencilBuilder s;
    s.add(L::v(axis), {});
    s.add(L::nu, -1 * e);
    s.add(L::nu, {});
    return s;
  }
  static constexpr StencilBuilder stencil = make_stencil();
  static constexpr std::array<Output, 1> rows{{{L::v(axis), Index{}}}};
  static constexpr bool has_rates = true;
  static constexpr bool depends(int, const Input&) { return true; }

  static bool active(const Scene& scene, const Index& I) { return scene.is_face(axis, I); }
  static Reference resolve(const Scene&, const Index&, const Input& input) { return {input.offset, 1}; }

  template <class Number, std::size_t count>
  [[gnu::flatten]] static void evaluate(const Scene& scene, const Index& I, const Local<FaceForces, Number>& q,
                                        std::array<Number, count>& r) {
    const double rho_s = scene.solids.kinetic.rho_s, rho_g = L::has_gas ? scene.gas().rho_g : 0;
    Number nu = before_step<L>(scene, I, q);
    if (scene.on_side(axis, I)) {
      const double outwards = box_above(scene, axis, I) ? -1 : 1;
      nu = nu * (1.0 + filled_beyond(scene, Number(outwards * q(L::v(axis)))));
    }
    const Number floor = added_in_voids(scene, nu);
    r[0] += SolidsMomentum::inertia(rho_s, nu + floor, q.dot(L::v(axis))) -
            SolidsMomentum::weight(rho_s - rho_g, scene.gravity[axis], nu);
    if constexpr (!L::has_u) r[0] += SolidsMomentum::void_drag(rho_s, scene.model.void_drag_time, floor, q(L::v(axis)));
  }

 private:
  /// nu at the face before the step that the rates are differences over; as it is where they are not, and with gas,
  /// whose drag at the new nu the weight has to balance.
  template <class Layout, class Q>
  static auto before_step(const Scene& scene, const Index& I, const Q& q) {
    [[maybe_unused]] const auto before = [&](int component, const Index& at) {
      return q(component, at) - scene.step * q.dot(component, at);
    };
    if constexpr (Layout::has_gas)
      return face_solids_fraction<Layout>(scene, I, q, axis, Index{});
    else
      return face_solids_fraction<Layout>(scene, I, before, axis, Index{});
  }
  /// How far the half cell beyond an open side is filled by what leaves with the speed `outflow`: 0 at rest, where
  /// nothing lies outside, 1 in a flow much faster than a tenth of sqrt(g d).
  template <class Number>
  static Number filled_beyond(const Scene& scene, const Number& outflow) {
    const auto& g = scene.model.gravity;
    const double slow = 1e-1 * std::sqrt(std::hypot(g[0], g[1], g[2]) * scene.solids.kinetic.d);
    if (!(outflow > 0.0)) return Number(0.0);
    return outflow / (outflow + slow);
  }
};

}  // namespace scree
