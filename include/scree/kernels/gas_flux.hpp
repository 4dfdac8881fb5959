/// The volume flux of gas (1-nu) u through a face, for every balance that needs it.
#pragma once

#include "scree/closures/drag.hpp"
#include "scree/kernels/gas_slip.hpp"
#include "scree/kernels/solids_flux.hpp"

namespace scree {

/// Superficial velocity along +axis that the condition at the lower `axis` face of I, on a side, lets in [m/s].
inline double given_gas_flux(const Scene& scene, int axis, const Index& I) {
  const double inflow = gas_inflow(scene.condition(axis, I), face_extent(scene, axis, I), scene.time);
  return box_above(scene, axis, I) ? inflow : -inflow;
}

/// Adds the inputs of gas_flux for the lower `axis` face of anchor + at.
template <class L>
constexpr void add_gas_flux_inputs(StencilBuilder& s, int axis, const Index& at) {
  s.add(L::nu, at - unit(axis));
  s.add(L::nu, at);
  if (L::has_u) {
    s.add(L::u(axis), at);
  } else {
    s.add(L::v(axis), at);
    add_pressure_gradient_inputs<L>(s, axis, at);
  }
}

/// (1-nu) u at the lower `axis` face of I + at [m/s], with the mean of nu: 0 at walls.
template <class L, class Q>
auto gas_flux(const Scene& scene, const Index& I, const Q& q, int axis, const Index& at) {
  using Flux = std::conditional_t<L::has_u, typename Q::template Few<3>, typename Q::Number>;
  const Index face = I + at;
  if (closed_to_gas(scene, axis, face)) return Flux(0.0);
  if (scene.barrier(axis, face) && scene.kind(axis, face).brings_gas()) return Flux(given_gas_flux(scene, axis, face));
  const auto nu = face_solids_fraction<L>(scene, I, q, axis, at);
  if constexpr (L::has_u) {
    return Flux(GasContinuity::flux(nu, q(L::u(axis), at)));
  } else {
    const auto gradient = pressure_gradient<L>(scene, I, q, axis, at);
    const auto squared = pressure_gradient_squared<L>(scene, I, q, axis, at);
    const auto mobility = through(
        [&](const auto& nu_, const auto& squared_) {
          return darcy_mobility(nu_, squared_, scene.model.darcy_solids_fraction, scene.solids.kinetic.d, scene.gas());
        },
        nu, squared);
    return Flux(GasContinuity::flux(nu, q(L::v(axis), at) - mobility * gradient));
  }
}

}  // namespace scree
