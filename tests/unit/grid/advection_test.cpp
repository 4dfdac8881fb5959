#include "scree/grid/advection.hpp"

#include <gtest/gtest.h>

namespace scree {
namespace {

TEST(VanAlbada, IsAMeanOfSlopesOfOneSignAndZeroOtherwise) {
  struct Row {
    double a, b, expected;
  };
  const Row rows[] = {{2, 2, 2},      {-2, -2, -2}, {1, 2, 1.2}, {2, 1, 1.2},
                      {-1, -2, -1.2}, {1, -1, 0},   {0, 3, 0},   {0, 0, 0}};
  for (const Row& row : rows) EXPECT_NEAR(van_albada(row.a, row.b), row.expected, 1e-15) << row.a << ", " << row.b;
}

TEST(VanAlbada, NeverExceedsTwiceTheSmallerSlope) {
  for (double ratio = 1e-3; ratio < 1e3; ratio *= 1.3) {
    const double limited = van_albada(1.0, ratio);
    EXPECT_GT(limited, 0) << ratio;
    EXPECT_LE(limited, 1.21 * std::max(1.0, ratio)) << ratio;
    EXPECT_LE(limited, 2 * std::min(1.0, ratio)) << ratio;
  }
}

TEST(VanAlbada, DerivativesMatchDifferences) {
  for (const auto& [a, b] : {std::pair(1.0, 2.0), std::pair(-3.0, -0.2), std::pair(1.0, -1.0)}) {
    const auto result = van_albada(Dual<2>::variable(a, 0), Dual<2>::variable(b, 1));
    const double h = 1e-6;
    EXPECT_NEAR(result.derivative[0], (van_albada(a + h, b) - van_albada(a - h, b)) / (2 * h), 1e-8) << a << ", " << b;
    EXPECT_NEAR(result.derivative[1], (van_albada(a, b + h) - van_albada(a, b - h)) / (2 * h), 1e-8) << a << ", " << b;
  }
}

TEST(OneSidedSlope, IsTheSlopeToSecondOrderAndNeverEmptiesACell) {
  for (const double slope : {2.0, -2.0}) {
    const double coarse = one_sided_slope(slope, 3 / 0.1) - slope, fine = one_sided_slope(slope, 3 / 0.05) - slope;
    EXPECT_NEAR(coarse / fine, 2, 0.1) << "an error in proportion to the reach, which multiplies it once more";
  }
  for (double slope = 1e-3; slope < 1e5; slope *= 3) {
    EXPECT_LE(one_sided_slope(slope, 5.0), 1.21 * 5.0) << slope;
    EXPECT_DOUBLE_EQ(one_sided_slope(-slope, 5.0), -one_sided_slope(slope, 5.0));
  }
  EXPECT_EQ(one_sided_slope(7.0, 0.0), 0.0) << "an empty cell";
  EXPECT_EQ(one_sided_slope(0.0, 0.0), 0.0);
}

TEST(OneSidedSlope, DerivativesMatchDifferences) {
  for (const auto& [slope, steepest] : {std::pair(1.0, 2.0), std::pair(-3.0, 0.2)}) {
    const auto result = one_sided_slope(Dual<2>::variable(slope, 0), Dual<2>::variable(steepest, 1));
    const double h = 1e-6;
    EXPECT_NEAR(result.derivative[0],
                (one_sided_slope(slope + h, steepest) - one_sided_slope(slope - h, steepest)) / (2 * h), 1e-8);
    EXPECT_NEAR(result.derivative[1],
                (one_sided_slope(slope, steepest + h) - one_sided_slope(slope, steepest - h)) / (2 * h), 1e-8);
  }
}

TEST(Upwind, TakesTheUpstreamSideAndTheLowerOneAtRest) {
  EXPECT_EQ(upwind(1.0, 3.0, 4.0), 3);
  EXPECT_EQ(upwind(-1.0, 3.0, 4.0), 4);
  EXPECT_EQ(upwind(0.0, 3.0, 4.0), 3);
}

TEST(LimitedUpwind, IsExactForLinearValuesOnAnyGrid) {
  const double far_lower = 0.0, lower = 0.7, upper = 1.5, far_upper = 3.1, crossing = 1.2;
  const AdvectionMetrics h{lower - far_lower, upper - lower, far_upper - upper, crossing - lower, upper - crossing};
  const auto line = [](double x) { return 5 - 2 * x; };
  for (const double flow : {1.0, -1.0})
    EXPECT_NEAR(limited_upwind(flow, line(far_lower), line(lower), line(upper), line(far_upper), h), line(crossing),
                1e-14)
        << "flow " << flow;
}

TEST(LimitedUpwind, FallsBackToTheUpstreamValueAtAnExtremum) {
  const AdvectionMetrics h{1, 1, 1, 0.5, 0.5};
  EXPECT_EQ(limited_upwind(1.0, 0.0, 2.0, 1.0, 0.0, h), 2.0) << "maximum upstream";
  EXPECT_EQ(limited_upwind(-1.0, 0.0, 1.0, 2.0, 0.0, h), 2.0);
}

TEST(LimitedUpwind, StaysBetweenTheNeighboursOnAUniformGrid) {
  const AdvectionMetrics h{1, 1, 1, 0.5, 0.5};
  for (const double slope : {0.01, 0.5, 1.0, 3.0, 100.0}) {
    const double up = limited_upwind(1.0, -slope, 0.0, 1.0, 7.0, h),
                 down = limited_upwind(-1.0, 7.0, 1.0, 0.0, -slope, h);
    EXPECT_GE(up, 0.0) << slope;
    EXPECT_LE(up, 1.0) << slope;
    EXPECT_DOUBLE_EQ(up, down) << "mirrored, slope " << slope;
  }
}

TEST(LimitedUpwind, UsesNothingDownstreamOfTheUpperNeighbour) {
  const AdvectionMetrics h{1, 1, 1, 0.5, 0.5};
  EXPECT_EQ(limited_upwind(1.0, 0.0, 1.0, 1.5, 9.0, h), limited_upwind(1.0, 0.0, 1.0, 1.5, -9.0, h));
  EXPECT_EQ(limited_upwind(-1.0, 9.0, 1.0, 1.5, 4.0, h), limited_upwind(-1.0, -9.0, 1.0, 1.5, 4.0, h));
}

}  // namespace
}  // namespace scree
