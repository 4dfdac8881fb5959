/// What particles press on walls and floors with, and their fraction there.
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

TEST(SolidsFractionAtWall, IsOfSecondOrder) {
  const auto nu = [](double y) { return 0.5 - 3 * y + 40 * y * y; };
  double before = 0;
  for (const double h : {0.004, 0.002, 0.001}) {  // centres h/2 and 2 h from the wall: cells of h and 2 h
    const double error = std::abs(solids_fraction_at_wall(nu(0.5 * h), nu(2 * h), 0.65, 1.0 / 3) - nu(0));
    if (before > 0) {
      EXPECT_NEAR(std::log2(before / error), 2, 0.15) << h;
    }
    before = error;
  }
}

TEST(SolidsFractionAtWall, KeepsItsBounds) {
  for (double nu = 1e-6; nu < 0.65; nu *= 1.1)
    for (double next = 1e-6; next < 0.65; next *= 1.1)
      for (const double to_wall : {0.1, 0.5, 0.9}) {
        const double found = solids_fraction_at_wall(nu, next, 0.65, to_wall);
        EXPECT_GT(found, 0.1 * nu) << next << " " << to_wall;
        EXPECT_LT(found, 0.65) << nu << " " << next;
      }
}

TEST(SolidsFractionAtWall, BesideASurfaceIsThatOfTheCell) {
  EXPECT_EQ(solids_fraction_at_wall(0.3, 0.0, 0.65, 0.5), 0.3);
  EXPECT_NEAR(solids_fraction_at_wall(0.3, 0.003, 0.65, 0.5), 0.3, 1e-4);
  EXPECT_NEAR(solids_fraction_at_wall(0.003, 0.3, 0.65, 0.5), 0.003, 1e-4);
}

}  // namespace
}  // namespace scree
