#include "scree/stepping/scheme.hpp"

#include <gtest/gtest.h>

#include <cmath>

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

/// On x = t^(order+1), with which the extrapolation errs: the estimate is never less than the error of the scheme.
TEST(Scheme, EstimatesTheLocalErrorOnTheSafeSide) {
  for (const double ratio : {0.5, 1.0, 1.3}) {
    const double dt = ratio;
    const PastSteps past{1, 1};
    // Backward Euler from x(0) = 0 with x' = 2t: dt * 2 dt.
    const double euler = 2 * dt * dt, to_extrapolation = euler - (-dt / past[0] * 1);
    EXPECT_GE(Scheme(TimeScheme::beuler).error_share(dt, past) * to_extrapolation, euler - dt * dt) << ratio;
  }
  EXPECT_DOUBLE_EQ(Scheme(TimeScheme::beuler).error_share(1, {1, 1}), 1.0 / 2);
  EXPECT_DOUBLE_EQ(Scheme(TimeScheme::bdf).error_share(1, {1, 1}), 1.0 / 3);
  EXPECT_DOUBLE_EQ(Scheme(TimeScheme::arkimex).error_share(1, {2, 1}), 1.0 / 4);
}

}  // namespace
}  // namespace scree::test
