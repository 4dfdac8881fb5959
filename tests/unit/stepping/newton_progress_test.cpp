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

}  // namespace
}  // namespace scree::test
