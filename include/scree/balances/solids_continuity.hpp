/// Balance of the volume of particles, eq. (1), row of nu at cell centres [1/s]:
///
///     d(nu)/dt + div(nu v) = 0
///
///     term              function   kernel that evaluates it
///     d(nu)/dt          storage    CellBalances (cell_balances.hpp)
///     div(nu v)         flux       ScalarFluxes (scalar_fluxes.hpp), from solids_flux.hpp
///
/// The flux through a face is computed once, in solids_flux.hpp, for every balance that is carried by the particles.
#pragma once

#include "scree/grid/unknown.hpp"

namespace scree {

/// nu, the solids volume fraction. It stands first in every node.
struct SolidsContinuity {
  static double scale(const Scales&) { return 1; }
  static double row_scale(const Scales& s, double) { return s.time; }
  /// At most 0.7 of what is left to nu_max, and not below zero.
  static NewtonBounds bounds(double nu, const NewtonContext& c) { return {0, nu + 0.7 * (c.nu_max - nu)}; }

  static constexpr Unknown unknown{"solids_fraction",
                                   "nu",
                                   "1",
                                   "solids volume fraction, (1)",
                                   Place::cell,
                                   scale,
                                   row_scale,
                                   ErrorNorm::everywhere,
                                   bounds,
                                   {"solids fraction in the region", Allowed::solids_fraction},
                                   {"of what an inlet brings", Allowed::solids_fraction, 0, true}};

  /// d(nu)/dt [1/s].
  template <class Number>
  static Number storage(const Number& nu_dot) {
    return nu_dot;
  }
  /// nu v through a face, `nu` being the upstream value [m/s].
  template <class Flow, class Number>
  static auto flux(const Flow& v, const Number& nu) {
    return v * nu;
  }
};

}  // namespace scree
