#include "scree/solver/newton_tolerance.hpp"

#include <gtest/gtest.h>

namespace scree::test {
namespace {

void good_steps(NewtonTolerance& tolerance, int count) {
  for (int step = 0; step < count; ++step) tolerance.step_done(false);
}

TEST(NewtonTolerance, IsTightUntilStepsHaveGoneWell) {
  NewtonTolerance tolerance;
  good_steps(tolerance, 19);
  EXPECT_EQ(tolerance.share(), 1e-3);
  good_steps(tolerance, 1);
  EXPECT_EQ(tolerance.share(), 3e-2);
}

TEST(NewtonTolerance, IsTightForTheNextAttemptOfAFailedStep) {
  NewtonTolerance tolerance;
  good_steps(tolerance, 50);
  tolerance.failed();
  EXPECT_EQ(tolerance.share(), 1e-3);
}

TEST(NewtonTolerance, WaitsTwiceAsLongAfterEachFailure) {
  NewtonTolerance tolerance;
  for (const int wait : {40, 80, 160, 320, 640, 1280, 1280}) {
    tolerance.step_done(true);
    good_steps(tolerance, wait - 1);
    EXPECT_EQ(tolerance.share(), 1e-3) << wait;
    good_steps(tolerance, 1);
    EXPECT_EQ(tolerance.share(), 3e-2) << wait;
  }
}

TEST(NewtonTolerance, ForgetsFailuresAfterFourTimesTheWait) {
  NewtonTolerance tolerance;
  tolerance.step_done(true);
  tolerance.step_done(true);
  EXPECT_EQ(tolerance.wait, 80);
  good_steps(tolerance, 319);
  EXPECT_EQ(tolerance.wait, 80);
  good_steps(tolerance, 1);
  EXPECT_EQ(tolerance.wait, 20);
  EXPECT_EQ(tolerance.share(), 3e-2);
}

}  // namespace
}  // namespace scree::test
