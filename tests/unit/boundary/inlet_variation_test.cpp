/// Shapes, profiles, histories and starts of what inlets bring.
#include "scree/boundary/inlet_variation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scree/boundary/segment.hpp"

namespace scree {
namespace {

FaceExtent along_x(double lower, double upper) { return {{lower, 0, 0}, {upper, 0, 0}}; }

InletVariation over(InletShape shape, double lower, double upper) {
  InletVariation variation;
  variation.shape = shape;
  variation.lower[0] = lower;
  variation.upper[0] = upper;
  return variation;
}

TEST(InletVariation, IsOneUnlessSaidOtherwise) { EXPECT_EQ(InletVariation().value(along_x(1, 2), -5), 1); }

/// (1/h) times the integral of 3/2 (1 - s^2), and of 8/7 (1 - |s|)^(1/7).
TEST(InletVariation, ShapesAreMeansOverTheFace) {
  const InletVariation parabola = over(InletShape::parabolic, 2, 6);
  EXPECT_NEAR(parabola.value(along_x(3.999, 4.001), 0), 1.5, 1e-6) << "in the middle";
  EXPECT_DOUBLE_EQ(parabola.value(along_x(2, 3), 0), 1.5 * (1 - (1 - 0.125) / 3 / 0.5)) << "s from -1 to -1/2";
  EXPECT_DOUBLE_EQ(parabola.value(along_x(5, 6), 0), parabola.value(along_x(2, 3), 0)) << "symmetric";
  const InletVariation power = over(InletShape::power, 2, 6);
  EXPECT_NEAR(power.value(along_x(4 - 1e-4, 4 + 1e-4), 0), 8.0 / 7, 1e-4);
  EXPECT_NEAR(power.value(along_x(2, 3), 0), 2 * std::pow(0.5, 8.0 / 7), 1e-14);
}

TEST(InletVariation, ShapesHaveMeanOneOnAnyGrid) {
  for (const InletShape shape : {InletShape::uniform, InletShape::parabolic, InletShape::power}) {
    InletVariation variation = over(shape, -1, 3);
    variation.lower[2] = 5;
    variation.upper[2] = 6;
    const std::vector<double> x{-1, -0.7, 0.4, 1.9, 2.8, 3}, z{5, 5.1, 5.8, 6};
    double sum = 0;
    for (std::size_t i = 1; i < x.size(); ++i)
      for (std::size_t k = 1; k < z.size(); ++k)
        sum += (x[i] - x[i - 1]) * (z[k] - z[k - 1]) * variation.value({{x[i - 1], 0, z[k - 1]}, {x[i], 0, z[k]}}, 0);
    EXPECT_NEAR(sum / 4, 1, 1e-14);
  }
}

TEST(InletVariation, RisesSmoothly) {
  InletVariation variation;
  variation.begin = 2;
  variation.rise_time = 4;
  for (const auto& [time, expected] : {std::pair(1.0, 0.0), std::pair(2.0, 0.0), std::pair(3.0, 0.15625),
                                       std::pair(4.0, 0.5), std::pair(6.0, 1.0), std::pair(9.0, 1.0)})
    EXPECT_DOUBLE_EQ(variation.value(along_x(0, 1), time), expected) << "at " << time;
}

TEST(InletVariation, PartsAreFactors) {
  InletVariation variation = over(InletShape::parabolic, 0, 2);
  const double shape = variation.value(along_x(0, 1), 0);
  variation.profile = {{0, 1}, {1, 3}};
  variation.history = {{0, 10}, {0, 1}};
  EXPECT_DOUBLE_EQ(variation.value(along_x(0, 1), 5), shape * 2 * 0.5);
}

TEST(SolidsVelocity, VariesAtInletsAlone) {
  Condition condition;
  condition.velocity = {1, -2, 0};
  condition.variation.history = {{0}, {0.25}};
  condition.kind = BoundaryKind::inlet;
  EXPECT_DOUBLE_EQ(solids_velocity(condition, 1, along_x(0, 1), 0), -0.5);
  EXPECT_DOUBLE_EQ(solids_velocity(condition, 0, along_x(0, 1), 0), 0.25);
  condition.kind = BoundaryKind::wall_no_slip;
  EXPECT_DOUBLE_EQ(solids_velocity(condition, 1, along_x(0, 1), 0), -2);
}

TEST(Plate, SlidesAsAWholeInItsTime) {
  Plate plate;
  plate.span.lower[0] = 1;
  plate.span.upper[0] = 5;
  plate.openings.resize(1);
  plate.openings[0].lower[0] = 2;
  plate.openings[0].upper[0] = 3;
  plate.slide_speed = -0.5;
  plate.slide_from = 10;
  plate.slide_until = 14;
  for (const auto& [time, distance] : {std::pair(0.0, 0.0), std::pair(10.0, 0.0), std::pair(12.0, -1.0),
                                       std::pair(14.0, -2.0), std::pair(20.0, -2.0)}) {
    const Plate moved = plate.at(time);
    EXPECT_NEAR(moved.span.lower[0], 1 + distance, 1e-8) << "at " << time;
    EXPECT_NEAR(moved.openings[0].upper[0], 3 + distance, 1e-8) << "at " << time;
    EXPECT_EQ(moved.condition.velocity[0], time >= 10 && time < 14 ? -0.5 : 0) << "at " << time;
  }
}

TEST(Plate, TellsWhenFacesOpenAndClose) {
  Plate plate;
  plate.span.lower[0] = 0;
  plate.slide_speed = 2;
  plate.slide_from = 1;
  plate.slide_until = 2;
  plate.condition.from = 0.5;
  std::vector<double> times = plate.events({0.25, 0.75, 1.75, 2.25});
  std::sort(times.begin(), times.end());
  EXPECT_EQ(times, (std::vector<double>{0.5, 1, 1.125, 1.375, 1.875, 2}));
  EXPECT_GT(plate.at(1.125).span.lower[0], 0.25) << "the face at .25 is open from then on";
  EXPECT_LT(plate.at(1.125).span.lower[0], 0.2500001);
}

}  // namespace
}  // namespace scree
