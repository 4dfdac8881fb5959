/// What interstitial gas does to the kinetic closures: damped mu* and k*, eq. (1.5), and J_vis, eq. (1.8).
#pragma once

#include <algorithm>

#include "scree/closures/drag.hpp"
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

/// `coefficient` of gas_damping for mu* [kg/m2].
inline double shear_damping_coefficient(const KineticParameters& p) { return 2 * 5 * p.rho_s * p.d * sqrt_pi / 96; }

/// `coefficient` of gas_damping for k* [kg/m2].
inline double conductivity_damping_coefficient(const KineticParameters& p) {
  return 6.0 / 5 * 75 * p.rho_s * p.d * sqrt_pi / (48 * eta(p) * (41 - 33 * eta(p)));
}

/// mu_s with gas = factor rho_s d sqrt(T): as the one without, mu* in the place of mu in the first term of the braces
/// of (1.1). `streaming` and `bulk` from streaming_shear_factor and bulk_factor, damping = mu*/mu.
template <class Number>
Number damped_shear_factor(const Number& streaming, const Number& bulk, const Number& damping,
                           const KineticParameters& p) {
  return damping * streaming + (2 + p.alpha) / 5 * bulk;
}

/// mu_s with gas [Pa s].
template <class Number>
Number shear_viscosity(const Number& nu, const Number& sqrt_T, const Number& drag_over_nu, const KineticParameters& p) {
  const Number g0 = radial_distribution(nu, p);
  const Number damping = gas_damping(nu, g0, sqrt_T, drag_over_nu, shear_damping_coefficient(p), p);
  const Number factor = damped_shear_factor(streaming_shear_factor(nu, g0, p), bulk_factor(nu, g0, p), damping, p);
  return p.rho_s * p.d * factor * sqrt_T;
}

/// kappa with gas: k* in the place of k in (1.3) [kg/(m s)].
template <class Number>
Number conductivity(const Number& nu, const Number& sqrt_T, const Number& drag_over_nu, const KineticParameters& p) {
  const Number g0 = radial_distribution(nu, p);
  const Number damping = gas_damping(nu, g0, sqrt_T, drag_over_nu, conductivity_damping_coefficient(p), p);
  return p.rho_s * p.d * (damping * conductivity_factor(nu, g0, p)) * sqrt_T;
}

/// Limit of the second term of (1.8), which is singular as T -> 0: 1/sqrt(T) becomes 1/(sqrt(T) + limit) [m/s], which
/// leaves a source that lifts T off zero (departure from the paper; 0.1 % at sqrt(T) = 1 cm/s).
inline constexpr double agitation_limit = 1e-5;

/// Second term of (1.8), by which the slip |v - u| agitates the particles, times sqrt(T) + agitation_limit [kg/s4].
template <class Number>
Number slip_agitation(const Number& nu, const Number& g0, const Number& slip_squared, double mu_g,
                      const KineticParameters& p) {
  return (81 * mu_g * mu_g / (p.d * p.d * p.d * p.rho_s * sqrt_pi)) * nu * slip_squared / g0;
}

/// J_vis, eq. (1.8) [W/m3]; negative where slip agitates the particles more than drag damps them. `agitation` from
/// slip_agitation.
template <class Number>
Number viscous_dissipation(const Number& T, const Number& sqrt_T, const Number& beta, const Number& agitation) {
  return 3.0 * beta * T - agitation / (sqrt_T + agitation_limit);
}

/// The same from nu and |v - u|^2.
template <class Number>
Number viscous_dissipation(const Number& nu, const Number& T, const Number& sqrt_T, const Number& beta,
                           const Number& slip_squared, double mu_g, const KineticParameters& p) {
  return viscous_dissipation(T, sqrt_T, beta, slip_agitation(nu, radial_distribution(nu, p), slip_squared, mu_g, p));
}

/// What gas adds to kinetic_factors at a point.
template <class Number>
struct GasEffect {
  Number drag_over_nu{0.0};  ///< beta/nu [kg/(m3 s)]
  Number drag{0.0};          ///< beta [kg/(m3 s)]
  Number agitation{0.0};     ///< slip_agitation [kg/s4]
};

/// In the place of a GasEffect where there is no gas.
struct NoGas {};

/// Factors with g0 and streaming_shear_factor.
template <class Number>
using GasFactors = std::array<Number, factors_with_gas>;

/// The effect of a gas, slip_squared = |v - u|^2, `factors` from kinetic_factors.
template <class Number>
GasEffect<Number> gas_effect(const Number& nu, const GasFactors<Number>& factors, const Number& slip_squared,
                             const KineticParameters& p, const GasParameters& gas) {
  const Number per_nu = drag_over_nu(nu, slip_squared, p.d, gas);
  return {per_nu, nu * per_nu, slip_agitation(nu, factors[factor_g0], slip_squared, gas.mu_g, p)};
}

/// mu_s with gas = factor rho_s d sqrt(T), `factors` from kinetic_factors.
template <class Number>
Number damped_shear_factor(const Number& nu, const GasFactors<Number>& factors, const GasEffect<Number>& gas,
                           const Number& sqrt_T, const KineticParameters& p) {
  const Number damping = gas_damping(nu, factors[factor_g0], sqrt_T, gas.drag_over_nu, shear_damping_coefficient(p), p);
  return damped_shear_factor(factors[factor_streaming], factors[factor_bulk], damping, p);
}

