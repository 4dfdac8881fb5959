/// Balance of the volume of gas, eq. (2), added to that of the particles (1), row of p_g at cell centres [1/s]:
///
///     div(nu v + (1-nu) u) = 0
///
///     term              function   kernel that evaluates it
///     div(nu v)         -          GasVolumeFlux (gas_volume_flux.hpp), from solids_flux.hpp
///     div((1-nu) u)     flux       GasVolumeFlux, from gas_flux.hpp
///
/// The sum of (1) and (2) has no time derivative: what it says holds at every time, and nothing drifts.
#pragma once

#include "scree/grid/unknown.hpp"

namespace scree {

/// p_g, which exceeds the pressure of still gas.
struct GasContinuity {
  static double scale(const Scales& s) { return s.density * s.velocity * s.velocity; }
  static double row_scale(const Scales& s, double) { return s.time; }

  static constexpr Unknown unknown{"gas_pressure", "p_g", "Pa",      "gas pressure over that of still gas, (2)",
                                   Place::cell,    scale, row_scale, ErrorNorm::none,
                                   unbounded,      {},    {}};

  /// (1-nu) u through a face [m/s].
  template <class X, class Y>
  static auto flux(const X& nu, const Y& u) {
    return (1.0 - nu) * u;
  }
};

}  // namespace scree
