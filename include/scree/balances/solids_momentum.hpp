/// Balance of momentum of the particles, eq. (3), rows of v at the lower faces of each axis [N/m3]:
///
///     rho_s nu (dv/dt + v.grad v) = -div sigma_s - nu div sigma_g + f + rho_s nu g
///
///     term                        function        kernel that evaluates it
///     rho_s nu dv/dt              inertia         FaceForces (face_forces.hpp)
///     rho_s nu v.grad v           advection       NormalMomentumFlux, CrossMomentumFlux (momentum_fluxes.hpp)
///     div sigma_s, sigma_s of (8) normal_stress   CellBalances (cell_balances.hpp)
///                                 shear_stress    EdgeStress (edge_stress.hpp)
///                                 at surfaces     SurfaceStress (surface_stress.hpp)
///                                 (25)            WallLaws (wall_laws.hpp)
///     nu div sigma_g, (5)         gas_pressure    GasForces (gas_forces.hpp)
///                                 gas_stress      GasNormalStress, GasShearStress, GasWallStress (gas_viscosity.hpp)
///     f = beta (u - v), (6)       drag            CellBalances
///     rho_s nu g                  weight          FaceForces
///     - (where nu -> 0)           void_drag       FaceForces; with an unknown u the drag of CellBalances
///
/// The advective form is the conservative one minus v times (1), with the same flux. Without gas nu of inertia and
/// weight is that before the step of backward Euler: nu v - nu_before v_before = nu_before (v - v_before) + v (nu -
/// nu_before), so that momentum is conserved to rounding whatever passes a face in a step, and what falls freely gains
/// g dt. p_g is what exceeds the pressure of still gas, so that the weight is reduced by buoyancy. Without particles
/// (3) says nothing: closures/voids.hpp adds a floor to nu in inertia and a drag that lets v decay.
#pragma once

#include "scree/grid/unknown.hpp"

namespace scree {

/// v, the velocity of the particles.
struct SolidsMomentum {
  static double scale(const Scales& s) { return s.velocity; }
  static double row_scale(const Scales& s, double rho_s) { return s.time / (rho_s * s.velocity); }

  static constexpr Unknown unknown{"velocity",  "v",
                                   "m/s",       "particle velocity, (3)",
                                   Place::face, scale,
                                   row_scale,   ErrorNorm::with_particles,
                                   unbounded,   {"velocity of the particles", Allowed::any},
                                   {}};

  /// rho_s nu dv/dt [N/m3].
  template <class X, class Y>
  static auto inertia(double rho_s, const X& nu, const Y& v_dot) {
    return rho_s * nu * v_dot;
  }
  /// Momentum that the volume flux F = nu v carries through a face, beyond that of `own`, the volume it enters [Pa].
  template <class X, class Y, class Z>
  static auto advection(double rho_s, const X& F, const Y& carried, const Z& own) {
    return rho_s * F * (carried - own);
  }
  /// sigma_aa of (8), sigma_s = p I - 2 mu S [Pa].
  template <class X, class Y, class Z>
  static auto normal_stress(const X& p, const Y& mu, const Z& S_aa) {
    return p - 2.0 * mu * S_aa;
  }
  /// sigma_ab of (8) [Pa].
  template <class X, class Y>
  static auto shear_stress(const X& mu, const Y& D_ab) {
    return -2.0 * mu * D_ab;
  }
  /// nu grad p_g [N/m3].
  template <class X, class Y>
  static auto gas_pressure(const X& nu, const Y& gradient) {
    return nu * gradient;
  }
  /// nu div of the viscous gas stress, from its divergence [N/m3].
  template <class X, class Y>
  static auto gas_stress(const X& nu, const Y& divergence) {
    return nu * divergence;
  }
  /// f of (6), slip = u - v [N/m3].
  template <class X, class Y>
  static auto drag(const X& beta, const Y& slip) {
    return beta * slip;
  }
  /// Weight less buoyancy: rho = rho_s - rho_g, g along the axis [N/m3].
  template <class Number>
  static Number weight(double rho, double g, const Number& nu) {
    return (rho * g) * nu;
  }
  /// floor rho_s v/t_d, what slows particles in voids of a scene without gas velocity [N/m3].
  template <class X, class Y>
  static auto void_drag(double rho_s, double t_d, const X& floor, const Y& v) {
    return (rho_s / t_d) * floor * v;
  }
};

}  // namespace scree
