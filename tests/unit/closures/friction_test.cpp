#include "scree/closures/friction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

#include "derivative_check.hpp"
#include "scree/closures/rheology/critical_state.hpp"
#include "scree/closures/rheology/instantaneous.hpp"
#include "scree/closures/rheology/none.hpp"
#include "scree/closures/rheology/relaxed.hpp"

namespace scree {
namespace {

const double sin_phi = std::sin(FrictionParameters{}.phi);

/// Stress of a rheology that takes these from a point alone.
template <class R, class Number>
FrictionalStress<Number> stress(const Number& p_c, const Number& chi, const Number& div_v, const Number& gamma,
                                const FrictionParameters& p) {
  return R::stress(FrictionalPoint<Number>{Number(.6), Number(0.0), chi, div_v, Number(0.0), p_c, gamma}, p);
}

// The two branches of (14) meet at chi = 1 with one value and one slope, -1 in units of sqrt(2) sin(phi).
TEST(Friction, BranchesOfTheYieldSurfaceMeet) {
  const FrictionParameters p;
  const double h = 1e-6;
  for (const double side : {-1.0, 1.0}) {
    EXPECT_NEAR(yield_factor(1 + side * h, p), friction_coefficient(p), 2 * h);
    const Dual<1> at = yield_factor(Dual<1>::variable(1 + side * h, 0), p);
    EXPECT_NEAR(at.derivative[0], -friction_coefficient(p), 1e-4);
  }
}

TEST(Friction, DefaultExponentOfDilation) {
  EXPECT_NEAR(FrictionParameters{}.n_dilation, std::sqrt(3.0) / (2 * sin_phi), 1e-12);
}

/// tests/VERIFICATION.md section 1, recomputed with 40 digits; cgs.
struct PressureRow {
  double nu, p_c, wave_speed;
};
const std::vector<PressureRow> pressures = {
    {.51, .9296721604, 8.6927836}, {.52, 5.386581487, 16.036965}, {.55, 125, 62.28411},
    {.58, 1903.968585, 251.61339}, {.59, 5208.333333, 435.40252}, {.60, 16000, 813.6762},
    {.61, 59082.03125, 1707.9401}, {.62, 296296.2963, 4327.9759}, {.63, 2640625, 15545.054},
};

TEST(CriticalPressure, ReferenceValuesAndWaveSpeeds) {
  const FrictionParameters p;
  for (const PressureRow& row : pressures) {
    const Dual<1> p_c = critical_pressure(Dual<1>::variable(row.nu, 0), p);
    EXPECT_NEAR(p_c.value, .1 * row.p_c, 1e-9 * p_c.value) << "nu = " << row.nu;
    EXPECT_NEAR(std::sqrt(p_c.derivative[0] / 2900), .01 * row.wave_speed, 1e-9 * row.wave_speed) << "nu = " << row.nu;
  }
}

TEST(CriticalPressure, FootHasNoSlope) {
  const FrictionParameters p;
  for (double nu : {0.0, .4, .5}) {
    const Dual<1> p_c = critical_pressure(Dual<1>::variable(nu, 0), p);
    EXPECT_EQ(p_c.value, 0);
    EXPECT_EQ(p_c.derivative[0], 0);
  }
  EXPECT_LT(critical_pressure(Dual<1>::variable(.5 + 1e-9, 0), p).derivative[0], 1e-4);
}

TEST(CriticalPressure, IsNotCapped) {
  const FrictionParameters p;
  EXPECT_GT(critical_pressure(p.nu_max - 1e-9, p), 1e40);
  EXPECT_EQ(critical_pressure(p.nu_max, p), std::numeric_limits<double>::infinity());
  EXPECT_EQ(critical_pressure(p.nu_max + 1e-3, p), std::numeric_limits<double>::infinity());
}

TEST(CriticalPressure, RealExponents) {
  FrictionParameters p;
  p.r = 1.7;
  p.s = 4.3;
  EXPECT_NEAR(critical_pressure(.58, p), .05 * std::pow(.08, 1.7) / std::pow(.07, 4.3), 1e-10);
  p.r = 2;
  p.s = 8;  // H3
  EXPECT_NEAR(critical_pressure(.58, p), .05 * std::pow(.08, 2) / std::pow(.07, 8), 1e-7);
}

TEST(StrainRate, WithAndWithoutFluctuation) {
  FrictionParameters p;
  p.strain_rate_floor = 0;
  EXPECT_DOUBLE_EQ(fluctuating_strain_rate(44.0, 1e-4, p), 12);  // T/d^2 = 100
  p.fluctuation = 0.16;
  EXPECT_DOUBLE_EQ(fluctuating_strain_rate(9.0, 1e-4, p), 5);
  p.fluctuation = 0;
  EXPECT_DOUBLE_EQ(fluctuating_strain_rate(25.0, 1e-4, p), 5);
  p.strain_rate_floor = 1e-6;
  EXPECT_DOUBLE_EQ(fluctuating_strain_rate(0.0, 1e-4, p), 1e-6);
  p.strain_rate_floor = 1e-4;
  EXPECT_DOUBLE_EQ(fluctuating_strain_rate(0.0, 1e-4, p), 1e-4);
}

/// (21) at 40 digits, gamma^2 = 25 + 100.
struct ChiRow {
  double div_v, chi_star;
};
TEST(ChiStar, ReferenceValues) {
  const FrictionParameters p;
  const double gamma = std::sqrt(125.0);
  const std::vector<ChiRow> rows = {
      {0, 1}, {1, .940069316392918}, {-1, 1.00363821474133}, {5, .690534231798677}, {-30, 1.04857767913951}};
  for (const ChiRow& row : rows) EXPECT_NEAR(chi_star(row.div_v, gamma, p), row.chi_star, 1e-12) << row.div_v;
}

// T3: at S = 0 gamma = sqrt(T)/d, so chi* = (1 - E d/(n sqrt(2T) sin phi))^(n-1).
TEST(ChiStar, PureExpansion) {
  FrictionParameters p;
  p.strain_rate_floor = 0;
  const double T = 4e-4, E = 7;
  const double base = 1 - E * p.d / (p.n_dilation * std::sqrt(2 * T) * sin_phi);
  EXPECT_NEAR(chi_star(E, fluctuating_strain_rate(0.0, T, p), p), std::pow(base, p.n_dilation - 1), 1e-14);
}

TEST(ChiStar, ClipsAreBoundedAndSmooth) {
  const FrictionParameters p;
  EXPECT_NEAR(maximum_chi(p), 1.1119147186066, 1e-12);  // (n/(n-1))^(n-1), mpmath
  EXPECT_EQ(chi_star(10.0, 1.0, p), 0);
  EXPECT_DOUBLE_EQ(chi_star(-1000.0, 1.0, p), maximum_chi(p));
  EXPECT_DOUBLE_EQ(yield_factor(maximum_chi(p), p) + 1, 1);
  // No jump of value or slope (times gamma = 1) anywhere but at div v = 0, where the slope jumps.
  const double step = 1e-4;
  Dual<1> last = chi_star<Dual<1>>(Dual<1>::variable(-40, 0), 1.0, p);
  for (double div_v = -40 + step; div_v < 2; div_v += step) {
    const Dual<1> next = chi_star<Dual<1>>(Dual<1>::variable(div_v, 0), 1.0, p);
    ASSERT_NEAR(next.value - last.value, step * (next.derivative[0] + last.derivative[0]) / 2, 1e-4) << div_v;
    ASSERT_LE(next.value, last.value + 1e-15) << "chi* falls with dilation, " << div_v;
    if (std::abs(div_v) > 2 * step) {
      ASSERT_NEAR(next.derivative[0], last.derivative[0], .12) << div_v;
    }
    last = next;
  }
}

// (13) is the normal of (14): chi* is where div v = -sqrt(S:S) dA/dp_f, differences of A at fixed p_c.
TEST(ChiStar, FollowsFromTheFlowRule) {
  const FrictionParameters p;
  const double gamma = 10;
  for (double div_v : {-20.0, -2.0, 1.0, 5.0, 10.0}) {
    const double chi = chi_star(div_v, gamma, p), h = 1e-5;
    const auto A = [&](double x) { return -x * yield_factor(x, p); };  // per p_c
    const double slope = (A(chi + h) - A(chi - h)) / (2 * h);
    EXPECT_NEAR(-gamma * slope, div_v, 1e-5 * std::abs(div_v));
  }
}

// Figs. 1 and 2: sigma_1,2/p_c = chi (1 +- sin(phi) {...}); 1 +- sin(phi) at the critical state, one point at the tip.
TEST(YieldFactor, Loci) {
  const FrictionParameters p;
  const double unit = std::sqrt(2.0) * sin_phi;
  EXPECT_NEAR(yield_factor(1.0, p), unit, 1e-14);
  EXPECT_NEAR(yield_factor(0.0, p), unit * p.n_dilation, 1e-14);
  // n = sqrt(3)/(2 sin phi): braces 0.5 at chi = ((n-0.5)/(n-1))^(n-1)
  const double n = p.n_dilation;
  EXPECT_NEAR(yield_factor_of_branch(std::pow((n - .5) / (n - 1), n - 1), n, p), unit * .5, 1e-14);
  for (double chi : {1.112, 1.2, 5.0, 1e10, 1e200}) EXPECT_EQ(yield_factor(chi, p), 0) << "no overflow";
}

TEST(FrictionalStress, CriticalStateIsDruckerPrager) {
  const FrictionParameters p;
  const auto sigma = stress<CriticalState>(100.0, 0.3, 4.0, 5.0, p);  // chi and div v have no effect
  EXPECT_EQ(sigma.pressure, 100);
  EXPECT_NEAR(2 * sigma.viscosity * 5, std::sqrt(2.0) * 100 * sin_phi, 1e-12);
}

TEST(FrictionalStress, NoneIsZero) {
  const auto sigma = stress<NoFriction>(100.0, 1.0, 4.0, 5.0, FrictionParameters{});
  EXPECT_EQ(sigma.pressure, 0);
  EXPECT_EQ(sigma.viscosity, 0);
}

// T2: plane shear stress p_f sin(phi) gdot/sqrt(gdot^2 + 2T/d^2), S:S = gdot^2/2; T3: T -> 0 gives p_f sin(phi).
TEST(FrictionalStress, PlaneShear) {
  FrictionParameters p;
  p.strain_rate_floor = 0;
  const double rate = 8, p_c = 100;
  for (double T : {0.0, 1e-5, 1e-4}) {
    const auto sigma = stress<Relaxed>(p_c, 1.0, 0.0, fluctuating_strain_rate(rate * rate / 2, T, p), p);
    EXPECT_NEAR(2 * sigma.viscosity * rate / 2, p_c * sin_phi * rate / std::sqrt(rate * rate + 2 * T / (p.d * p.d)),
                1e-11);
  }
}

TEST(FrictionalStress, InstantaneousIsRelaxedAtSteadyChi) {
  const FrictionParameters p;
  const double gamma = 10, p_c = 100;
  for (double div_v : {-100.0, -20.0, -1e-3, 0.0, 1e-3, 5.0, 8.0}) {
    const auto a = stress<Instantaneous>(p_c, -1.0, div_v, gamma, p);
    const auto b = stress<Relaxed>(p_c, chi_star(div_v, gamma, p), div_v, gamma, p);
    EXPECT_NEAR(a.pressure, b.pressure, 1e-12 * p_c) << "div v = " << div_v;
    EXPECT_NEAR(a.viscosity, b.viscosity, 1e-11 * p_c / gamma) << "div v = " << div_v;
  }
}

// The smallest principal stress of (10) is not negative where n = sqrt(3)/(2 sin phi): grains do not pull.
TEST(FrictionalStress, NoTensionInDilation) {
  const FrictionParameters p;
  for (double chi : {0.0, .1, .5, 1.0})
    EXPECT_LE(std::sqrt(2.0 / 3) * yield_factor(chi, p), 1 + 1e-12) << "chi = " << chi;
}

/// All frictional closures of x = (nu, T, chi, div_v, S_S).
template <class R>
struct AllFriction {
  FrictionParameters p;
  template <class Number>
  std::array<Number, 7> operator()(const std::array<Number, 5>& x) const {
    const Number gamma = fluctuating_strain_rate(x[4], x[1], p);
    const Number p_c = critical_pressure(x[0], p);
    const FrictionalPoint<Number> q{x[0], x[1], x[2], x[3], x[4], p_c, gamma};
    const auto sigma = R::stress(q, p);
    return {
        p_c, gamma, chi_star(x[3], gamma, p), yield_factor(x[2], p), sigma.pressure, sigma.viscosity, R::steady(q, p)};
  }
};

template <class R>
class EachRheology : public ::testing::Test {};
using Rheologies = ::testing::Types<NoFriction, CriticalState, Instantaneous, Relaxed>;
TYPED_TEST_SUITE(EachRheology, Rheologies);

TYPED_TEST(EachRheology, DerivativesMatchDifferences) {
  for (double fluctuation : {1.0, 0.1, 0.0})
    for (double nu : {.4, .52, .6, .64})
      for (double chi : {.2, .97, 1.05})
        for (double div_v : {-400.0, -10.0, -.5, .5, 2.5}) {
          AllFriction<TypeParam> f;
          f.p.fluctuation = fluctuation;
          std::ostringstream state;
          state << "nu " << nu << " chi " << chi << " div v " << div_v;
          const double to_foot = std::abs(nu - .5);
          testing::expect_derivatives_match(f, std::array<double, 5>{nu, 1e-4, chi, div_v, 25},
                                            {std::min(to_foot, .65 - nu), 1e-4, .03 * chi, std::abs(div_v), 25},
                                            state.str(), 1e-7);
        }
}

TYPED_TEST(EachRheology, FiniteAtTheEdges) {  // H15
  using D = Dual<5>;
  for (double fluctuation : {1.0, 0.1, 0.0})
    for (double nu : {0.0, .5, .5 + 1e-12, .6, .65 - 1e-9})
      for (double T : {0.0, 1e-14, 1e-4})
        for (double chi : {0.0, 1e-300, .5, 1.0, 1.1, 1.2, 10.0})
          for (double div_v : {-1e4, -1e-12, 0.0, 1e-12, 1e4})
            for (double S_S : {0.0, 1e-14, 25.0}) {
              AllFriction<TypeParam> f;
              f.p.fluctuation = fluctuation;
              const auto result = f(std::array<D, 5>{D::variable(nu, 0), D::variable(T, 1), D::variable(chi, 2),
                                                     D::variable(div_v, 3), D::variable(S_S, 4)});
              for (std::size_t r = 0; r < result.size(); ++r) {
                std::ostringstream state;
                state << "closure " << r << " at nu " << nu << " T " << T << " chi " << chi << " div v " << div_v
                      << " S:S " << S_S;
                testing::expect_finite(result[r], state.str());
              }
            }
}

TYPED_TEST(EachRheology, SteadyValue) {
  const FrictionParameters p;
  for (double div_v : {-5.0, 2.0}) {
    const double expected = !TypeParam::has_friction                   ? 0
                            : std::is_same_v<TypeParam, CriticalState> ? 1
                                                                       : chi_star(div_v, 10.0, p);
    for (double p_c : {100.0, 0.0})
      EXPECT_DOUBLE_EQ(TypeParam::steady(FrictionalPoint<double>{.6, 0, .9, div_v, 0, p_c, 10.0}, p), expected) << p_c;
  }
}

}  // namespace
}  // namespace scree
