/// Balance of momentum of the gas, eq. (4), rows of u at the lower faces of each axis [N/m3]:
///
///     rho_g (1-nu) (du/dt + u.grad u) = -(1-nu) div sigma_g - f + rho_g (1-nu) g
///
///     term                        function              kernel that evaluates it
///     rho_g (1-nu) du/dt          inertia               GasForces (gas_forces.hpp)
///     rho_g (1-nu) u.grad u       advection             NormalMomentumFlux, CrossMomentumFlux (momentum_fluxes.hpp)
///                                 entry_loss            NormalMomentumFlux, at open sides
///     (1-nu) div sigma_g, (5)     pressure_and_inertia  GasForces
///                                 viscous_stress        GasNormalStress, GasShearStress, GasWallStress
///                                                       (gas_viscosity.hpp)
///     f = beta (u - v), (6)       drag                  CellBalances (cell_balances.hpp)
///
/// Gravity is not there: p_g is what exceeds the pressure of still gas. Where the gas has no inertia (gas darcy), u is
/// no unknown: (4) without its left-hand side is solved at each face, see gas_flux.hpp.
#pragma once

#include "scree/grid/unknown.hpp"

namespace scree {

/// u, the velocity of the gas between the particles.
struct GasMomentum {
  static double scale(const Scales& s) { return s.velocity; }
  static double row_scale(const Scales& s, double) { return s.time / (s.density * s.velocity); }

  static constexpr Unknown unknown{"gas_velocity",
                                   "u",
                                   "m/s",
                                   "gas velocity between the particles, (4)",
                                   Place::face,
                                   scale,
                                   row_scale,
                                   ErrorNorm::gas_alone,
                                   unbounded,
                                   {"velocity of the gas, before it is made consistent with (2)", Allowed::any},
                                   {},
                                   true};

  /// rho_g (du/dt), to be multiplied by 1-nu with the pressure [N/m3].
  template <class Number>
  static Number inertia(double rho_g, const Number& u_dot) {
    return rho_g * u_dot;
  }
  /// Momentum that the volume flux F = (1-nu) u carries through a face, beyond that of `own` [Pa].
  template <class X, class Y, class Z>
  static auto advection(double rho_g, const X& F, const Y& carried, const Z& own) {
    return rho_g * F * (carried - own);
  }
  /// What gas that comes in from rest outside has lost of pressure, rho_g u^2/2: inflow = (1-nu) u into the box [Pa].
  template <class X, class Y>
  static auto entry_loss(double rho_g, const X& inflow, const Y& u) {
    return 0.5 * rho_g * inflow * u;
  }
  /// (1-nu) (grad p_g + inertia) [N/m3].
  template <class X, class Y, class Z>
  static auto pressure_and_inertia(const X& nu, const Y& gradient, const Z& inertia_) {
    return (1.0 - nu) * (gradient + inertia_);
  }
  /// (1-nu) div of the viscous gas stress, from its divergence [N/m3].
  template <class X, class Y>
  static auto viscous_stress(const X& nu, const Y& divergence) {
    return (1.0 - nu) * divergence;
  }
  /// f of (6), slip = u - v [N/m3].
  template <class X, class Y>
  static auto drag(const X& beta, const Y& slip) {
    return beta * slip;
  }
};

}  // namespace scree
