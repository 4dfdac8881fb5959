/// The solids closures of a cell and of an edge, compiled once for the number types that kernels use.
#include "scree/closures/stress.hpp"

namespace scree {

template <class Number>
std::array<Number, CellClosure::count> cell_closure(const Number& nu, const Number& T, const Number& chi,
                                                    const Number& div_v, const Number& S_S, const SolidsParameters& p) {
  const KineticParameters& k = p.kinetic;
  const SolidsPoint<Number> q{nu, T, chi, div_v, S_S};
  const auto f = kinetic_factors(nu, k);
  const auto [theta, sqrt_T] = temperature(q, f, p);

  // (1.1) and (1.4)
  const Number rho_d_sqrt_T = (k.rho_s * k.d) * sqrt_T;
  const Number p_k = k.rho_s * f[factor_pressure] * theta - f[factor_bulk] * rho_d_sqrt_T * div_v;
  const Number mu_k = f[factor_shear] * rho_d_sqrt_T;
  const Number J_coll = (k.rho_s / k.d) * f[factor_dissipation] * theta * sqrt_T;

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
  result[CellClosure::energy_source] = 2.0 * mu_k * S_S - p_k * div_v - J_coll;
  result[CellClosure::chi_star] = steady;
  result[CellClosure::frictional_pressure] = sigma_f.pressure;
  result[CellClosure::frictional_viscosity] = sigma_f.viscosity;
  result[CellClosure::temperature] = theta;
  result[CellClosure::sqrt_temperature] = sqrt_T;
  return result;
}

template <class Number>
Number edge_closure(const Number& nu, const Number& T, const Number& chi, const Number& div_v, const Number& S_S,
                    const SolidsParameters& p) {
  const KineticParameters& k = p.kinetic;
  const SolidsPoint<Number> q{nu, T, chi, div_v, S_S};
  const auto f = kinetic_factors(nu, k);
  const auto [theta, sqrt_T] = temperature(q, f, p);
  const Number mu_k = (k.rho_s * k.d) * f[factor_shear] * sqrt_T;
  if (p.friction.model == FrictionModel::none || nu <= p.friction.nu_min) return mu_k;
  const Number gamma = fluctuating_strain_rate(S_S, theta, p.friction);
  return mu_k + frictional_stress(critical_pressure(nu, p.friction), chi, div_v, gamma, p.friction).viscosity;
}

#define SCREE_INSTANTIATE(Number)                                                                                      \
  template std::array<Number, CellClosure::count> cell_closure(const Number&, const Number&, const Number&,            \
                                                               const Number&, const Number&, const SolidsParameters&); \
  template Number edge_closure(const Number&, const Number&, const Number&, const Number&, const Number&,              \
                               const SolidsParameters&);
SCREE_INSTANTIATE(double)
SCREE_INSTANTIATE(Dual<3>)
SCREE_INSTANTIATE(Dual<4>)
SCREE_INSTANTIATE(Dual<5>)
#undef SCREE_INSTANTIATE

}  // namespace scree
