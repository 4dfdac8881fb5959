/// Friction that grows with the inertial number: mu(I) of Jop, Forterre & Pouliquen (2006) in the yield surface (14),
///
///     A = -sqrt(2) p_f M(I) {n - (n-1) chi^(1/(n-1))},  M(I) = sin(phi) + (mu_2 - sin(phi)) I/(I + I_0),
///     I = d sqrt(2) gamma sqrt(rho_s/p_f),
///
/// gamma being the strain rate of (20). `mu_i` keeps (13) with M in place of sin(phi). Barker et al. (2017) show when
/// such a law is well-posed; of their conditions the one on the flow rule, with y = n - (n-1) chi^(1/(n-1)), gives
///
///     div v = sqrt(2) gamma {n (1 - chi^(1/(n-1))) Mbar - y (M - Mbar)/2},  Mbar = 1/I int_0^I M,
///
/// for `cidr`. With w = (M - Mbar)/2 this reads
///
///     chi^(1/(n-1)) = 1 - (div v + sqrt(2) gamma w)/(sqrt(2) gamma (n Mbar - (n-1) w)),
///
/// which is (21) with other arguments: n changes where div v + sqrt(2) gamma w does its sign, at chi = 1.
///
/// Where nothing changes the volume, short waves under `mu_i` grow without bound at small and at great I: where
/// 4 q^2 - 4 q + M^2 (1 - q/2)^2 > 0, q = I M'/M; Barker, Schaeffer, Bohorquez & Gray (2015), J. Fluid Mech. 779, 794.
/// `mu_i_regularised` has the M of Barker & Gray (2017), J. Fluid Mech. 828, 5, which is well-posed up to an I of 15:
///
///     M = sqrt(alpha/ln(A/I)) below I_1,  (sin(phi) I_0 + mu_2 I + mu_infinity I^2)/(I_0 + I) from there on,
///
/// with alpha = 1.9, mu_infinity = 0.05 and the A that makes M continuous. I_1 is the least I at which `mu_i` is
/// well-posed. There is no strength at rest: M goes to 0 with I, as slowly as a logarithm.
#pragma once

#include "scree/closures/friction.hpp"

namespace scree {

/// I_1; NaN where mu(I) rises too little to be well-posed at any I [-].
double neutral_inertial_number(const FrictionParameters& p);

/// {M, Mbar} of p_f [Pa] and gamma [1/s]; both mu_2 where there is no pressure, and both M for mu_i_regularised, which
/// takes no mean. Compiled for double and Dual<2>.
template <class Number>
std::array<Number, 2> inertial_coefficients(const Number& p_f, const Number& gamma, const FrictionParameters& p);

/// The law at a point as what (14) and (21) of friction.hpp need.
template <class Number>
struct InertialPoint {
  Number ratio;      ///< M/sin(phi): what yield_factor is multiplied by [-]
  Number div_v;      ///< div v beyond that of chi = 1: in the place of div v in chi_star [1/s]
  Number flow_rate;  ///< in the place of gamma in chi_star [1/s]
};

/// For a coefficient other than `constant`.
template <class Number>
InertialPoint<Number> inertial_point(const Number& p_f, const Number& div_v, const Number& gamma,
                                     const FrictionParameters& p) {
  const auto [M, mean] =
      through([&](const auto& p_f_, const auto& gamma_) { return inertial_coefficients(p_f_, gamma_, p); }, p_f, gamma);
  const double mu_s = std::sin(p.phi);
  if (p.coefficient != FrictionCoefficient::cidr) return {M / mu_s, div_v, gamma * M / mu_s};
  const Number w = (M - mean) / 2.0, beyond = div_v + std::sqrt(2.0) * (gamma * w);
  const double n = yield_exponent(beyond, p);
  return {M / mu_s, beyond, gamma * (mean - (n - 1) / n * w) / mu_s};
}

}  // namespace scree
