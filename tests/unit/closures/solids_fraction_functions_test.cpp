/// g0 and p_c, each in all its variants.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "derivative_check.hpp"
#include "scree/closures/friction.hpp"
#include "scree/closures/gas_damping.hpp"
#include "scree/closures/wall.hpp"

namespace scree {
namespace {

template <class Entry>
const Entry* find(const Variants<Entry>& variants, const std::string& name) {
  for (const Entry* entry : variants)
    if (entry->name == name) return entry;
  return nullptr;
}

template <class Entry>
std::vector<std::string> names(const Variants<Entry>& variants) {
  std::vector<std::string> all;
  for (const Entry* entry : variants) all.push_back(entry->name);
  return all;
}

TEST(RadialDistribution, IsListed) {
  EXPECT_EQ(names(radial_distributions()), (std::vector<std::string>{"lun_savage", "carnahan_starling", "ma_ahmadi"}));
  EXPECT_EQ(KineticParameters{}.g0, radial_distributions().front());
}

/// The published equations evaluated apart, nu_max = 0.65; carnahan_starling as its three terms.
struct Row {
  std::string name;
  double nu, g0;
};
const std::vector<Row> rows = {
    {"lun_savage", 0.1, 2.15439372043},        {"lun_savage", 0.5, 11.9417710275},
    {"lun_savage", 0.64, 193.996554641},       {"carnahan_starling", 0.01, 1.02545710137},
    {"carnahan_starling", 0.3, 2.47813411079}, {"carnahan_starling", 0.5, 6},
    {"carnahan_starling", 0.6, 10.9375},       {"carnahan_starling", 0.64, 14.5747599451},
    {"ma_ahmadi", 0.01, 1.02546608721},        {"ma_ahmadi", 0.3, 2.45115205295},
    {"ma_ahmadi", 0.5, 5.98047893863},         {"ma_ahmadi", 0.6, 14.6102200909},
    {"ma_ahmadi", 0.64, 46.0630703049},
};

TEST(RadialDistribution, ReferenceValues) {
  for (const Row& row : rows) {
    KineticParameters p;
    p.g0 = find(radial_distributions(), row.name);
    ASSERT_TRUE(p.g0) << row.name;
    EXPECT_NEAR(radial_distribution(row.nu, p), row.g0, 2e-9 * row.g0) << row.name << " nu " << row.nu;
  }
}

TEST(RadialDistribution, Limits) {
  for (const RadialDistribution* variant : radial_distributions()) {
    KineticParameters p;
    p.g0 = variant;
    EXPECT_EQ(radial_distribution(0.0, p), 1) << variant->name;
    EXPECT_EQ(radial_distribution(p.nu_max, p), std::numeric_limits<double>::infinity())
        << "refused, " << variant->name;
    for (double nu : {-1e-9, 0.0, 1e-12, 1e-5, .3, p.nu_max - 1e-9})
      testing::expect_finite(radial_distribution(Dual<1>::variable(nu, 0), p), variant->name);
    for (double nu = .01; nu < .64; nu += .01)
      EXPECT_GT(radial_distribution(Dual<1>::variable(nu, 0), p).derivative[0], 0) << variant->name;
  }
  KineticParameters finite;
  finite.g0 = find(radial_distributions(), "carnahan_starling");
  EXPECT_NEAR(radial_distribution(finite.nu_max - 1e-12, finite), .675 / (.35 * .35 * .35), 1e-8);
  KineticParameters steep;
  steep.g0 = find(radial_distributions(), "ma_ahmadi");
  const double ratio = radial_distribution(.65 - 1e-9, steep) / radial_distribution(.65 - 1e-8, steep);
  EXPECT_NEAR(ratio, std::pow(10, .67802), 1e-6) << "no cancellation near nu_max";
}

/// All that g0 enters, of x = (nu, T, slip squared).
struct AllOfG0 {
  KineticParameters p;
  template <class Number>
  std::array<Number, 6> operator()(const std::array<Number, 3>& x) const {
    const Number sqrt_T = sqrt_temperature(x[1], 1e-14);
    return {kinetic_pressure(x[0], x[1], p),
            shear_viscosity(x[0], sqrt_T, Number(1e3), p),
            conductivity(x[0], sqrt_T, p),
            kinetic_factors(x[0], p)[factor_shear],
            slip_agitation(x[0], radial_distribution(x[0], p), x[2], 1.8e-5, p),
            wall_heat_flux(x[0], x[1], sqrt_T, x[2], p, WallParameters{})};
  }
};

TEST(RadialDistribution, DerivativesOfTheClosuresMatchDifferences) {
  for (const RadialDistribution* variant : radial_distributions())
    for (double nu : {.01, .3, .58, .64}) {
      AllOfG0 f;
      f.p.g0 = variant;
      testing::expect_derivatives_match(f, std::array<double, 3>{nu, 1e-4, .02},
                                        {std::min(nu, f.p.nu_max - nu), 1e-4, .02},
                                        variant->name + (" nu " + std::to_string(nu)));
    }
}

// (1.1): p_k = rho_s nu (1 + 4 eta nu g0) T, and (25): the wall's collisions with the same g0.
TEST(RadialDistribution, EntersAllClosures) {
  KineticParameters p;
  p.g0 = find(radial_distributions(), "carnahan_starling");
  const double e = (1 + p.e_p) / 2;
  EXPECT_NEAR(kinetic_pressure(.6, 1e-4, p), 2900 * .6 * (1 + 4 * e * .6 * 10.9375) * 1e-4, 1e-12);
  EXPECT_NEAR(wall_collision_rate(.6, 1e-2, p, WallParameters{}),
              pi * std::sqrt(3.0) / (6 * .65) * 2900 * .6 * 10.9375 * 1e-2, 1e-9);
}

TEST(FrictionPressure, IsListed) {
  EXPECT_EQ(names(friction_pressures()), (std::vector<std::string>{"power", "schaeffer"}));
  EXPECT_EQ(FrictionParameters{}.pressure, friction_pressures().front());
}

// 1e25 (nu - nu*)^10 dyn/cm2
TEST(FrictionPressure, Schaeffer) {
  FrictionParameters p;
  p.pressure = find(friction_pressures(), "schaeffer");
  EXPECT_NEAR(critical_pressure(.505, p), 9.765625, 1e-11);
  EXPECT_NEAR(critical_pressure(.51, p), 1e4, 1e-8);
  EXPECT_NEAR(critical_pressure(.6, p), 1e14, 1e2);
  p.nu_min = .59;
  EXPECT_NEAR(critical_pressure(.6, p), 1e4, 1e-8);
}

TEST(FrictionPressure, StartsFromZeroAndGrows) {
  for (const FrictionPressure* variant : friction_pressures()) {
    FrictionParameters p;
    p.pressure = variant;
    for (double nu : {0.0, .4, .5}) EXPECT_EQ(critical_pressure(nu, p), 0) << variant->name;
    EXPECT_LT(critical_pressure(Dual<1>::variable(.5 + 1e-9, 0), p).derivative[0], 1e-4) << variant->name;
    EXPECT_EQ(critical_pressure(p.nu_max, p), std::numeric_limits<double>::infinity()) << variant->name;
    for (double nu = .505; nu < .65; nu += .005) {
      const auto f = [&](const auto& x) {
        return std::array<std::decay_t<decltype(x[0])>, 1>{critical_pressure(x[0], p)};
      };
      testing::expect_derivatives_match(f, std::array<double, 1>{nu}, {.3 * std::min(nu - .5, .65 - nu)},
                                        variant->name + (" nu " + std::to_string(nu)), 1e-7);
      EXPECT_GT(critical_pressure(Dual<1>::variable(nu, 0), p).derivative[0], 0);
    }
  }
}

}  // namespace
}  // namespace scree
