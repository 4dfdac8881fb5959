/// What a partly filled cell presses on the cell below it with.
#include "scree/kernels/surface_stress.hpp"

#include <gtest/gtest.h>

namespace scree {
namespace {

constexpr double half = 30;  // Pa, half of the weight of a full cell over its area

TEST(RestingExcess, FrictionUnderATopRowAtRestCarriesTheRow) {
  for (const double fill : {0.1, 0.5, 0.9, 1.0}) {
    const double own = fill * half, below = 2 * own + half;  // what the full cell below carries
    const double edge = 0.5 * (resting_excess(0.0, own, below, half) + below);
    EXPECT_GE(edge, 2 * own * 0.99) << fill;
    EXPECT_NEAR(resting_excess(0.0, own, below, half), own, 0.05 * own) << fill;
  }
}

TEST(RestingExcess, LeavesWhatFallsAndWhatCarriesItself) {
  EXPECT_EQ(resting_excess(0.0, half, 0.0, half), 0.0);
  EXPECT_EQ(resting_excess(3 * half, half, 5 * half, half), 0.0);
  EXPECT_EQ(resting_excess(0.0, 0.0, 100.0, half), 0.0);  // an empty cell
}

TEST(RestingExcess, NeverExceedsHalfTheWeight) {
  for (double below = 0; below < 1000; below += 7) {
    const double p = resting_excess(0.0, half, below, half);
    EXPECT_GE(p, 0.0) << below;
    EXPECT_LE(p, half) << below;
  }
}

}  // namespace
}  // namespace scree
