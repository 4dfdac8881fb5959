#include "scree/closures/inertial.hpp"

namespace scree {
namespace {

/// 1 - log(1 + z)/z for z > 0: share of the way from slow to fast flow that the mean of M over 0 ... z I_0 has gone.
template <class Number>
Number mean_share(const Number& z) {
  if (z > 0.05) return 1.0 - log(1.0 + z) / z;
  Number sum = 0.0;  // z/2 - z^2/3 + z^3/4 - ..., 4e-16 left
  for (int k = 10; k > 0; --k) sum = z * (1.0 / (k + 1) - sum);
  return sum;
}

}  // namespace

template <class Number>
std::array<Number, 2> inertial_coefficients(const Number& p_f, const Number& gamma, const FrictionParameters& p) {
  constexpr double nothing = 1e-30;  // below it derivatives by p_f could overflow [Pa]
  if (!(p_f > nothing)) return {Number(p.mu_2), Number(p.mu_2)};
  const double mu_s = std::sin(p.phi);
  const Number z = (p.d * std::sqrt(2 * p.rho_s) / p.I_0) * gamma / sqrt(p_f);  // I/I_0
  return {mu_s + (p.mu_2 - mu_s) * (z / (1.0 + z)), mu_s + (p.mu_2 - mu_s) * mean_share(z)};
}

#define SCREE_INSTANTIATE(Number) \
  template std::array<Number, 2> inertial_coefficients(const Number&, const Number&, const FrictionParameters&);
SCREE_INSTANTIATE(double)
SCREE_INSTANTIATE(Dual<2>)
#undef SCREE_INSTANTIATE

}  // namespace scree
