#include "scree/stepping/scheme.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace scree::test {
namespace {

constexpr TimeScheme all_schemes[] = {TimeScheme::beuler, TimeScheme::bdf, TimeScheme::arkimex};

TEST(Scheme, ExtrapolatesPolynomialsOfItsOrderExactly) {
  const PastSteps past{0.3, 0.5};
  const double dt = 0.7, times[] = {0, -0.3, -0.8};
  for (const TimeScheme name : all_schemes) {
    const Scheme scheme(name);
    const StateWeights weights = scheme.extrapolation(dt, past);
    for (int degree = 0; degree <= 2; ++degree) {
      double sum = 0;
      for (std::size_t k = 0; k < 3; ++k) sum += weights[k] * std::pow(times[k], degree);
      if (degree <= scheme.order())
        EXPECT_NEAR(sum, std::pow(dt, degree), 1e-14) << name_of(name) << ", degree " << degree;
      else
        EXPECT_GT(std::abs(sum - std::pow(dt, degree)), 0.1) << name_of(name) << ", degree " << degree;
    }
  }
}

TEST(Scheme, NeedsAsManyPastStepsAsItsOrder) {
  for (const TimeScheme name : all_schemes) {
    const Scheme scheme(name);
    EXPECT_FALSE(scheme.can_extrapolate({0, 0}));
    EXPECT_EQ(scheme.can_extrapolate({1, 0}), name == TimeScheme::beuler);
    EXPECT_TRUE(scheme.can_extrapolate({1, 1}));
  }
}

/// A step of y' = 2t from y(0) = 0, behind one that ended at t = 0 with the slope of its end.
TEST(Scheme, KnowsTheLocalErrorOfBackwardEulerForStepsOfAnyLength) {
  const Scheme scheme(TimeScheme::beuler);
  for (const double dt : {0.25, 1.0, 1.3}) {
    const double now = 0, before = now - 1 * 0.0;  // the slope at t = 0 is 0
    const StateWeights weights = scheme.extrapolation(dt, {1, 0});
    const double next = now + dt * 2 * dt, line = weights[0] * now + weights[1] * before;
    EXPECT_NEAR(scheme.error_share(dt, {1, 0}) * (next - line), next - dt * dt, 1e-14) << dt;
  }
}

/// A step of y' = t^2 from the exact states.
TEST(Scheme, KnowsTheLocalErrorsOfOrderTwo) {
  const auto y = [](double t) { return t * t * t / 3; };
  for (const double dt : {0.25, 1.0, 1.3}) {
    const double d1 = 1, d2 = 0.8, c = 2 - std::sqrt(2.0);
    const PastSteps past{d1, d2};
    const double bdf = dt * dt * (dt + d1) * 2 / 6;  // the slope of a parabola at one of its points
    const double tr_bdf = dt * dt * dt * (c * c / std::sqrt(8.0) + 1 - std::sqrt(0.5)) - y(dt);  // as a quadrature
    for (const auto& [name, error] : {std::pair{TimeScheme::bdf, bdf}, {TimeScheme::arkimex, tr_bdf}}) {
      const Scheme scheme(name);
      const StateWeights weights = scheme.extrapolation(dt, past);
      const double parabola = weights[0] * y(0) + weights[1] * y(-d1) + weights[2] * y(-d1 - d2);
      EXPECT_NEAR(scheme.error_share(dt, past) * (y(dt) - parabola), error, 1e-14) << name_of(name) << ", " << dt;
    }
  }
}

/// A tenth of the accuracy takes a tenth of the length of the steps where the order is 1, and so on.
TEST(Scheme, AllowsLocalErrorsThatLeaveTheAccuracyAskedFor) {
  for (const TimeScheme name : all_schemes) {
    const Scheme scheme(name);
    const double ratio = scheme.local_tolerance(1e-2) / scheme.local_tolerance(1e-3);
    EXPECT_NEAR(std::pow(ratio, scheme.order() / (scheme.order() + 1.0)), 10, 1e-12) << name_of(name);
  }
}

}  // namespace
}  // namespace scree::test
