/// The closures of a cell and of an edge for a rheology, and the entry made from it.
#pragma once

#include <type_traits>

#include "scree/closures/stress.hpp"

namespace scree {

template <class Number>
FrictionalPoint<Number> frictional_point(const Number& nu, const Number& p_c, const Number& T, const Number& chi,
                                         const Number& div_v, const Number& S_S, const Number& g_f,
                                         const FrictionParameters& p) {
  return {nu, T, chi, div_v, S_S, p_c, fluctuating_strain_rate(S_S, T, p), g_f};
}

// Arguments one by one: a SolidsPoint by reference would be built in memory, a quarter of the time without gas.

/// cell_closure, `f` from kinetic_factors, `gas` a GasEffect or NoGas.
template <class R, class Number, std::size_t count, class Gas>
CellClosures<Number> cell_closure_with(const std::array<Number, count>& f, const Gas& gas, const Number& nu,
                                       const Number& T, const Number& chi, const Number& div_v, const Number& S_S,
                                       const Number& slip_squared, const Number& g_f, const SolidsParameters& p) {
  constexpr bool has_gas = !std::is_same_v<Gas, NoGas>;
  const SolidsPoint<Number> q{nu, T, chi, div_v, S_S, slip_squared};
  const KineticParameters& k = p.kinetic;
  const auto [theta, sqrt_T] = temperature(q, f, gas, p);

  // (1.1), (1.4) and (1.8)
  const Number rho_d_sqrt_T = (k.rho_s * k.d) * sqrt_T;
  const Number p_k = k.rho_s * f[factor_pressure] * theta - f[factor_bulk] * rho_d_sqrt_T * div_v;
  const Number mu_k = damped_shear_factor(nu, f, gas, sqrt_T, k) * rho_d_sqrt_T;
  const Number J_coll = dissipation_by(f[factor_dissipation], nu, theta, sqrt_T, k);
  const Number shear_heat = p.temperature == TemperatureModel::transport ? production_share(nu) * mu_k : mu_k;
  Number energy_source = 2.0 * shear_heat * S_S - p_k * div_v - J_coll;
  if constexpr (has_gas) energy_source -= viscous_dissipation(theta, sqrt_T, gas.drag, gas.agitation);

  FrictionalStress<Number> sigma_f{Number(0.0), Number(0.0)};
  Number steady = 0.0;
  if constexpr (R::has_friction) {
    const FrictionalPoint<Number> at =
        frictional_point(nu, critical_pressure(nu, p.friction), theta, chi, div_v, S_S, g_f, p.friction);
    sigma_f = R::stress(at, p.friction);
    steady = R::steady(at, p.friction);
  }

  CellClosures<Number> result;
  result[CellClosure::pressure] = p_k + sigma_f.pressure;
  result[CellClosure::viscosity] = mu_k + sigma_f.viscosity;
  result[CellClosure::energy_source] = energy_source;
  result[CellClosure::chi_star] = steady;
  result[CellClosure::frictional_pressure] = sigma_f.pressure;
  result[CellClosure::frictional_viscosity] = sigma_f.viscosity;
  result[CellClosure::temperature] = theta;
  result[CellClosure::sqrt_temperature] = sqrt_T;
  if constexpr (has_gas) {
    result[CellClosure::drag] = gas.drag;
    result[CellClosure::drag_over_nu] = gas.drag_over_nu;
  } else {
    result[CellClosure::drag] = result[CellClosure::drag_over_nu] = 0.0;
  }
  return result;
}

/// edge_closure, `f` from kinetic_factors, `gas` a GasEffect or NoGas.
template <class R, class Number, std::size_t count, class Gas>
Number edge_closure_with(const std::array<Number, count>& f, const Gas& gas, const Number& nu, const Number& p_c,
                         const Number& T, const Number& chi, const Number& div_v, const Number& S_S,
                         const Number& slip_squared, const Number& g_f, const SolidsParameters& p) {
  const SolidsPoint<Number> q{nu, T, chi, div_v, S_S, slip_squared};
  const KineticParameters& k = p.kinetic;
  const auto [theta, sqrt_T] = temperature(q, f, gas, p);
  const Number mu_k = (k.rho_s * k.d) * damped_shear_factor(nu, f, gas, sqrt_T, k) * sqrt_T;
  if constexpr (R::has_friction)
    return mu_k + R::stress(frictional_point(nu, p_c, theta, chi, div_v, S_S, g_f, p.friction), p.friction).viscosity;
  else
    return mu_k;
}

/// cell_closure of a rheology.
template <class R, class Number>
CellClosures<Number> cell_closure_by(const Number& nu, const Number& T, const Number& chi, const Number& div_v,
                                     const Number& S_S, const Number& slip_squared, const Number& g_f,
                                     const SolidsParameters& p) {
  if (p.gas.model == GasModel::none)
    return cell_closure_with<R>(kinetic_factors(nu, p.kinetic), NoGas{}, nu, T, chi, div_v, S_S, slip_squared, g_f, p);
  const auto f = kinetic_factors<factors_with_gas>(nu, p.kinetic);
  const auto gas = gas_effect(nu, f, slip_squared, p.kinetic, p.gas);
  return cell_closure_with<R>(f, gas, nu, T, chi, div_v, S_S, slip_squared, g_f, p);
}

/// edge_closure of a rheology.
template <class R, class Number>
Number edge_closure_by(const Number& nu, const Number& p_c, const Number& T, const Number& chi, const Number& div_v,
                       const Number& S_S, const Number& slip_squared, const Number& g_f, const SolidsParameters& p) {
  if (p.gas.model == GasModel::none)
    return edge_closure_with<R>(kinetic_factors(nu, p.kinetic), NoGas{}, nu, p_c, T, chi, div_v, S_S, slip_squared, g_f,
                                p);
  const auto f = kinetic_factors<factors_with_gas>(nu, p.kinetic);
  const auto gas = gas_effect(nu, f, slip_squared, p.kinetic, p.gas);
  return edge_closure_with<R>(f, gas, nu, p_c, T, chi, div_v, S_S, slip_squared, g_f, p);
}

/// The entry of a rheology.
template <class R>
inline constexpr Rheology rheology{
    R::name,
    R::source,
    R::has_friction,
    R::has_unknown,
    R::uses_flow_rule,
    {&cell_closure_by<R, double>, &cell_closure_by<R, Dual<3>>, &cell_closure_by<R, Dual<4>>,
     &cell_closure_by<R, Dual<5>>, &cell_closure_by<R, Dual<6>>},
    {&edge_closure_by<R, double>, &edge_closure_by<R, Dual<4>>, &edge_closure_by<R, Dual<5>>,
     &edge_closure_by<R, Dual<6>>, &edge_closure_by<R, Dual<7>>}};

}  // namespace scree
