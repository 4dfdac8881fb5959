/// Flows of gas that sides let in: factors along the side and in time.
#include "scree/boundary/segment.hpp"

#include <gtest/gtest.h>

namespace scree {
namespace {

/// A face without extent.
FaceExtent at_point(const std::array<double, max_dim>& point) { return {point, point}; }

TEST(Ramp, WithoutPointsIsOne) {
  for (const double x : {-1e9, 0.0, 3.0}) EXPECT_EQ(Ramp().value(x), 1) << "at " << x;
}

TEST(Ramp, OnePointIsAConstant) {
  const Ramp ramp{{2}, {0.4}};
  for (const double x : {-1.0, 2.0, 5.0}) EXPECT_EQ(ramp.value(x), 0.4) << "at " << x;
}

TEST(Ramp, IsLinearBetweenItsPointsAndConstantBeyond) {
  const Ramp ramp{{1, 3, 4}, {2, 6, -1}};
  for (const auto& [x, expected] :
       {std::pair(-10.0, 2.0), std::pair(1.0, 2.0), std::pair(1.5, 3.0), std::pair(2.0, 4.0), std::pair(3.0, 6.0),
        std::pair(3.5, 2.5), std::pair(4.0, -1.0), std::pair(9.0, -1.0)})
    EXPECT_DOUBLE_EQ(ramp.value(x), expected) << "at " << x;
}

TEST(Ramp, JumpTakesTheLaterValue) {
  const Ramp ramp{{0, 1, 1, 2}, {0, 1, 5, 5}};
  EXPECT_DOUBLE_EQ(ramp.value(0.999), 0.999);
  EXPECT_DOUBLE_EQ(ramp.value(1), 5);
  EXPECT_DOUBLE_EQ(ramp.value(1.5), 5);
}

TEST(GasInflow, IsVelocityTimesProfileTimesHistory) {
  Condition inlet;
  inlet.kind = BoundaryKind::gas_inlet;
  inlet.gas_velocity = 2;
  EXPECT_DOUBLE_EQ(gas_inflow(inlet, at_point({7, 8, 9}), 5), 2) << "without profile and history";
  inlet.gas_variation.profile = {{0, 1}, {1, 3}};
  inlet.gas_variation.axis = 1;
  EXPECT_DOUBLE_EQ(gas_inflow(inlet, at_point({7, 0.25, 9}), 5), 2 * 1.5) << "the profile is along y";
  inlet.gas_variation.axis = 2;
  EXPECT_DOUBLE_EQ(gas_inflow(inlet, at_point({7, 0.25, 0.5}), 5), 2 * 2) << "the profile is along z";
  inlet.gas_variation.history = {{0, 10}, {0, 1}};
  EXPECT_DOUBLE_EQ(gas_inflow(inlet, at_point({7, 0.25, 0.5}), 5), 2 * 2 * 0.5);
  EXPECT_DOUBLE_EQ(gas_inflow(inlet, at_point({7, 0.25, 0.5}), -1), 0);
  inlet.gas_velocity = -2;
  EXPECT_DOUBLE_EQ(gas_inflow(inlet, at_point({7, 0.25, 0.5}), 20), -4) << "suction";
}

}  // namespace
}  // namespace scree
