/// Nonlocal friction: the fluidity g_f of Kamrin & Koval (2012), Phys. Rev. Lett. 108, 178301, and Henann & Kamrin
/// (2013), PNAS 110, 6730. It is the rate of shear over the ratio of the stresses,
///
///     dev sigma_f = -2 p_f y(chi)/g_f S,   gdot = sqrt(2 S:S),   M = gdot/g_f,
///
/// y = n - (n-1) chi^(1/(n-1)) being 1 at the critical state, and has a balance of its own, in which grains that shear
/// make their neighbours yield:
///
///     t_0 (d(g_f)/dt + v.grad g_f) = A^2 d^2 lap g_f - mu_s g_f + gdot (1 - b d sqrt(rho_s/p_f) g_f).
///
/// Where it is uniform and steady, M = mu_s + b I with I = gdot d sqrt(rho_s/p_f): the linear form of mu(I). mu_s is
/// sin(phi), as M of slow flow is with every friction coefficient. The sources of 2013 and 2014 are for glass beads:
/// A = 0.48, b = 0.9377, mu_s = 0.3819. They write the balance with M in the place of gdot/g_f, where it is quadratic
/// in g_f and has no solution but 0 below mu_s; here friction is linear in S.
#pragma once

#include "scree/math/dual.hpp"

namespace scree {

/// Parameters of the balance of fluidity (SI units).
struct FluidityParameters {
  double A = 0.48;            ///< nonlocal amplitude: fluidity spreads over A d/sqrt(|mu_s - M|) [-]
  double b = 0.9377;          ///< slope of M over I [-]
  double t_0 = 1e-3;          ///< time in which it follows, over mu_s [s]
  double g_min = 1e-2;        ///< that of a bed at rest: how fast such a bed creeps [1/s]
  bool held_at_rough = true;  ///< whether walls without slip hold it at `at_rough`; else none passes through them
  double at_rough = 1e-2;     ///< at walls without slip [1/s]
};

/// Pressure that is added to p_f in the inertial number: nothing, but for a cell without friction [Pa].
inline constexpr double fluidity_pressure_floor = 1e-3;

/// mu_f of sigma_f = p_f I - 2 mu_f S, from y(chi) [Pa s].
template <class Number>
Number fluid_viscosity(const Number& p_f, const Number& y, const Number& g_f) {
  return p_f * y / g_f;
}

/// sqrt(2 S:S + (mu_s g_min)^2): the rate of shear, with the one that keeps g_f of a bed at rest at g_min [1/s].
template <class Number>
Number fluidity_shear_rate(const Number& S_S, double mu_s, const FluidityParameters& p) {
  const double rest = mu_s * p.g_min;
  return Number(sqrt(2.0 * S_S + rest * rest));
}

/// -mu_s g_f + gdot (1 - b d sqrt(rho_s/p_f) g_f): what the balance has beside storage and spreading [1/s].
template <class Number>
Number fluidity_source(const Number& g_f, const Number& p_f, const Number& S_S, double mu_s, double rho_s, double d,
                       const FluidityParameters& p) {
  const Number slowness = d * sqrt(rho_s / (p_f + fluidity_pressure_floor));  // I over the rate of shear
  return fluidity_shear_rate(S_S, mu_s, p) * (1.0 - p.b * slowness * g_f) - mu_s * g_f;
}

/// A^2 d^2, what the gradient of fluidity is multiplied by [m2].
inline double fluidity_spreading(double d, const FluidityParameters& p) { return p.A * p.A * d * d; }

}  // namespace scree
