/// Kinetic theory of granular materials: pressure, viscosities, conductivity and dissipation,
/// eqs. (1.1)-(1.7) of Srivastava & Sundaresan (2003), Table 1, without gas (gas_damping.hpp adds it).
#pragma once

#include <limits>

#include "scree/closures/correlation_length.hpp"
#include "scree/closures/effective_restitution.hpp"
#include "scree/closures/radial_distribution.hpp"
#include "scree/math/constants.hpp"
#include "scree/math/dual.hpp"

namespace scree {

/// Where the granular temperature comes from: balance (9), production = dissipation, or a given constant.
enum class TemperatureModel { transport, algebraic, constant };

/// Parameters of the kinetic closures (SI units).
struct KineticParameters {
  double rho_s = 2900.0;  ///< solids density [kg/m3]
  double d = 1e-3;        ///< particle diameter [m]
  double e_p = 0.91;      ///< particle-particle restitution [-]
  double nu_max = 0.65;   ///< maximum solids packing [-]
  double alpha = 1.6;     ///< constant of (1.1) [-]
  double T_rest = 0;      ///< transported T that collisions leave at nu_max [m2/s2]
  const RadialDistribution* g0 = default_radial_distribution();  ///< one of radial_distributions()
  double mu_p = 0;  ///< coefficient of friction between particles, in the dissipation alone [-]
  const EffectiveRestitution* e_eff = default_effective_restitution();  ///< one of effective_restitutions()
  const CorrelationLength* length = nullptr;  ///< L in the dissipation, one of correlation_lengths(); none: L = d
  double length_constant = 0.5;               ///< c of `jenkins` [-]
};

/// eta = (1 + e_p)/2 [-].
inline double eta(const KineticParameters& p) { return (1 + p.e_p) / 2; }

/// Restitution that the dissipation takes: e_p, with friction between particles the effective one [-].
inline double dissipation_restitution(const KineticParameters& p) {
  return p.mu_p == 0 ? p.e_p : p.e_eff->e_eff(p.e_p, p.mu_p);
}

/// 48/sqrt(pi) eta (1 - eta) of (1.4), with dissipation_restitution [-].
inline double dissipation_constant(const KineticParameters& p) {
  const double eta_J = (1 + dissipation_restitution(p)) / 2;
  return 48 / sqrt_pi * eta_J * (1 - eta_J);
}

/// sqrt(T + floor) [m/s]: the square root that all closures use, with a finite derivative at T = 0. `floor` in m2/s2.
template <class Number>
Number sqrt_temperature(const Number& T, double floor) {
  return sqrt(T + floor);
}

/// Radial distribution at contact g0 by the variant of the case, eq. (1.7) by default [-]; infinite from nu_max on:
/// such a trial state is for the solver to refuse.
template <class Number>
Number radial_distribution(const Number& nu, const KineticParameters& p) {
  if (nu >= p.nu_max) return Number(std::numeric_limits<double>::infinity());
  return by_one_argument<RadialDistributionFunction>(p.g0->g0, nu, p.nu_max);
}

// The dependence of the closures on nu, dimensionless; g0 is passed because all share it.

/// p_k = factor rho_s T.
template <class Number>
Number pressure_factor(const Number& nu, const Number& g0, const KineticParameters& p) {
  return nu * (1.0 + 4 * eta(p) * (nu * g0));
}

/// eta mu_b = factor rho_s d sqrt(T).
template <class Number>
Number bulk_factor(const Number& nu, const Number& g0, const KineticParameters& p) {
  return (eta(p) * 256 / (5 * pi) * 5 * sqrt_pi / 96) * (nu * nu * g0);
}

/// The part of mu_s that mu* of (1.5) multiplies: factor rho_s d sqrt(T) = (2+alpha)/3 mu/(g0 eta (2-eta)) (...)(...).
/// Division by g0 carried out, as everywhere: nothing here is large minus large, and nu = 0 is no special case.
template <class Number>
Number streaming_shear_factor(const Number& nu, const Number& g0, const KineticParameters& p) {
  const double e = eta(p), a = 8.0 / 5 * e, b = 8.0 / 5 * e * (3 * e - 2);
  const double scale = (2 + p.alpha) / 3 * 5 * sqrt_pi / 96 / (e * (2 - e));
  return scale * (1.0 / g0 + nu * (a + b) + (a * b) * (nu * nu * g0));
}

/// mu_s = factor rho_s d sqrt(T).
template <class Number>
Number shear_factor(const Number& nu, const Number& g0, const KineticParameters& p) {
  return streaming_shear_factor(nu, g0, p) + (2 + p.alpha) / 5 * bulk_factor(nu, g0, p);
}

/// kappa = factor rho_s d sqrt(T).
template <class Number>
Number conductivity_factor(const Number& nu, const Number& g0, const KineticParameters& p) {
  const double e = eta(p), a = 12.0 / 5 * e, b = 12.0 / 5 * e * e * (4 * e - 3), c = 41 - 33 * e;
  const double scale = 75 * sqrt_pi / (48 * e * c);
  return scale * (1.0 / g0 + nu * (a + b) + (a * b + 64 / (25 * pi) * c * e * e) * (nu * nu * g0));
}

/// J_coll = factor rho_s T^(3/2)/L.
template <class Number>
Number collision_dissipation_factor(const Number& nu, const Number& g0, const KineticParameters& p) {
  return dissipation_constant(p) * (nu * nu * g0);
}

/// J_coll = factor rho_s T^(3/2)/d.
template <class Number>
Number dissipation_factor(const Number& nu, const Number& g0, const KineticParameters& p) {
  const Number collisions = collision_dissipation_factor(nu, g0, p);
  return p.length ? collisions / by_one_argument<CorrelationLengthFunction>(p.length->ratio, nu, p) : collisions;
}

/// Kinetic pressure rho_s nu (1 + 4 eta nu g0) T of (1.1), without its bulk term [Pa].
template <class Number>
Number kinetic_pressure(const Number& nu, const Number& T, const KineticParameters& p) {
  return p.rho_s * pressure_factor(nu, radial_distribution(nu, p), p) * T;
}

/// eta mu_b of (1.1) [Pa s]: the kinetic pressure is lowered by eta mu_b div v.
template <class Number>
Number bulk_viscosity(const Number& nu, const Number& sqrt_T, const KineticParameters& p) {
  return p.rho_s * p.d * bulk_factor(nu, radial_distribution(nu, p), p) * sqrt_T;
}

/// mu_s such that the deviator of (1.1) is -2 mu_s S [Pa s].
template <class Number>
Number shear_viscosity(const Number& nu, const Number& sqrt_T, const KineticParameters& p) {
  return p.rho_s * p.d * shear_factor(nu, radial_distribution(nu, p), p) * sqrt_T;
}

/// kappa such that (1.3) is q = -kappa grad T [kg/(m s)].
template <class Number>
Number conductivity(const Number& nu, const Number& sqrt_T, const KineticParameters& p) {
  return p.rho_s * p.d * conductivity_factor(nu, radial_distribution(nu, p), p) * sqrt_T;
}

/// T that collisions leave near nu_max: T_rest (nu/nu_max)^32, 2 % of it at nu = 0.58, 2e-11 at 0.3 [m2/s2]. Nothing in
/// the model but T carries a bed without friction: as T dies down nu goes to nu_max at a finite T/(nu_max - nu), where
/// each grain is locked and Newton's method loses its way.
template <class Number>
Number temperature_at_rest(const Number& nu, const KineticParameters& p) {
  return p.T_rest * integer_power(nu / p.nu_max, 32);
}

/// J_coll, eq. (1.4), `factor` from dissipation_factor [W/m3]. T^(3/2) = T sqrt_T: vanishes at T = 0 whatever the floor
/// in sqrt_T, changes sign with T; with T_rest, at temperature_at_rest.
template <class Number>
Number dissipation_by(const Number& factor, const Number& nu, const Number& T, const Number& sqrt_T,
                      const KineticParameters& p) {
  const Number rate = p.rho_s / p.d * factor * sqrt_T;
  return p.T_rest > 0 ? rate * (T - temperature_at_rest(nu, p)) : rate * T;
}

/// The same from nu.
template <class Number>
Number dissipation(const Number& nu, const Number& T, const Number& sqrt_T, const KineticParameters& p) {
  return dissipation_by(dissipation_factor(nu, radial_distribution(nu, p), p), nu, T, sqrt_T, p);
}

/// The factors above at once; the last two, g0 itself and streaming_shear_factor, are for the effect of a gas.
enum KineticFactor : std::size_t {
  factor_pressure,
  factor_bulk,
  factor_shear,
  factor_dissipation,
  factors_without_gas,
  factor_g0 = factors_without_gas,
  factor_streaming,
  factors_with_gas
};

/// The first `count` factors, indexed by KineticFactor; one evaluation of g0, differentiated with respect to nu alone.
template <std::size_t count = factors_without_gas, class Number>
std::array<Number, count> kinetic_factors(const Number& nu, const KineticParameters& p) {
  return through(
      [&](const auto& x) {
        using Inner = std::decay_t<decltype(x)>;
        const Inner g0 = radial_distribution(x, p);
        std::array<Inner, count> f;
        f[factor_pressure] = pressure_factor(x, g0, p);
        f[factor_bulk] = bulk_factor(x, g0, p);
        f[factor_shear] = shear_factor(x, g0, p);
        f[factor_dissipation] = dissipation_factor(x, g0, p);
        if constexpr (count == factors_with_gas) {
          f[factor_g0] = g0;
          f[factor_streaming] = streaming_shear_factor(x, g0, p);
        }
        return f;
      },
      nu);
}

/// fJ of local equilibrium, factor_dissipation held up below nu of about 1e-3: in the dilute limit T would grow as
/// 1/nu^2, but there the free path is hundreds of diameters and local equilibrium means nothing (relative change of T
/// 5e-9 at nu = 0.1, less above).
template <class Number>
Number local_dissipation_factor(const Number& fJ, const KineticParameters& p) {
  constexpr double dilute = 1e-3;
  const double J_dilute = dissipation_constant(p) * dilute * dilute;
  return sqrt(fJ * fJ + J_dilute * J_dilute);
}

/// sqrt(T) of local equilibrium -sigma_k : grad v = J_coll, eqs. (1.1) and (1.4) without gas [m/s].
/// With sigma = sqrt(T)/d and the factors f of kinetic_factors this is the positive root of
///     fJ sigma^2 + fp div_v sigma - (2 fmu S_S + fb div_v^2 + fJ floor/d^2) = 0,  fJ from local_dissipation_factor,
/// where `floor` [m2/s2] makes T = floor at rest, which keeps the derivatives finite there (T >= floor in shear at
/// constant volume; dilation may take it below).
template <class Number, std::size_t count>
Number algebraic_sqrt_temperature(const std::array<Number, count>& factors, const Number& div_v, const Number& S_S,
                                  const KineticParameters& p, double floor) {
  const Number fJ = local_dissipation_factor(factors[factor_dissipation], p);
  const Number b = factors[factor_pressure] * div_v;
  const Number c =
      2.0 * factors[factor_shear] * S_S + factors[factor_bulk] * (div_v * div_v) + fJ * (floor / (p.d * p.d));
  const Number root = sqrt(b * b + 4.0 * fJ * c);
  // Two forms of one root; the sign of b says which of them does not cancel.
  return p.d * (b >= 0.0 ? 2.0 * c / (b + root) : (root - b) / (2.0 * fJ));
}

/// The same from nu.
template <class Number>
Number algebraic_sqrt_temperature(const Number& nu, const Number& div_v, const Number& S_S, const KineticParameters& p,
                                  double floor) {
  return algebraic_sqrt_temperature(kinetic_factors(nu, p), div_v, S_S, p, floor);
}

}  // namespace scree
