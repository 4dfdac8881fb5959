/// The balance of fluidity at a point, and friction by it: known answers, limits, derivatives.
#include "scree/closures/fluidity.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "derivative_check.hpp"
#include "scree/closures/rheology/relaxed.hpp"

namespace scree {
namespace {

constexpr double mu_s = .3819, rho_s = 2450, d = 1e-3;  // glass beads

/// Without the fluidity of a bed at rest.
FluidityParameters beads() {
  FluidityParameters p;
  p.g_min = 1e-12;
  return p;
}

FrictionParameters friction() {
  FrictionParameters p;
  p.coefficient = FrictionCoefficient::fluidity;
  p.phi = std::asin(mu_s);
  p.rho_s = rho_s;
  p.fluctuation = 0;
  p.fluidity = beads();
  return p;
}

TEST(Fluidity, UniformShearIsSteadyAtTheLinearFormOfMuOfI) {  // 10 1/s under 1000 dyn/cm2
  const double gdot = 10, p_f = 100, S_S = gdot * gdot / 2;
  const double g = 23.34737, I = gdot * d * std::sqrt(rho_s / p_f);
  EXPECT_NEAR(gdot / g, .428314, 1e-6);
  EXPECT_NEAR(gdot / g, mu_s + .9377 * I, 1e-6);
  EXPECT_NEAR(fluidity_source(g, p_f, S_S, mu_s, rho_s, d, beads()), 0, 1e-5);
  EXPECT_GT(fluidity_source(.99 * g, p_f, S_S, mu_s, rho_s, d, beads()), 0);
  EXPECT_LT(fluidity_source(1.01 * g, p_f, S_S, mu_s, rho_s, d, beads()), 0);
}

TEST(Fluidity, ABedAtRestKeepsThatOfRest) {
  FluidityParameters p;
  p.b = 0;
  EXPECT_NEAR(fluidity_source(p.g_min, 100.0, 0.0, mu_s, rho_s, d, p), 0, 1e-18);
  p = FluidityParameters();  // b takes I of the creep, 5e-5 here
  EXPECT_NEAR(fluidity_source(p.g_min, 100.0, 0.0, mu_s, rho_s, d, p), 0, 1e-4 * mu_s * p.g_min);
}

TEST(Fluidity, IsBoundWithoutPressure) {
  const double most = std::sqrt(fluidity_pressure_floor / rho_s) / (.9377 * d);
  for (const double gdot : {1.0, 100.0, 1e4}) {
    EXPECT_LT(fluidity_source(most, 0.0, gdot * gdot / 2, mu_s, rho_s, d, beads()), 0) << gdot;
    EXPECT_GT(fluidity_source(1e-9, 0.0, gdot * gdot / 2, mu_s, rho_s, d, beads()), 0) << gdot;
  }
}

TEST(Fluidity, FrictionIsLinearInTheStrainRate) {
  const FrictionParameters p = friction();
  for (const double rate : {1e-6, 1.0, 1e4}) {
    const FrictionalPoint<double> at{.6, 1e-4, 1.0, 0.0, rate * rate / 2, 100.0, rate / std::sqrt(2.0), 25.0};
    const auto sigma = Relaxed::stress(at, p);
    EXPECT_DOUBLE_EQ(sigma.pressure, 100);
    EXPECT_NEAR(sigma.viscosity, 100 / 25.0, 1e-13) << rate;  // y is 1 at chi = 1
  }
}

/// Where chi is not 1 the yield surface has the factor y of (14), as with constant friction.
TEST(Fluidity, FrictionHasTheYieldSurfaceOfConstantFriction) {
  const FrictionParameters p = friction();
  FrictionParameters constant = p;
  constant.coefficient = FrictionCoefficient::constant;
  for (const double chi : {.3, .9, 1.02}) {
    const double rate = 7, g = rate / mu_s;  // M = mu_s
    const FrictionalPoint<double> at{.6, 0.0, chi, 0.0, rate * rate / 2, 100.0, rate / std::sqrt(2.0), g};
    EXPECT_NEAR(Relaxed::stress(at, p).viscosity, Relaxed::stress(at, constant).viscosity, 1e-12) << chi;
    EXPECT_EQ(Relaxed::stress(at, p).pressure, Relaxed::stress(at, constant).pressure);
    EXPECT_EQ(Relaxed::steady(at, p), Relaxed::steady(at, constant));
  }
}

/// {source, viscosity} of x = (g_f, p_f, S:S, chi).
struct Law {
  template <class Number>
  std::array<Number, 2> operator()(const std::array<Number, 4>& x) const {
    const FrictionParameters p = friction();
    const FrictionalPoint<Number> at{Number(.6), Number(0.0), x[3], Number(0.0), x[2], x[1], sqrt(x[2]), x[0]};
    return {fluidity_source(x[0], x[1], x[2], mu_s, rho_s, d, p.fluidity), Relaxed::stress(at, p).viscosity};
  }
};

TEST(Fluidity, DerivativesMatchDifferences) {
  for (const double g : {1e-2, 5.0, 300.0})
    for (const double p_f : {1e-2, 100.0, 1e5})
      for (const double S_S : {1e-4, 50.0, 1e5})
        for (const double chi : {.3, .95, 1.05})
          testing::expect_derivatives_match<4>(Law(), {g, p_f, S_S, chi}, {g, p_f, S_S, .03 * chi}, "fluidity", 1e-7);
}

TEST(Fluidity, FiniteAtTheEdges) {  // H15
  using D = Dual<4>;
  for (const double g : {1e-12, 5.0, 1e9})
    for (const double p_f : {0.0, 1e-30, 1e30})
      for (const double S_S : {0.0, 1e10})
        for (const double chi : {0.0, 1.0, 10.0}) {
          std::array<D, 4> x{D::variable(g, 0), D::variable(p_f, 1), D::variable(S_S, 2), D::variable(chi, 3)};
          const FrictionParameters p = friction();
          testing::expect_finite(fluidity_source(x[0], x[1], x[2], mu_s, rho_s, d, p.fluidity), "source");
          const FrictionalPoint<D> at{D(.6), D(0.0), x[3], D(0.0), x[2], x[1], D(1.0), x[0]};
          testing::expect_finite(Relaxed::stress(at, p).viscosity, "viscosity");
        }
}

}  // namespace
}  // namespace scree
