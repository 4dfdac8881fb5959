/// What is added to nu in voids.
#include "scree/closures/voids.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace scree {
namespace {

TEST(VoidFloor, IsEpsInVoidsAndFades) {
  const double eps = 1e-5;
  EXPECT_EQ(void_floor(0.0, eps), eps);
  EXPECT_DOUBLE_EQ(void_floor(10 * eps, eps), eps / 2);
  EXPECT_NEAR(-1e-3 + void_floor(-1e-3, eps), eps, 1e-17) << "nu below zero: what is stored stays";
  EXPECT_LT(void_floor(0.02, eps), 1e-12 * 0.02);
  EXPECT_GT(void_floor(0.02, eps), 0.0);
}

TEST(VoidFloor, KeepsStorageAndItsSlopePositive) {
  for (double nu = 1e-9; nu < 0.65; nu *= 1.1) {
    const auto stored = Dual<1>::variable(nu, 0) + void_floor(Dual<1>::variable(nu, 0), 1e-5);
    EXPECT_GE(stored.value, nu) << "nu " << nu;
    EXPECT_GT(stored.derivative[0], 0.5) << "nu " << nu;
  }
}

TEST(VoidFloor, DerivativeIsThatOfDifferences) {
  for (const double nu : {1e-6, 1e-4, 3e-4, 1e-2}) {
    const double step = 1e-4 * nu;
    const double slope = (void_floor(nu + step, 1e-5) - void_floor(nu - step, 1e-5)) / (2 * step);
    EXPECT_NEAR(void_floor(Dual<1>::variable(nu, 0), 1e-5).derivative[0], slope,
                1e-6 * std::abs(slope) + 1e-12 * 1e-5 / step);
  }
}

}  // namespace
}  // namespace scree
