#include "scree/stepping/newton_tolerance.hpp"

#include <gtest/gtest.h>

namespace scree::test {
namespace {

void good_steps(NewtonTolerance& tolerance, int count) {
  for (int step = 0; step < count; ++step) tolerance.step_done(false);
}

TEST(NewtonTolerance, IsTightUntilStepsHaveGoneWell) {
  NewtonTolerance tolerance;
  good_steps(tolerance, 9);
  EXPECT_DOUBLE_EQ(tolerance.residual(2e-3), 1e-6);
  good_steps(tolerance, 1);
  EXPECT_DOUBLE_EQ(tolerance.residual(2e-3), 3e-5);
}

TEST(NewtonTolerance, IsTightForTheNextAttemptOfAFailedStep) {
  NewtonTolerance tolerance;
  good_steps(tolerance, 50);
  tolerance.failed();
  EXPECT_DOUBLE_EQ(tolerance.residual(2e-3), 1e-6);
}

TEST(NewtonTolerance, HasABoundForLooseSteps) {
  NewtonTolerance tolerance;
  EXPECT_DOUBLE_EQ(tolerance.residual(0.2), 1e-4);
  good_steps(tolerance, 20);
  EXPECT_DOUBLE_EQ(tolerance.residual(0.2), 3e-4);
}

TEST(NewtonTolerance, StaysAboveRounding) {
  EXPECT_DOUBLE_EQ(NewtonTolerance().residual(1e-12), NewtonTolerance::least);
  EXPECT_GT(NewtonTolerance::dilute(1e-30), NewtonTolerance::least);
}

TEST(NewtonTolerance, BoundsSingleUnknownsWhereParticlesAreFew) {
  EXPECT_DOUBLE_EQ(NewtonTolerance::dilute(1e-3), 3e-3);
  EXPECT_DOUBLE_EQ(NewtonTolerance::dilute(0.1), 3e-2);
}

TEST(NewtonTolerance, LeavesLessInVelocitiesThanAStepMay) {
  EXPECT_DOUBLE_EQ(NewtonTolerance::velocity(0.02), 6e-3);
  EXPECT_GT(NewtonTolerance::velocity(1e-30), NewtonTolerance::least);
}

TEST(NewtonTolerance, WaitsTwiceAsLongWhereLooseStepsFailSoon) {
  NewtonTolerance tolerance;
  good_steps(tolerance, 10);
  for (const int wait : {20, 40, 80, 160, 160}) {
    tolerance.failed();
    tolerance.step_done(true);
    good_steps(tolerance, wait - 1);
    EXPECT_DOUBLE_EQ(tolerance.residual(2e-3), 1e-6) << wait;
    good_steps(tolerance, 1);
    EXPECT_DOUBLE_EQ(tolerance.residual(2e-3), 3e-5) << wait;
  }
}

TEST(NewtonTolerance, WaitsNoLongerForTightStepsThatFail) {
  NewtonTolerance tolerance;
  good_steps(tolerance, 9);
  tolerance.step_done(true);
  tolerance.step_done(true);
  EXPECT_EQ(tolerance.wait, 10);
}

TEST(NewtonTolerance, ForgetsFailuresAfterTwiceTheWait) {
  NewtonTolerance tolerance;
  good_steps(tolerance, 10);
  tolerance.step_done(true);
  EXPECT_EQ(tolerance.wait, 20);
  good_steps(tolerance, 40);
  tolerance.step_done(true);
  EXPECT_EQ(tolerance.wait, 10);
}

}  // namespace
}  // namespace scree::test
