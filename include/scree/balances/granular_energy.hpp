/// Balance of pseudo-thermal energy, eq. (9), row of T at cell centres [W/m3]:
///
///     (3/2) rho_s nu (dT/dt + v.grad T) = -div q - sigma_k : grad v - J_coll - J_vis
///
///     term                        function        kernel that evaluates it
///     (3/2) rho_s nu dT/dt        storage         CellBalances (cell_balances.hpp)
///     (3/2) rho_s nu v.grad T     advection       ScalarFluxes (scalar_fluxes.hpp)
///     q of (1.3)                  conduction      ScalarFluxes
///                                 (26)            WallLaws (wall_laws.hpp)
///     -sigma_k : grad v - J_coll - J_vis          CellBalances, CellClosure::energy_source of
///     closures/solids_closures.hpp
///
/// Only the kinetic stress feeds T: the work of the frictional stress goes to heat.
#pragma once

#include "scree/grid/unknown.hpp"

namespace scree {

/// T, the granular temperature, where the case transports it.
struct GranularEnergy {
  static double scale(const Scales& s) { return s.velocity * s.velocity; }
  static double row_scale(const Scales& s, double rho_s) { return s.time / (rho_s * s.velocity * s.velocity); }
  /// Keeps a share of its value: 1 % in an iterate, half in a first guess.
  static NewtonBounds bounds(double T, const NewtonContext& c) {
    NewtonBounds b;
    b.lower = (c.first_guess ? 0.5 : 0.01) * T;
    return b;
  }

  static constexpr Unknown unknown{"granular_temperature",
                                   "T",
                                   "m2/s2",
                                   "granular temperature, (9)",
                                   Place::cell,
                                   scale,
                                   row_scale,
                                   ErrorNorm::with_particles,
                                   bounds,
                                   {"granular temperature", Allowed::non_negative, 1e-4},
                                   {"of what an inlet brings", Allowed::non_negative},
                                   true};

  /// (3/2) rho_s [kg/m3], what T is multiplied by in storage and advection beside nu.
  static double capacity(double rho_s) { return 1.5 * rho_s; }
  /// (3/2) rho_s nu dT/dt [W/m3].
  template <class X, class Y>
  static auto storage(double rho_s, const X& nu, const Y& T_dot) {
    return capacity(rho_s) * nu * T_dot;
  }
  /// Energy that the volume flux F = nu v carries through a face, beyond that of `own` [W/m2].
  template <class X, class Y, class Z>
  static auto advection(double rho_s, const X& F, const Y& carried, const Z& own) {
    return capacity(rho_s) * F * (carried - own);
  }
  /// q of (1.3), gradient = dT/dx [W/m2].
  template <class X, class Y>
  static auto conduction(const X& kappa, const Y& gradient) {
    return -kappa * gradient;
  }
};

}  // namespace scree
