#include "scree/closures/kinetic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "derivative_check.hpp"

namespace scree {
namespace {

const KineticParameters p;  // Table 2, d = 1 mm, e_p = 0.91

/// tests/VERIFICATION.md section 1, recomputed from src/MODEL.md with 40 digits (mpmath); fb = eta mu_b/(rho_s d
/// sqrt(T)).
struct TableRow {
  double nu, g0, fmu, fJ, fk, fp, steady_T, fb;
};
const std::vector<TableRow> table = {
    {.1, 2.15439372043, .110273759464, .025073055438, .340396547044, .18229784012, 4.39809817901, .0309543894296},
    {.3, 4.40148380625, .618722686989, .461024286291, 1.79631338997, 1.81323013259, 1.34206093993, .569165785544},
    {.49, 11.1248000064, 3.52699052305, 3.10861228329, 9.75601970006, 10.6934663194, 1.13458681934, 3.83779294234},
    {.55, 18.4628960423, 7.20974568574, 6.49991069491, 19.7653392944, 21.8847995217, 1.10920688362, 8.02458110482},
    {.6, 37.9822148417, 17.4033844433, 15.9134730559, 47.4253781954, 52.8331418503, 1.09362578378, 19.6462630319},
};

void expect_relative(double measured, double expected, double tolerance, const char* what, double nu) {
  EXPECT_NEAR(measured, expected, tolerance * std::abs(expected)) << what << " at nu = " << nu;
}

TEST(Kinetic, ReferenceTable) {
  const double T = 4e-4, sqrt_T = 2e-2;  // 4 cm2/s2: powers of T and the unit conversion show
  const double mu = p.rho_s * p.d * sqrt_T;
  for (const TableRow& row : table) {
    expect_relative(radial_distribution(row.nu, p), row.g0, 1e-8, "g0", row.nu);
    expect_relative(kinetic_pressure(row.nu, T, p), row.fp * p.rho_s * T, 1e-8, "pressure", row.nu);
    expect_relative(bulk_viscosity(row.nu, sqrt_T, p), row.fb * mu, 1e-8, "bulk viscosity", row.nu);
    expect_relative(shear_viscosity(row.nu, sqrt_T, p), row.fmu * mu, 1e-8, "shear viscosity", row.nu);
    expect_relative(conductivity(row.nu, sqrt_T, p), row.fk * mu, 1e-8, "conductivity", row.nu);
    expect_relative(dissipation(row.nu, T, sqrt_T, p), row.fJ * p.rho_s * T * sqrt_T / p.d, 1e-8, "J_coll", row.nu);
  }
}

TEST(Kinetic, FactorsAtOnceAreTheFactors) {
  for (const TableRow& row : table) {
    const auto f = kinetic_factors(row.nu, p);
    expect_relative(f[factor_pressure], row.fp, 1e-8, "pressure", row.nu);
    expect_relative(f[factor_bulk], row.fb, 1e-8, "bulk", row.nu);
    expect_relative(f[factor_shear], row.fmu, 1e-8, "shear", row.nu);
    expect_relative(f[factor_dissipation], row.fJ, 1e-8, "dissipation", row.nu);
  }
}

// (1.7) near packing, where 1 - (nu/nu_max)^(1/3) would lose eight digits: g0 -> 3/(1 - nu/nu_max) + ...
TEST(Kinetic, RadialDistributionDoesNotCancelNearPacking) {
  const double gap = 1e-9, nu = p.nu_max - gap, y = (p.nu_max - nu) / p.nu_max;
  expect_relative(radial_distribution(nu, p), 3 / y * (1 - y / 3), 1e-9, "g0", nu);
  EXPECT_EQ(radial_distribution(p.nu_max, p), std::numeric_limits<double>::infinity());
  EXPECT_EQ(radial_distribution(p.nu_max + 1e-6, p), std::numeric_limits<double>::infinity());
}

// tests/VERIFICATION.md section 1 and T2: simple shear at rate gdot, S:S = gdot^2/2.
TEST(KineticAlgebraic, SteadySimpleShear) {
  const double rate = 10;
  for (const TableRow& row : table) {
    const double s = algebraic_sqrt_temperature(row.nu, 0.0, rate * rate / 2, p, 1e-14);
    expect_relative(s * s - 1e-14, row.steady_T * p.d * p.d * rate * rate, 1e-8, "T", row.nu);
  }
}

/// Root of the quadratic at 40 digits (mpmath), floor 0.
struct AlgebraicRow {
  double nu, div_v, S_S, sqrt_T;
};
TEST(KineticAlgebraic, BothSignsOfDivergence) {
  const std::vector<AlgebraicRow> rows = {
      {.3, 100, 1e-3, .029218915982}, {.3, -100, 1e-3, .42252360437}, {.58, 1, 25, .00601160224698},
      {.58, -1, 25, .009349136966},   {.6, 20, 1, .00677813037482},   {.6, -20, 1, .0731786473013},
  };
  for (const AlgebraicRow& row : rows)
    expect_relative(algebraic_sqrt_temperature(row.nu, row.div_v, row.S_S, p, 1e-20), row.sqrt_T, 1e-8, "sqrt(T)",
                    row.nu);
}

TEST(KineticAlgebraic, TheFormsForBothSignsMeet) {
  const double S_S = 1e-6, step = 1e-9;
  const double lower = algebraic_sqrt_temperature(.58, -step, S_S, p, 1e-14);
  const double upper = algebraic_sqrt_temperature(.58, step, S_S, p, 1e-14);
  const Dual<1> middle = algebraic_sqrt_temperature<Dual<1>>(.58, Dual<1>::variable(0, 0), S_S, p, 1e-14);
  EXPECT_NEAR((upper - lower) / (2 * step), middle.derivative[0], 1e-5 * std::abs(middle.derivative[0]));
}

TEST(KineticAlgebraic, RestHasTheFloorTemperature) {
  for (double nu : {.3, .58, .64}) {
    const double s = algebraic_sqrt_temperature(nu, 0.0, 0.0, p, 1e-14);
    EXPECT_NEAR(s, 1e-7, 1e-15) << "nu = " << nu;
  }
}

/// All kinetic closures of x = (nu, T, div_v, S_S).
struct AllKinetic {
  template <class Number>
  std::array<Number, 7> operator()(const std::array<Number, 4>& x) const {
    const Number& nu = x[0];
    const Number& T = x[1];
    const Number sqrt_T = sqrt_temperature(T, 1e-14);
    return {radial_distribution(nu, p),
            kinetic_pressure(nu, T, p),
            bulk_viscosity(nu, sqrt_T, p),
            shear_viscosity(nu, sqrt_T, p),
            conductivity(nu, sqrt_T, p),
            dissipation(nu, T, sqrt_T, p),
            algebraic_sqrt_temperature(nu, x[2], x[3], p, 1e-14)};
  }
};

TEST(Kinetic, DerivativesMatchDifferences) {
  for (double nu : {.01, .1, .3, .5, .58, .64})
    for (double T : {1e-8, 1e-4})
      for (double div_v : {-5.0, 0.3, 10.0})
        testing::expect_derivatives_match(
            AllKinetic{}, std::array<double, 4>{nu, T, div_v, 25},
            {std::min(nu, p.nu_max - nu), T, std::abs(div_v), 25},
            "nu " + std::to_string(nu) + " T " + std::to_string(T) + " div v " + std::to_string(div_v));
}

TEST(Kinetic, FiniteAtTheEdges) {  // H15
  using D = Dual<4>;
  for (double nu : {-1e-9, 0.0, 1e-12, 1e-5, .3, p.nu_max - 1e-9})
    for (double T : {0.0, 1e-14, 1e-4})
      for (double div_v : {-100.0, -1e-12, 0.0, 1e-12, 100.0})
        for (double S_S : {0.0, 1e-14, 25.0}) {
          const auto result = AllKinetic{}(
              std::array<D, 4>{D::variable(nu, 0), D::variable(T, 1), D::variable(div_v, 2), D::variable(S_S, 3)});
          for (std::size_t r = 0; r < result.size(); ++r) {
            std::ostringstream state;
            state << "closure " << r << " at nu " << nu << " T " << T << " div v " << div_v << " S:S " << S_S;
            testing::expect_finite(result[r], state.str());
          }
        }
}

TEST(Kinetic, CollisionsLeaveTemperatureAtRest) {
  KineticParameters resting = p;
  resting.T_rest = 1e-6;
  const double nu = p.nu_max * std::pow(.5, 1. / 32), T = 4e-6, sqrt_T = 2e-3;  // half of T_rest is left here
  EXPECT_NEAR(temperature_at_rest(nu, resting), .5e-6, 1e-19);
  EXPECT_LT(dissipation(nu, .4e-6, 1e-3, resting), 0);
  EXPECT_NEAR(dissipation(nu, T, sqrt_T, resting) / dissipation(nu, T, sqrt_T, p), 7. / 8, 1e-14);
  EXPECT_NEAR(dissipation(.3, 1e-6, 1e-3, resting) / dissipation(.3, 1e-6, 1e-3, p), 1, 1e-10);
}

TEST(Kinetic, DiluteLimit) {
  EXPECT_EQ(radial_distribution(0.0, p), 1);
  EXPECT_EQ(kinetic_pressure(0.0, 1e-4, p), 0);
  EXPECT_EQ(dissipation(0.0, 1e-4, 1e-2, p), 0);
  // (1.1) at nu = 0: mu_s = (2+alpha)/3 mu/(eta (2-eta)), mu = 5 rho_s d sqrt(pi T)/96
  const double mu = 5 * p.rho_s * p.d * std::sqrt(pi) * 1e-2 / 96;
  EXPECT_NEAR(shear_viscosity(0.0, 1e-2, p), 1.2 * mu / (.955 * 1.045), 1e-15);
}

}  // namespace
}  // namespace scree
