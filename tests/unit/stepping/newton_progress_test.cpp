#include "scree/stepping/newton_progress.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace scree::test {
namespace {

TEST(NewtonProgress, KeepsTheJacobianNearTheEndOfFastConvergence) {
  const double tolerance = 1e-3;
  EXPECT_TRUE(keeps_jacobian({1, 0.02}, tolerance));
  EXPECT_FALSE(keeps_jacobian({0.02}, tolerance)) << "the first is always made";
  EXPECT_FALSE(keeps_jacobian({0.19, 0.02}, tolerance)) << "slow";
  EXPECT_FALSE(keeps_jacobian({10, 0.04}, tolerance)) << "far from the tolerance";
  EXPECT_FALSE(keeps_jacobian({1, std::nan("")}, tolerance));
}

TEST(NewtonProgress, AsksNoMoreOfTheLastLinearSystemThanNewtonDoes) {
  const double asked = 1e-2, tolerance = 1e-3;
  EXPECT_EQ(linear_tolerance(asked, {1}, tolerance), asked) << "far";
  EXPECT_DOUBLE_EQ(linear_tolerance(asked, {1, 0.01}, tolerance), 0.03) << "0.3 of the tolerance is left";
  EXPECT_DOUBLE_EQ(linear_tolerance(asked, {1, 1.1e-3}, tolerance), 0.3 / 1.1);
  EXPECT_EQ(linear_tolerance(asked, {1, 1e-4}, tolerance), asked) << "Newton goes on for another reason";
  EXPECT_DOUBLE_EQ(linear_tolerance(1e-10, {1, 2e-3}, tolerance), 3e-9) << "an exact solution is asked for";
  EXPECT_EQ(linear_tolerance(0.5, {1, 2e-3}, tolerance), 0.5);
  EXPECT_EQ(linear_tolerance(asked, {}, tolerance), asked);
  EXPECT_EQ(linear_tolerance(asked, {0}, tolerance), asked);
}

}  // namespace
}  // namespace scree::test
