/// What particles press on walls and floors with.
#include "scree/kernels/wall_pressure.hpp"

#include <gtest/gtest.h>

namespace scree {
namespace {

constexpr double half = 30;  // Pa, half of the weight of a full cell over its area

TEST(PressureAtWall, OfABedAtRestIsItsWeight) {
  for (const int cells : {3, 10, 100}) {
    const double p = (2 * cells - 1) * half, next = (2 * cells - 3) * half;
    EXPECT_NEAR(pressure_at_wall(p, p, next, 0.5), 2 * cells * half, 1e-6 * p) << cells;
    EXPECT_NEAR(pressure_at_wall(0.3 * p, p, next, 0.5), 0.3 * 2 * cells * half, 1e-6 * p) << cells;  // p = chi p_c
  }
}

TEST(PressureAtWall, OfCellsThatDifferInLengthIsLinear) {
  // centres 1 and 3.5 from the wall, p = 100 - 4 y
  EXPECT_NEAR(pressure_at_wall(96.0, 96.0, 86.0, 1 / 2.5), 100.0, 1e-10);
}

TEST(PressureAtWall, NeitherPullsNorNeedsFriction) {
  for (double next = 0; next < 1e6; next = 3 * next + 1) EXPECT_GE(pressure_at_wall(1.0, 1.0, next, 0.5), 0.5) << next;
  EXPECT_EQ(pressure_at_wall(2.0, 0.0, 5.0, 0.5), 2.0);
  EXPECT_EQ(pressure_at_wall(0.0, 0.0, 0.0, 0.5), 0.0);
}

TEST(PressureOnFloor, OfALayerAtRestIsItsWeight) {
  for (const double carried_by_p : {0.0, 0.3, 1.0})  // of half of the weight; the stress of surfaces carries the rest
    EXPECT_NEAR(pressure_on_floor(carried_by_p * half, (1 - carried_by_p) * half, half), 2 * half, 0.1 * half);
}

TEST(PressureOnFloor, OfADeepBedIsThatOfItsLastCell) { EXPECT_EQ(pressure_on_floor(7 * half, 0.0, half), 7 * half); }

TEST(PressureOnFloor, OfWhatFallsIsNothing) {
  EXPECT_EQ(pressure_on_floor(0.0, 0.0, half), 0.0);
  EXPECT_EQ(pressure_on_floor(5.0, 0.0, 0.0), 5.0);
}

}  // namespace
}  // namespace scree
