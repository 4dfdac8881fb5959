/// M(I) in the yield surface and its flow rules: known answers, and that the law is the associated one where it says
/// so.
#include "scree/closures/inertial.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "derivative_check.hpp"
#include "scree/closures/rheology/critical_state.hpp"
#include "scree/closures/rheology/relaxed.hpp"

namespace scree {
namespace {

/// Glass beads: mu_s 0.3819, mu_2 0.6435, I_0 0.278; n of dilation as with the angle of the paper.
FrictionParameters glass(FrictionCoefficient coefficient) {
  FrictionParameters p;
  p.coefficient = coefficient;
  p.phi = std::asin(.3819);
  p.n_dilation = std::sqrt(3.0) / (2 * .4772);
  p.rho_s = 2450;
  p.fluctuation = 0;
  p.strain_rate_floor = 0;
  return p;
}

constexpr FrictionCoefficient inertial_coefficients_offered[] = {FrictionCoefficient::mu_i, FrictionCoefficient::cidr,
                                                                 FrictionCoefficient::mu_i_regularised};

/// gamma [1/s] that gives the inertial number I.
double rate_of(double I, double p_f, const FrictionParameters& p) { return I / (p.d * std::sqrt(2 * p.rho_s / p_f)); }

template <class R, class Number>
FrictionalStress<Number> stress(const Number& p_c, const Number& chi, const Number& div_v, const Number& gamma,
                                const FrictionParameters& p) {
  return R::stress(FrictionalPoint<Number>{Number(.6), Number(0.0), chi, div_v, Number(0.0), p_c, gamma}, p);
}

/// Shear stress over p_f in simple shear, S:S = gdot^2/2.
double ratio(const FrictionalStress<double>& sigma, double gamma) {
  return sigma.viscosity * std::sqrt(2.0) * gamma / sigma.pressure;
}

TEST(Inertial, SimpleShear) {  // 1000 dyn/cm2
  const FrictionParameters p = glass(FrictionCoefficient::mu_i);
  struct Row {
    double I, mu;
  };
  for (const Row& row : {Row{.001, .3828376344}, Row{.01, .3909833333}, Row{.1, .4511063492}, Row{.3, .5176785467}}) {
    const double gamma = rate_of(row.I, 100, p);
    EXPECT_NEAR(ratio(stress<CriticalState>(100.0, 1.0, 0.0, gamma, p), gamma), row.mu, 1e-10);
    EXPECT_NEAR(ratio(stress<Relaxed>(100.0, 1.0, 0.0, gamma, p), gamma), row.mu, 1e-10);
  }
}

// The numbers of I_1 and A are by root finding apart; an OpenFOAM module for the law of Barker & Gray (2017) has the
// parameters of the second glass in its tutorial.
TEST(Inertial, RegularisedCoefficient) {
  FrictionParameters p = glass(FrictionCoefficient::mu_i_regularised);
  EXPECT_NEAR(neutral_inertial_number(p), .0192883868, 1e-10);
  p.phi = std::asin(.342);
  p.mu_2 = .557;
  p.I_0 = .069;
  const double I_1 = neutral_inertial_number(p);
  EXPECT_NEAR(I_1, .0039717827, 1e-10);
  const auto M = [&](double I) { return inertial_coefficients(100.0, rate_of(I, 100, p), p)[0]; };
  EXPECT_NEAR(M(1e-3), std::sqrt(1.9 / std::log(15642.40839837 / 1e-3)), 1e-10);
  EXPECT_NEAR(M(I_1 * (1 - 1e-12)), M(I_1 * (1 + 1e-12)), 1e-12);
  EXPECT_NEAR(M(10), (.342 * .069 + .557 * 10 + .05 * 100) / 10.069, 1e-12);
  p.phi = std::asin(.47);
  EXPECT_TRUE(std::isnan(neutral_inertial_number(p)));
}

/// M, Mbar by the integral, and where `cidr` shears without change of volume: chi and shear stress over p_f, by solving
/// its div v = 0 (mpmath).
struct Row {
  double z, M, mean, chi_c, ratio;
};
const std::vector<Row> rows = {
    {.001, .382161338661, .382030712865, .9999232353, .3821906749},
    {.1, .405681818182, .394168569632, .9933946832, .4083594602},
    {1, .5127, .462172697566, .9747673568, .525599436},
    {3, .5781, .52261513171, .975516108, .5922145041},
};

TEST(Inertial, MeanOfTheCoefficient) {
  const FrictionParameters p = glass(FrictionCoefficient::cidr);
  for (const Row& row : rows) {
    const auto [M, mean] = inertial_coefficients(100.0, rate_of(row.z * p.I_0, 100, p), p);
    EXPECT_NEAR(M, row.M, 1e-11) << row.z;
    EXPECT_NEAR(mean, row.mean, 1e-11) << row.z;
  }
  // the series and the closed form meet
  const auto mean_at = [&](double z) { return inertial_coefficients(100.0, rate_of(z * p.I_0, 100, p), p)[1]; };
  EXPECT_NEAR(mean_at(.05 + 1e-15), mean_at(.05 - 1e-15), 1e-14);
}

// At div v = 0 chi relaxes to a value below one, where the shear stress is above M.
TEST(Inertial, CriticalStateOfTheConsistentFlowRule) {
  FrictionParameters p = glass(FrictionCoefficient::cidr);
  const double p_f = 100;
  for (const Row& row : rows) {
    const double p_c = p_f / row.chi_c, gamma = rate_of(row.z * p.I_0, p_f, p);
    const FrictionalPoint<double> at{.6, 0, row.chi_c, 0, 0, p_c, gamma};
    EXPECT_NEAR(Relaxed::steady(at, p), row.chi_c, 1e-10) << row.z;
    const double meeting = row.z < .5 ? 1e-5 : 1e-9;  // div v = 0 is where the branches of (14) pass into each other
    EXPECT_NEAR(ratio(Relaxed::stress(at, p), gamma), row.ratio, meeting) << row.z;
  }
}

/// div v/gamma that keeps chi, at a given inertial number: the root of steady(div v) = chi.
double flow_rule(double chi, double p_c, double gamma, const FrictionParameters& p) {
  double low = -2 * gamma, high = 2 * gamma;
  for (int k = 0; k < 200; ++k) {
    const double middle = (low + high) / 2;
    const double steady = Relaxed::steady(FrictionalPoint<double>{.6, 0, chi, middle, 0, p_c, gamma}, p);
    (steady > chi ? low : high) = middle;
  }
  return low / gamma;
}

/// |dev sigma_f| = Y(p_f, I) at fixed nu, on the branch of dilation.
double yield_stress(double p_f, double I, double p_c, const FrictionParameters& p) {
  const double gamma = rate_of(I, p_f, p);
  const auto sigma = stress<Relaxed>(p_c, p_f / p_c, 10 * gamma, gamma, p);
  return 2 * sigma.viscosity * gamma;
}

// Barker et al. (2017): with |dev sigma| = Y(p, I) and div v = f |S| the law is well-posed if
// (a) Y_p - I/(2p) Y_I = f + I f_I, (b) Y_I > 0, (c) f_p - I/(2p) f_I < 0; (13) with M(I) breaks (a).
TEST(Inertial, ConsistentFlowRuleIsWellPosed) {
  for (const FrictionCoefficient coefficient : inertial_coefficients_offered) {
    const FrictionParameters p = glass(coefficient);
    double worst = 0;
    for (const double chi : {.2, .5, .8, .93})
      for (const double z : {.05, .3, 1.0, 3.0, 10.0}) {
        const double p_c = 100, p_f = chi * p_c, I = z * p.I_0, h = 1e-4;
        const auto Y = [&](double a, double b) { return yield_stress(p_f * a, I * b, p_c, p); };
        const auto f = [&](double a, double b) { return flow_rule(chi * a, p_c, rate_of(I * b, p_f * a, p), p); };
        const auto slope = [&](const auto& g, bool by_p) {
          return by_p ? (g(1 + h, 1.) - g(1 - h, 1.)) / (2 * h * p_f) : (g(1., 1 + h) - g(1., 1 - h)) / (2 * h * I);
        };
        const double Y_p = slope(Y, true), Y_I = slope(Y, false), f_p = slope(f, true), f_I = slope(f, false);
        worst = std::max(worst, std::abs(Y_p - I / (2 * p_f) * Y_I - f(1, 1) - I * f_I));
        if (coefficient != FrictionCoefficient::cidr) continue;
        EXPECT_GT(Y_I, 0) << "chi " << chi << " z " << z;
        EXPECT_LT(f_p - I / (2 * p_f) * f_I, 0) << "chi " << chi << " z " << z;
      }
    if (coefficient == FrictionCoefficient::cidr)
      EXPECT_LT(worst, 1e-6);
    else
      EXPECT_GT(worst, 1e-2) << "the plain flow rule is not the consistent one";
  }
}

// mu_2 = sin(phi) is the law without inertia.
TEST(Inertial, ConstantCoefficientIsALimit) {
  for (const FrictionCoefficient coefficient : inertial_coefficients_offered) {
    FrictionParameters p = glass(coefficient), constant = glass(FrictionCoefficient::constant);
    if (coefficient == FrictionCoefficient::mu_i_regularised) continue;  // has no such limit
    p.mu_2 = std::sin(p.phi);
    for (const double chi : {.5, .97, 1.05})
      for (const double div_v : {-50.0, -1.0, -.01, .01, 1.0}) {
        const FrictionalPoint<double> at{.6, 0, chi, div_v, 0, 100, 10};
        EXPECT_NEAR(Relaxed::steady(at, p), Relaxed::steady(at, constant), 1e-12);
        EXPECT_NEAR(Relaxed::stress(at, p).viscosity, Relaxed::stress(at, constant).viscosity, 1e-12);
        EXPECT_EQ(Relaxed::stress(at, p).pressure, Relaxed::stress(at, constant).pressure);
      }
  }
}

/// {p_f, viscosity, steady} of x = (p_c, chi, div_v, gamma).
template <class R>
struct Law {
  FrictionParameters p;
  template <class Number>
  std::array<Number, 3> operator()(const std::array<Number, 4>& x) const {
    const FrictionalPoint<Number> at{Number(.6), Number(0.0), x[1], x[2], Number(0.0), x[0], x[3]};
    const auto sigma = R::stress(at, p);
    return {sigma.pressure, sigma.viscosity, R::steady(at, p)};
  }
};

TEST(Inertial, DerivativesMatchDifferences) {
  for (const FrictionCoefficient coefficient : inertial_coefficients_offered)
    for (const double p_c : {1e-3, 100.0, 1e5})
      for (const double chi : {.2, .97, 1.05})
        for (const double div_v : {-400.0, -10.0, -.5, .5, 2.5}) {
          const FrictionParameters p = glass(coefficient);
          std::ostringstream state;
          state << static_cast<int>(coefficient) << " p_c " << p_c << " chi " << chi << " div v " << div_v;
          const std::array<double, 4> x{p_c, chi, div_v, 10};
          const std::array<double, 4> lengths{p_c, .03 * chi, std::abs(div_v), 10};
          testing::expect_derivatives_match(Law<Relaxed>{p}, x, lengths, state.str(), 1e-7);
          testing::expect_derivatives_match(Law<CriticalState>{p}, x, lengths, state.str(), 1e-7);
        }
}

TEST(Inertial, FiniteAtTheEdges) {  // H15
  using D = Dual<4>;
  for (const FrictionCoefficient coefficient : inertial_coefficients_offered)
    for (const double p_c : {0.0, 1e-300, 1e-28, 1e-9, 100.0, 1e30})
      for (const double chi : {0.0, 1e-300, .5, 1.0, 1.2, 10.0})
        for (const double div_v : {-1e4, -1e-12, 0.0, 1e4})
          for (const double gamma : {1e-7, 10.0, 1e5}) {
            const std::array<D, 4> x{D::variable(p_c, 0), D::variable(chi, 1), D::variable(div_v, 2),
                                     D::variable(gamma, 3)};
            std::ostringstream state;
            state << "p_c " << p_c << " chi " << chi << " div v " << div_v << " gamma " << gamma;
            for (const D& y : Law<Relaxed>{glass(coefficient)}(x)) testing::expect_finite(y, state.str());
            for (const D& y : Law<CriticalState>{glass(coefficient)}(x)) testing::expect_finite(y, state.str());
          }
}

}  // namespace
}  // namespace scree
