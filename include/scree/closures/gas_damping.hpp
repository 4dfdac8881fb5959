/// What interstitial gas does to the kinetic closures: damped mu* and k*, eq. (1.5), and J_vis, eq. (1.8).
#pragma once

#include "scree/closures/kinetic.hpp"

namespace scree {

/// mu*/mu (weight 2 beta mu) and k*/k (weight 6/5 beta k) of (1.5), multiplied through by nu g0 sqrt(T), so that
/// T -> 0 and nu -> 0 are harmless. `drag_over_nu` = beta/nu [kg/(m3 s)] stays positive at nu = 0, beta does not.
/// `coefficient` = weight times mu (or k) divided by beta sqrt(T) [kg/m2]. Valid for drag_over_nu > 0 or nu > 0.
template <class Number>
Number gas_damping(const Number& nu, const Number& g0, const Number& sqrt_T, const Number& drag_over_nu,
                   double coefficient, const KineticParameters& p) {
  const Number collisions = (p.rho_s * p.rho_s) * (nu * g0 * sqrt_T);
  return collisions / (collisions + coefficient * drag_over_nu);
}

/// mu_s with gas: as the one without, mu* in the place of mu in the first term of the braces of (1.1) [Pa s].
template <class Number>
Number shear_viscosity(const Number& nu, const Number& sqrt_T, const Number& drag_over_nu, const KineticParameters& p) {
  const Number g0 = radial_distribution(nu, p);
  const double coefficient = 2 * 5 * p.rho_s * p.d * sqrt_pi / 96;
  const Number damping = gas_damping(nu, g0, sqrt_T, drag_over_nu, coefficient, p);
  const Number factor = damping * streaming_shear_factor(nu, g0, p) + (2 + p.alpha) / 5 * bulk_factor(nu, g0, p);
  return p.rho_s * p.d * factor * sqrt_T;
}

/// kappa with gas: k* in the place of k in (1.3) [kg/(m s)].
template <class Number>
Number conductivity(const Number& nu, const Number& sqrt_T, const Number& drag_over_nu, const KineticParameters& p) {
  const Number g0 = radial_distribution(nu, p);
  const double coefficient = 6.0 / 5 * 75 * p.rho_s * p.d * sqrt_pi / (48 * eta(p) * (41 - 33 * eta(p)));
  const Number damping = gas_damping(nu, g0, sqrt_T, drag_over_nu, coefficient, p);
  return p.rho_s * p.d * (damping * conductivity_factor(nu, g0, p)) * sqrt_T;
}

/// J_vis, eq. (1.8) [W/m3]; negative where the slip w = |v - u| agitates the particles more than drag damps them.
/// The second term is singular as T -> 0: 1/sqrt(T) is limited to 1/(sqrt(T) + 1e-5 m/s), which leaves a source that
/// lifts T off zero (departure from the paper; .1 % at sqrt(T) = 1 cm/s).
template <class Number>
Number viscous_dissipation(const Number& nu, const Number& T, const Number& sqrt_T, const Number& beta,
                           const Number& slip_speed_squared, double mu_g, const KineticParameters& p) {
  constexpr double sqrt_T_limit = 1e-5;
  const Number agitation = (81 * mu_g * mu_g / (p.d * p.d * p.d * p.rho_s * sqrt_pi)) * nu * slip_speed_squared /
                           (radial_distribution(nu, p) * (sqrt_T + sqrt_T_limit));
  return 3.0 * beta * T - agitation;
}

}  // namespace scree
