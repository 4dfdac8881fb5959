/// Solids stress sigma_s = sigma_k + sigma_f, eq. (8), and the source terms of T and chi at a point: what kernels need,
/// with shared subexpressions evaluated once.
#pragma once

#include "scree/closures/friction.hpp"
#include "scree/closures/gas_damping.hpp"
#include "scree/closures/rheology.hpp"

namespace scree {

/// Parameters of the solids closures (SI units).
struct SolidsParameters {
  KineticParameters kinetic;
  FrictionParameters friction;
  TemperatureModel temperature = TemperatureModel::transport;
  double temperature_value = 1e-4;   ///< T where the model is `constant` [m2/s2]
  double temperature_floor = 1e-14;  ///< added to T under square roots [m2/s2]
  GasParameters gas;
};

/// What the closures depend on at a point.
template <class Number>
struct SolidsPoint {
  Number nu;                 ///< solids fraction [-]
  Number T;                  ///< granular temperature, used if it is transported [m2/s2]
  Number chi;                ///< scaled frictional pressure, used if it is relaxed [-]
  Number div_v;              ///< [1/s]
  Number S_S;                ///< S:S of the three-dimensional deviator [1/s2]
  Number slip_squared{0.0};  ///< |u - v|^2, used if there is gas [m2/s2]
  Number g_f{1.0};           ///< fluidity, used if the friction coefficient is that [1/s]
};

/// Everything a cell needs, indexed by CellClosure. `T`, `chi`, `slip_squared` and `g_f` are ignored (any constant)
/// where the models do not take them from the balances. Number is double or Dual<3> ... Dual<6>; meant for `through`:
///     through([&](const auto&... z) { return cell_closure(z..., parameters); }, nu, T, chi, div_v, S_S, slip_squared,
///             g_f)
template <class Number>
CellClosures<Number> cell_closure(const Number& nu, const Number& T, const Number& chi, const Number& div_v,
                                  const Number& S_S, const Number& slip_squared, const Number& g_f,
                                  const SolidsParameters& p) {
  return std::get<CellClosureFunction<Number>>(p.friction.model->cell)(nu, T, chi, div_v, S_S, slip_squared, g_f, p);
}
/// The same without a fluidity.
template <class Number>
CellClosures<Number> cell_closure(const Number& nu, const Number& T, const Number& chi, const Number& div_v,
                                  const Number& S_S, const Number& slip_squared, const SolidsParameters& p) {
  return cell_closure(nu, T, chi, div_v, S_S, slip_squared, Number(1.0), p);
}

/// The viscosity of cell_closure alone, for shear stresses on edges, with p_c of (18) given [Pa s]. Number is double or
/// Dual<4> ... Dual<7>.
template <class Number>
Number edge_closure(const Number& nu, const Number& p_c, const Number& T, const Number& chi, const Number& div_v,
                    const Number& S_S, const Number& slip_squared, const Number& g_f, const SolidsParameters& p) {
  return std::get<EdgeClosureFunction<Number>>(p.friction.model->edge)(nu, p_c, T, chi, div_v, S_S, slip_squared, g_f,
                                                                       p);
}
/// The same without a fluidity.
template <class Number>
Number edge_closure(const Number& nu, const Number& p_c, const Number& T, const Number& chi, const Number& div_v,
                    const Number& S_S, const Number& slip_squared, const SolidsParameters& p) {
  return edge_closure(nu, p_c, T, chi, div_v, S_S, slip_squared, Number(1.0), p);
}

/// kappa such that (1.3) is q = -kappa grad T, with k* of (1.5) if there is gas [kg/(m s)]. For transported T.
/// Instantiated for double, Dual<2>, Dual<3>.
template <class Number>
Number face_conductivity(const Number& nu, const Number& T, const Number& slip_squared, const SolidsParameters& p);

template <class Number>
CellClosures<Number> cell_closure(const SolidsPoint<Number>& q, const SolidsParameters& p) {
  return cell_closure(q.nu, q.T, q.chi, q.div_v, q.S_S, q.slip_squared, q.g_f, p);
}

/// 1 in all but voids, 0 in them: share of the shear production that heats transported T. Half at nu = 1e-4, 1 - 1e-8
/// at 0.001. The viscosity of (1.4) stays as nu goes to 0 and the storage of (9) does not: beside a jet, where the path
/// between collisions is many cells long, T would go to 100 m2/s2 and Newton's method lose its way.
template <class Number>
Number production_share(const Number& nu) {
  constexpr double dilute = 1e-4;
  if (nu > 200 * dilute) return Number(1.0);  // to rounding
  const Number power = integer_power(nu / dilute, 8);
  return power / (1.0 + power);
}

/// 1 in all but voids, 0 in them: production balances dissipation only where particles collide within a few diameters.
/// Half at nu = 0.006, 1 - 2e-10 at 0.1. Without it T grows as (d S/nu)^2 in voids, whose pressure drives v to
/// infinity.
template <class Number>
Number local_equilibrium_share(const Number& nu) {
  constexpr double dilute = 6e-3;
  const Number power = integer_power(nu / dilute, 8);
  return power / (1.0 + power);
}

/// {T, regularised sqrt(T)} by the temperature model, `factors` from kinetic_factors, `gas` a GasEffect or NoGas.
template <class Number, std::size_t count, class Gas>
std::array<Number, 2> temperature(const SolidsPoint<Number>& q, const std::array<Number, count>& factors,
                                  const Gas& gas, const SolidsParameters& p) {
  if (p.temperature == TemperatureModel::transport) return {q.T, sqrt_temperature(q.T, p.temperature_floor)};
  if (p.temperature == TemperatureModel::constant)
    return {Number(p.temperature_value), Number(sqrt_temperature(p.temperature_value, p.temperature_floor))};
  const Number sqrt_T = local_equilibrium_share(q.nu) *
                        algebraic_sqrt_temperature(q.nu, factors, gas, q.div_v, q.S_S, p.kinetic, p.temperature_floor);
  return {sqrt_T * sqrt_T, sqrt_T};
}

/// {T, regularised sqrt(T)} by the temperature model [m2/s2, m/s].
template <class Number>
std::array<Number, 2> temperature(const SolidsPoint<Number>& q, const SolidsParameters& p) {
  const auto factors = kinetic_factors<factors_with_gas>(q.nu, p.kinetic);
  if (p.gas.model == GasModel::none) return temperature(q, factors, NoGas{}, p);
  return temperature(q, factors, gas_effect(q.nu, factors, q.slip_squared, p.kinetic, p.gas), p);
}

/// {p, mu} of sigma_s = p I - 2 mu S, eq. (8) [Pa, Pa s].
template <class Number>
std::array<Number, 2> solids_stress(const SolidsPoint<Number>& q, const SolidsParameters& p) {
  const auto all = cell_closure(q, p);
  return {all[CellClosure::pressure], all[CellClosure::viscosity]};
}

/// Source of (3/2) rho_s nu T in (9) without flux: -sigma_k : grad v - J_coll - J_vis [W/m3].
template <class Number>
Number solids_energy_source(const SolidsPoint<Number>& q, const SolidsParameters& p) {
  return cell_closure(q, p)[CellClosure::energy_source];
}

/// First guess of T after a step of dt of (9) by storage, production and dissipation alone, where T is so far below it
/// that Newton's method would go astray; elsewhere T [m2/s2]. With production P sqrt(T) and dissipation J T^(3/2) a
/// step from 0 ends below (P dt/c)^2, c = 3/2 rho_s nu, and below P/J.
inline double raised_temperature(double nu, double T, double div_v, double S_S, double dt, const SolidsParameters& p) {
  if (!(S_S > 0)) return T;
  constexpr double cold = 1e-12, hot = 1, far = 1e-2;  // [m2/s2], [m2/s2], [-]
  const auto energy = [&](double at) {
    return cell_closure(nu, at, 1.0, div_v, S_S, 0.0, p)[CellClosure::energy_source];
  };
  const double root = std::sqrt(cold + p.temperature_floor);
  const double production = energy(cold) / root, dissipation = production - energy(hot);
  if (!(production > 0)) return T;
  const double step = production * dt / (1.5 * p.kinetic.rho_s * nu);
  const double reached = std::min(step * step, dissipation > 0 ? production / dissipation : step * step);
  return T < far * reached ? reached : T;
}

/// Right-hand side of (23): (chi* - chi)/tau [1/s].
template <class X, class Y>
auto chi_source(const X& chi, const Y& steady, const FrictionParameters& p) {
  return (steady - chi) / p.tau;
}

}  // namespace scree