/// The same without gas.
template <class Number, std::size_t count>
Number damped_shear_factor(const Number&, const std::array<Number, count>& factors, NoGas, const Number&,
                           const KineticParameters&) {
  return factors[factor_shear];
}

/// Local equilibrium -sigma_k : grad v = J_coll + J_vis as an equation for s = sqrt(T): production minus loss, divided
/// by rho_s s^2 [1/s]. It falls and is convex in s > 0, from infinity to minus infinity: there is one root.
template <class Number>
struct GasEquilibrium {
  Number nu, g0, drag_over_nu;  ///< of the damping of (1.5)
  Number streaming;             ///< 2 streaming_shear_factor d S:S, undamped [m/s2]
  Number rest;                  ///< production proportional to s without damping, and the floor of J_coll [m/s2]
  Number drag_floor;            ///< 3 beta floor/rho_s: drag damps T - floor [m2/s3]
  Number agitation;             ///< of (1.8) [m3/s4]
  Number pressure;              ///< loss to dilation and drag [1/s]
  Number collisions;            ///< loss to J_coll [1/m]

  Number excess(const Number& s, const KineticParameters& p) const {
    const Number damping = gas_damping(nu, g0, s, drag_over_nu, shear_damping_coefficient(p), p);
    return (rest + streaming * damping + drag_floor / s) / s + agitation / (s * s * (s + agitation_limit)) - pressure -
           collisions * s;
  }

  /// The same for another number type, derivatives dropped.
  template <class Other>
  GasEquilibrium<Other> values() const {
    const auto plain = [](const Number& x) { return Other(value_of(x)); };
    return {plain(nu),         plain(g0),        plain(drag_over_nu), plain(streaming), plain(rest),
            plain(drag_floor), plain(agitation), plain(pressure),     plain(collisions)};
  }
};

/// A number below the root of GasEquilibrium, of its order where production is not that of `streaming`: the largest of
/// sqrt(floor)/2 if it is below, the root without agitation and (a bound for) the one with nothing but agitation.
inline double below_equilibrium(const GasEquilibrium<double>& q, const KineticParameters& p, double floor) {
  const double root = std::sqrt(q.pressure * q.pressure + 4 * q.collisions * q.rest);
  double lower = q.pressure >= 0 ? 2 * q.rest / (q.pressure + root) : (root - q.pressure) / (2 * q.collisions);
  const double by_floor = std::sqrt(floor) / 2;
  if (q.excess(by_floor, p) > 0) lower = std::max(lower, by_floor);
  if (!(q.agitation > 0)) return lower;
  // Half of the agitation exceeds either loss where both terms of s + limit do so with a quarter.
  const auto bound = [&](double loss, int power) {
    const double ratio = q.agitation / (4 * loss);
    return std::min(std::pow(ratio, 1.0 / (power + 1)), std::pow(ratio / agitation_limit, 1.0 / power));
  };
  const double by_collisions = bound(q.collisions, 3);
  return std::max(lower, q.pressure > 0 ? std::min(by_collisions, bound(q.pressure, 2)) : by_collisions);
}

/// sqrt(T) of local equilibrium -sigma_k : grad v = J_coll + J_vis, eqs. (1.1), (1.4), (1.5) and (1.8) [m/s]; as the
/// one without gas, with the same floors: T = floor at rest without slip. Newton's method from below, which does not
/// overshoot, in plain doubles; the derivatives are those of one more step. `factors` from kinetic_factors.
template <class Number>
Number algebraic_sqrt_temperature(const Number& nu, const GasFactors<Number>& factors, const GasEffect<Number>& gas,
                                  const Number& div_v, const Number& S_S, const KineticParameters& p, double floor) {
  const Number fJ = local_dissipation_factor(factors[factor_dissipation], p);
  const Number drag = 3 / p.rho_s * gas.drag;
  const Number bulk_production = damped_shear_factor(Number(0.0), factors[factor_bulk], Number(0.0), p);
  const GasEquilibrium<Number> equilibrium{
      nu,
      factors[factor_g0],
      gas.drag_over_nu,
      (2 * p.d) * (factors[factor_streaming] * S_S),
      p.d * (2.0 * bulk_production * S_S + factors[factor_bulk] * (div_v * div_v)) + fJ * (floor / p.d),
      drag * floor,
      gas.agitation / p.rho_s,
      factors[factor_pressure] * div_v + drag,
      fJ / p.d};

  const auto plain = equilibrium.template values<Dual<1>>();
  double s = below_equilibrium(equilibrium.template values<double>(), p, floor), slope = 0;
  for (int iteration = 0; iteration < 100; ++iteration) {
    const Dual<1> excess = plain.excess(Dual<1>::variable(s, 0), p);
    slope = excess.derivative[0];
    const double step = -excess.value / slope;
    if (!(step > 1e-9 * s)) break;  // quadratic convergence: the next step reaches round-off
    s += step;
  }
  return s - equilibrium.excess(Number(s), p) / slope;
}

/// The same without gas.
template <class Number, std::size_t count>
Number algebraic_sqrt_temperature(const Number&, const std::array<Number, count>& factors, NoGas, const Number& div_v,
                                  const Number& S_S, const KineticParameters& p, double floor) {
  return algebraic_sqrt_temperature(factors, div_v, S_S, p, floor);
}

}  // namespace scree
