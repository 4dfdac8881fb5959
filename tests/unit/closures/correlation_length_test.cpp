/// Correlation length of extended kinetic theory, in all its variants, and the dissipation with it.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "derivative_check.hpp"
#include "scree/closures/correlation_length/berzi_vescovi.hpp"
#include "scree/closures/correlation_length/jenkins.hpp"

namespace scree {
namespace {

KineticParameters with(const CorrelationLength& length, double mu_p = 0, double constant = .5) {
  KineticParameters p;
  p.length = &length;
  p.mu_p = mu_p;
  p.length_constant = constant;
  return p;
}

const CorrelationLength &jenkins = correlation_length_entry<JenkinsLength>,
                        &berzi_vescovi = correlation_length_entry<BerziVescovi>;

double ratio(double nu, const KineticParameters& p) { return std::get<0>(p.length->ratio)(nu, p); }

TEST(CorrelationLength, IsListed) {
  EXPECT_EQ(correlation_lengths(), (Variants<CorrelationLength>{&jenkins, &berzi_vescovi}));
  EXPECT_EQ(KineticParameters{}.length, nullptr) << "L = d unless it is chosen";
}

/// The equations in the heads of the variants with 40 digits (mpmath), g0 of (1.7), e_p = 0.91, mu_p with
/// chialvo_sundaresan; 1 where max{1, .} takes it.
TEST(CorrelationLength, ReferenceValues) {
  struct Row {
    double nu, mu_p, c, jenkins, berzi_vescovi;
  };
  const std::vector<Row> rows = {
      {.3, .3, 1, 1, 1},
      {.49, .3, 1, 1.232362198646, 1},
      {.55, 0, .5, 1, 1.103577614542},
      {.55, .3, 1, 1.42577876935, 1},
      {.58, .3, 1, 1.572333282281, 1.183083904726},
      {.6, 0, .5, 1, 1.491291785563},
      {.6, .3, .5, 1.080012436638, 1.686612926801},
      {.64, 0, .5, 1.128019060503, 5.820146499751},
      {.64, .3, 1, 2.506359208636, 13.26567177176},
  };
  for (const Row& row : rows) {
    EXPECT_NEAR(ratio(row.nu, with(jenkins, row.mu_p, row.c)), row.jenkins, 1e-9 * row.jenkins)
        << "nu " << row.nu << " mu_p " << row.mu_p;
    EXPECT_NEAR(ratio(row.nu, with(berzi_vescovi, row.mu_p)), row.berzi_vescovi, 1e-9 * row.berzi_vescovi)
        << "nu " << row.nu << " mu_p " << row.mu_p;
  }
}

// With the g0 of extended kinetic theory, which diverges at 0.636, and e_eff = 0.727: L/d of the published shear
// states.
TEST(CorrelationLength, BerziVescoviWithItsOwnRadialDistribution) {
  struct Row {
    double nu, g0, smooth, rough;
  };
  for (const Row& row : {Row{.49, 6.86, .992, .599}, Row{.55, 14.14, 1.131, .898}, Row{.58, 24.78, 1.345, 1.356},
                         Row{.60, 42.98, 1.718, 2.211}}) {
    EXPECT_NEAR(BerziVescovi::unbounded(row.nu, row.nu * row.g0, .91, .91, .636), row.smooth, 6e-4) << row.nu;
    EXPECT_NEAR(BerziVescovi::unbounded(row.nu, row.nu * row.g0, .91, .727, .636), row.rough, 6e-4) << row.nu;
  }
}

// J_coll d/(rho_s T^(3/2)) falls by L/d, all else stays; in simple shear T grows by it.
TEST(CorrelationLength, DividesTheDissipation) {
  const double nu = .6, rate = 10;
  const KineticParameters none, p = with(berzi_vescovi);
  const auto plain = kinetic_factors(nu, none), chains = kinetic_factors(nu, p);
  EXPECT_NEAR(plain[factor_dissipation] / chains[factor_dissipation], 1.491291785563, 1e-11);
  for (const KineticFactor f : {factor_pressure, factor_bulk, factor_shear}) EXPECT_EQ(plain[f], chains[f]) << f;
  const double s = algebraic_sqrt_temperature(nu, 0.0, rate * rate / 2, p, 1e-16);
  EXPECT_NEAR(s * s / (p.d * p.d * rate * rate), 1.09362578378 * 1.491291785563, 1e-8);
}

// L of `jenkins` is (c/2) (nu g0)^(1/3) d^2 gdot/sqrt(T) in the simple shear that it makes.
TEST(CorrelationLength, JenkinsHoldsInSteadyShear) {
  const double nu = .6, rate = 10;
  const KineticParameters p = with(jenkins, .3, 1);
  const double root = algebraic_sqrt_temperature(nu, 0.0, rate * rate / 2, p, 1e-18);
  const double G = nu * radial_distribution(nu, p);
  EXPECT_NEAR(ratio(nu, p), .5 * std::cbrt(G) * p.d * rate / root, 1e-8);
}

TEST(CorrelationLength, LeavesLooseAndElasticParticlesAlone) {
  for (const CorrelationLength* length : correlation_lengths()) {
    KineticParameters p = with(*length, .3, 1);
    for (const double nu : {-1e-9, 0.0, 1e-12, .01, .1, .3}) EXPECT_EQ(ratio(nu, p), 1) << length->name << " " << nu;
    EXPECT_EQ(ratio(p.nu_max, p), 1) << "a refused state";
    p.mu_p = 0;
    p.e_p = 1;
    EXPECT_EQ(ratio(.6, p), 1) << length->name;
    p.e_p = .999;  // the published law would have L/d = 2.9 in loose states
    EXPECT_EQ(ratio(.4, p), 1) << length->name;
  }
}

struct Dissipation {
  KineticParameters p;
  template <class Number>
  std::array<Number, 1> operator()(const std::array<Number, 1>& x) const {
    return {kinetic_factors(x[0], p)[factor_dissipation]};
  }
};

TEST(CorrelationLength, DerivativesMatchDifferences) {
  for (const CorrelationLength* length : correlation_lengths())
    for (const double mu_p : {0.0, .3})
      for (const double nu : {.2, .45, .55, .6, .64}) {
        const Dissipation f{with(*length, mu_p, 1)};
        testing::expect_derivatives_match(f, std::array<double, 1>{nu}, {std::min(.01, .65 - nu)},
                                          length->name + (" nu " + std::to_string(nu)), 1e-7);
        testing::expect_finite(f(std::array<Dual<1>, 1>{Dual<1>::variable(nu, 0)})[0], length->name);
      }
}

TEST(CorrelationLength, IsSmoothWhereItBegins) {
  for (const CorrelationLength* length : correlation_lengths()) {
    const KineticParameters p = with(*length, .3, 1);
    Dual<1> last = std::get<1>(length->ratio)(Dual<1>::variable(.39, 0), p);
    for (double nu = .39; nu < .6; nu += 1e-5) {
      const Dual<1> next = std::get<1>(length->ratio)(Dual<1>::variable(nu, 0), p);
      EXPECT_NEAR(next.derivative[0], last.derivative[0], .1) << length->name << " nu " << nu;
      last = next;
    }
  }
}

TEST(CorrelationLength, FiniteAtTheEdges) {  // H15
  for (const CorrelationLength* length : correlation_lengths())
    for (const double nu : {-1e-9, 0.0, 1e-12, 1e-5, .3, .4, .49, .65 - 1e-9})
      testing::expect_finite(kinetic_factors(Dual<1>::variable(nu, 0), with(*length, .3))[factor_dissipation],
                             length->name);
}

}  // namespace
}  // namespace scree
