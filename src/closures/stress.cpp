/// The solids closures of a cell and of an edge, compiled once for the number types that kernels use.
#include "scree/closures/stress.hpp"

#include <type_traits>

namespace scree {

namespace {

// Arguments one by one: a SolidsPoint by reference would be built in memory, a quarter of the time without gas.

template <class Number, class Gas>
std::array<Number, CellClosure::count> cell_closure_with(const Gas& gas, const Number& nu, const Number& T,
                                                         const Number& chi, const Number& div_v, const Number& S_S,
                                                         const Number& slip_squared, const SolidsParameters& p) {
  constexpr bool has_gas = !std::is_same_v<Gas, NoGas>;
  const SolidsPoint<Number> q{nu, T, chi, div_v, S_S, slip_squared};
  const KineticParameters& k = p.kinetic;
  const auto f = kinetic_factors(nu, k);
  const auto [theta, sqrt_T] = temperature(q, f, gas, p);

  // (1.1), (1.4) and (1.8)
  const Number rho_d_sqrt_T = (k.rho_s * k.d) * sqrt_T;
  const Number p_k = k.rho_s * f[factor_pressure] * theta - f[factor_bulk] * rho_d_sqrt_T * div_v;
  const Number mu_k = damped_shear_factor(nu, f, gas, sqrt_T, k) * rho_d_sqrt_T;
  const Number J_coll = dissipation_by(f[factor_dissipation], nu, theta, sqrt_T, k);
  const Number shear_heat = p.temperature == TemperatureModel::transport ? production_share(nu) * mu_k : mu_k;
  Number energy_source = 2.0 * shear_heat * S_S - p_k * div_v - J_coll;
  if constexpr (has_gas) energy_source -= viscous_dissipation(theta, sqrt_T, gas.drag, gas.agitation);

  // (20)-(22)
  const FrictionParameters& friction = p.friction;
  const Number gamma = fluctuating_strain_rate(S_S, theta, friction);
  const Number p_c = friction.model == FrictionModel::none ? Number(0.0) : critical_pressure(nu, friction);
  const FrictionalStress<Number> sigma_f = frictional_stress(p_c, chi, div_v, gamma, friction);
  const Number steady = friction.model == FrictionModel::none             ? Number(0.0)
                        : friction.model == FrictionModel::critical_state ? Number(1.0)
                                                                          : chi_star(div_v, gamma, friction);

  std::array<Number, CellClosure::count> result;
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

template <class Number, class Gas>
Number edge_closure_with(const Gas& gas, const Number& nu, const Number& T, const Number& chi, const Number& div_v,
                         const Number& S_S, const Number& slip_squared, const SolidsParameters& p) {
  const SolidsPoint<Number> q{nu, T, chi, div_v, S_S, slip_squared};
  const KineticParameters& k = p.kinetic;
  const auto f = kinetic_factors(nu, k);
  const auto [theta, sqrt_T] = temperature(q, f, gas, p);
  const Number mu_k = (k.rho_s * k.d) * damped_shear_factor(nu, f, gas, sqrt_T, k) * sqrt_T;
  if (p.friction.model == FrictionModel::none || nu <= p.friction.nu_min) return mu_k;
  const Number gamma = fluctuating_strain_rate(S_S, theta, p.friction);
  return mu_k + frictional_stress(critical_pressure(nu, p.friction), chi, div_v, gamma, p.friction).viscosity;
}

}  // namespace

template <class Number>
std::array<Number, CellClosure::count> cell_closure(const Number& nu, const Number& T, const Number& chi,
                                                    const Number& div_v, const Number& S_S, const Number& slip_squared,
                                                    const SolidsParameters& p) {
  if (p.gas.model == GasModel::none) return cell_closure_with(NoGas{}, nu, T, chi, div_v, S_S, slip_squared, p);
  return cell_closure_with(gas_effect(nu, slip_squared, p.kinetic, p.gas), nu, T, chi, div_v, S_S, slip_squared, p);
}

template <class Number>
Number edge_closure(const Number& nu, const Number& T, const Number& chi, const Number& div_v, const Number& S_S,
                    const Number& slip_squared, const SolidsParameters& p) {
  if (p.gas.model == GasModel::none) return edge_closure_with(NoGas{}, nu, T, chi, div_v, S_S, slip_squared, p);
  return edge_closure_with(gas_effect(nu, slip_squared, p.kinetic, p.gas), nu, T, chi, div_v, S_S, slip_squared, p);
}

template <class Number>
Number face_conductivity(const Number& nu, const Number& T, const Number& slip_squared, const SolidsParameters& p) {
  const Number sqrt_T = sqrt_temperature(T, p.temperature_floor);
  if (p.gas.model == GasModel::none) return conductivity(nu, sqrt_T, p.kinetic);
  return conductivity(nu, sqrt_T, drag_over_nu(nu, slip_squared, p.kinetic.d, p.gas), p.kinetic);
}

#define SCREE_INSTANTIATE(Number)                                                                           \
  template std::array<Number, CellClosure::count> cell_closure(const Number&, const Number&, const Number&, \
                                                               const Number&, const Number&, const Number&, \
                                                               const SolidsParameters&);                    \
  template Number edge_closure(const Number&, const Number&, const Number&, const Number&, const Number&,   \
                               const Number&, const SolidsParameters&);
SCREE_INSTANTIATE(double)
SCREE_INSTANTIATE(Dual<3>)
SCREE_INSTANTIATE(Dual<4>)
SCREE_INSTANTIATE(Dual<5>)
SCREE_INSTANTIATE(Dual<6>)
#undef SCREE_INSTANTIATE

#define SCREE_INSTANTIATE(Number) \
  template Number face_conductivity(const Number&, const Number&, const Number&, const SolidsParameters&);
SCREE_INSTANTIATE(double)
SCREE_INSTANTIATE(Dual<2>)
SCREE_INSTANTIATE(Dual<3>)
#undef SCREE_INSTANTIATE

}  // namespace scree
