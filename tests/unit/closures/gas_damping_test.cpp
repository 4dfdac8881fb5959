#include "scree/closures/gas_damping.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <vector>

#include "derivative_check.hpp"

namespace scree {
namespace {

constexpr double mu_g = 1.8e-5;

KineticParameters with_diameter(double d) {
  KineticParameters p;
  p.d = d;
  return p;
}

/// (1.5) and (1.8) as printed, not multiplied through, at 40 digits (mpmath).
struct GasRow {
  double nu, T, beta, slip2, d, shear, conductivity, J_vis;
};
const std::vector<GasRow> rows = {
    {.3, 1e-4, 5e4, .04, 1e-4, .0017492295913, .0044920007687, 13.608000009},
    {.1, 1e-6, 1e4, .01, 1e-4, 1.2914628651e-5, 1.4364067913e-5, -2.3399109102},
    {.58, 1e-4, 2e3, .04, 1e-3, .33482273727, .91217211023, .59955853648},
};

TEST(GasDamping, ReferenceValues) {
  for (const GasRow& row : rows) {
    const KineticParameters p = with_diameter(row.d);
    const double sqrt_T = std::sqrt(row.T), b = row.beta / row.nu;
    EXPECT_NEAR(shear_viscosity(row.nu, sqrt_T, b, p), row.shear, 1e-8 * row.shear);
    EXPECT_NEAR(conductivity(row.nu, sqrt_T, b, p), row.conductivity, 1e-8 * row.conductivity);
    // The limit at T -> 0 turns 1/sqrt(T) into 1/(sqrt(T) + 1e-5 m/s) and touches the second term only.
    const double damping = 3 * row.beta * row.T;
    const double J_vis = viscous_dissipation(row.nu, row.T, sqrt_T, row.beta, row.slip2, mu_g, p);
    EXPECT_NEAR((J_vis - damping) * (1 + 1e-5 / sqrt_T), row.J_vis - damping, 1e-8 * (std::abs(row.J_vis) + damping));
  }
}

TEST(GasDamping, VanishingDragIsNoGas) {
  const KineticParameters p;
  EXPECT_DOUBLE_EQ(shear_viscosity(.4, .01, 0.0, p), shear_viscosity(.4, .01, p));
  EXPECT_DOUBLE_EQ(conductivity(.4, .01, 0.0, p), conductivity(.4, .01, p));
}

// T17: fJ rho_s T^1.5/d + 3 beta T = agitation by slip.
struct SlipRow {
  double nu, d, w, T;  ///< cgs
};
TEST(GasDamping, TemperatureHeldUpBySlip) {
  for (const SlipRow& row : std::vector<SlipRow>{{.3, .01, 20, .207491}, {.3, .04, 100, .325318}}) {
    const KineticParameters p = with_diameter(.01 * row.d);
    const double T = 1e-4 * row.T, sqrt_T = std::sqrt(T), w = .01 * row.w, rho_g = 1.3;
    const double Re = rho_g * (1 - row.nu) * p.d * w / mu_g;  // Wen-Yu (6), (7)
    const double beta = 18 * mu_g * row.nu * std::pow(1 - row.nu, -2.65) / (p.d * p.d) * (1 + .15 * std::pow(Re, .687));
    const double agitation = -viscous_dissipation(row.nu, T, sqrt_T, 0.0, w * w, mu_g, p) * (1 + 1e-5 / sqrt_T);
    EXPECT_NEAR(dissipation(row.nu, T, sqrt_T, p) + 3 * beta * T, agitation, 1e-5 * agitation) << "d = " << row.d;
  }
}

/// {mu_s, kappa, J_vis} of x = (nu, T, beta/nu, slip squared).
struct AllGas {
  KineticParameters p = with_diameter(1e-4);
  template <class Number>
  std::array<Number, 3> operator()(const std::array<Number, 4>& x) const {
    const Number sqrt_T = sqrt_temperature(x[1], 1e-14);
    return {shear_viscosity(x[0], sqrt_T, x[2], p), conductivity(x[0], sqrt_T, x[2], p),
            viscous_dissipation(x[0], x[1], sqrt_T, Number(x[0] * x[2]), x[3], mu_g, p)};
  }
};

TEST(GasDamping, DerivativesMatchDifferences) {
  for (double nu : {.1, .3, .58})
    for (double T : {1e-8, 1e-4})
      testing::expect_derivatives_match(AllGas{}, std::array<double, 4>{nu, T, 3e4, .01},
                                        {nu < .325 ? nu : .65 - nu, T, 3e4, .01}, "nu " + std::to_string(nu), 1e-7);
}

TEST(GasDamping, FiniteAtTheEdges) {  // H15
  using D = Dual<4>;
  for (double nu : {0.0, 1e-12, .65 - 1e-9})
    for (double T : {0.0, 1e-4})
      for (double slip2 : {0.0, 1.0}) {
        const auto result = AllGas{}(
            std::array<D, 4>{D::variable(nu, 0), D::variable(T, 1), D::variable(3e4, 2), D::variable(slip2, 3)});
        std::ostringstream state;
        state << "nu " << nu << " T " << T << " slip^2 " << slip2;
        for (const D& y : result) testing::expect_finite(y, state.str());
      }
}

}  // namespace
}  // namespace scree
