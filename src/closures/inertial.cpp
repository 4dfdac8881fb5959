#include "scree/closures/inertial.hpp"

#include <cmath>

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

/// M of `mu_i_regularised`; at I_1 both forms have the value M_1.
template <class Number>
Number regularised_coefficient(const Number& I, const FrictionParameters& p) {
  constexpr double alpha = 1.9, mu_infinity = 0.05, least = 1e-300;
  const double mu_s = std::sin(p.phi), I_1 = neutral_inertial_number(p);
  const auto fast = [&](const auto& at) { return (mu_s * p.I_0 + (p.mu_2 + mu_infinity * at) * at) / (p.I_0 + at); };
  if (!(I < I_1)) return fast(I);
  const double M_1 = fast(I_1);
  return I > least ? Number(sqrt(alpha / (alpha / (M_1 * M_1) + std::log(I_1) - log(I)))) : Number(0.0);
}

}  // namespace

/// By bisection between 0 and the share I/(I + I_0) at which q is greatest.
double neutral_inertial_number(const FrictionParameters& p) {
  const double mu_s = std::sin(p.phi), rise = p.mu_2 - mu_s;
  const auto well_posed = [&](double share) {
    const double M = mu_s + rise * share, q = rise * share * (1 - share) / M, coupled = M * (1 - q / 2);
    return 4 * q * (q - 1) + coupled * coupled <= 0;
  };
  double low = 0, high = mu_s / (mu_s + std::sqrt(mu_s * p.mu_2));
  if (!well_posed(high)) return std::nan("");
  for (int k = 0; k < 50; ++k) {
    const double middle = (low + high) / 2;
    (well_posed(middle) ? high : low) = middle;
  }
  return p.I_0 * high / (1 - high);
}

template <class Number>
std::array<Number, 2> inertial_coefficients(const Number& p_f, const Number& gamma, const FrictionParameters& p) {
  constexpr double nothing = 1e-30;  // below it derivatives by p_f could overflow [Pa]
  if (!(p_f > nothing)) return {Number(p.mu_2), Number(p.mu_2)};
  if (p.coefficient == FrictionCoefficient::mu_i_regularised) {
    const Number M = regularised_coefficient(Number((p.d * std::sqrt(2 * p.rho_s)) * gamma / sqrt(p_f)), p);
    return {M, M};
  }
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
