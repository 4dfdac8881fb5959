#include "scree/stepping/step_controller.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace scree::test {
namespace {

StepBounds bounds() {
  StepBounds result;
  result.initial = 0.01;
  result.least = 1e-6;
  result.most = 1;
  return result;
}

/// The step after one of 0.1 that was made as planned.
double next(const StepOutcome& outcome) { return StepController(bounds(), 1).next(0.1, outcome, {0.1, 0.1}); }

TEST(StepController, GrowsAfterEasyStepsAndShrinksAfterHardOnes) {
  EXPECT_DOUBLE_EQ(next({0, 0, 4, false, false}), 0.13);
  EXPECT_DOUBLE_EQ(next({0, 0, 6, false, false}), 0.115) << "half way from easy to hard";
  EXPECT_DOUBLE_EQ(next({0, 0, 8, false, false}), 0.08);
  EXPECT_DOUBLE_EQ(next({0, 0, 15, false, false}), 0.08);
}

TEST(StepController, StaysAfterARejectionBySolver) {
  EXPECT_DOUBLE_EQ(next({0, 0, 3, true, false}), 0.1);
  EXPECT_DOUBLE_EQ(next({0, 0, 20, true, false}), 0.1);
}

TEST(StepController, DoesNotGrowAfterARejectionByError) { EXPECT_DOUBLE_EQ(next({0.1, 0, 3, false, true}), 0.1); }

TEST(StepController, AimsBelowTheErrorThatIsAllowed) {
  EXPECT_DOUBLE_EQ(next({0.64, 0, 3, false, false}), 0.1);
  EXPECT_DOUBLE_EQ(next({1, 0, 3, false, false}), 0.08);
  EXPECT_DOUBLE_EQ(next({100, 0, 3, false, false}), 0.03) << "not below 0.3 of the step";
}

/// An error that grows from step to step shortens the next one more than one that has settled.
TEST(StepController, LooksAtTheErrorBeforeAsWell) {
  EXPECT_DOUBLE_EQ(next({0.64, 0.64, 3, false, false}), 0.1);
  EXPECT_DOUBLE_EQ(next({1, 0.5, 3, false, false}), 0.1 * std::pow(0.64, 0.3) * std::pow(0.64 / 0.5, -0.1));
  EXPECT_LT(next({1, 0.5, 3, false, false}), next({1, 1, 3, false, false}));
}

TEST(StepController, KnowsHowTheErrorOfTheSchemeGoesWithTheStep) {
  const StepController second(bounds(), 2);
  EXPECT_DOUBLE_EQ(second.after_rejection(0.1, 0.64 * 8), 0.05);
  EXPECT_DOUBLE_EQ(second.next(0.1, {0.64 * 8, 0, 3, false, true}, {0.1, 0.1}), 0.05);
}

TEST(StepController, KeepsToItsBounds) {
  const StepController controller(bounds(), 1);
  EXPECT_EQ(controller.next(0.9, {0, 0, 1, false, false}, {0.9, 0.9}), 1);
  EXPECT_EQ(controller.next(1e-6, {0, 0, 20, false, false}, {1e-6, 1e-6}), 1e-6);
}

TEST(StepController, RejectsByErrorWhereAShorterStepIsAllowed) {
  const StepController controller(bounds(), 1);
  EXPECT_TRUE(controller.accepts(0.1, 1));
  EXPECT_FALSE(controller.accepts(0.1, 1.01));
  EXPECT_TRUE(controller.accepts(2e-6, 5)) << "as short as may be";
  EXPECT_DOUBLE_EQ(controller.after_rejection(0.1, 4), 0.04);
  EXPECT_DOUBLE_EQ(controller.after_rejection(0.1, 1e6), 0.03);
  EXPECT_DOUBLE_EQ(controller.after_rejection(2e-6, 1e6), 1e-6);
}

TEST(StepController, DoesNotPassALimitNorLeaveACrumbBeforeIt) {
  const StepController controller(bounds(), 1);
  EXPECT_EQ(controller.plan(0.1, 0.3).dt, 0.1);
  EXPECT_FALSE(controller.plan(0.1, 0.3).cut());
  EXPECT_EQ(controller.plan(0.1, 0.05).dt, 0.05);
  EXPECT_EQ(controller.plan(0.1, 0.1 * (1 + 1e-7)).dt, 0.1 * (1 + 1e-7)) << "no step of rounding errors";
  EXPECT_EQ(controller.plan(0.1, 0.15).dt, 0.075) << "in two equal steps";
  EXPECT_TRUE(controller.plan(0.1, 0.15).cut());
}

/// A step that was cut for a limit says nothing of how long the next may be.
TEST(StepController, GoesBackToWhatWasPlannedAfterACut) {
  const StepController controller(bounds(), 1);
  EXPECT_EQ(controller.next(1e-3, {0, 0, 3, false, false}, {1e-3, 0.5}), 0.5);
  EXPECT_DOUBLE_EQ(controller.next(1e-3, {0, 0, 3, true, false}, {1e-3, 0.5}), 1e-3) << "unless the solver failed";
  EXPECT_DOUBLE_EQ(controller.next(1e-3, {0.5, 0, 3, false, true}, {1e-3, 0.5}), 1e-3) << "or the error was too large";
}

TEST(StepController, MakesStepsOfOneLengthIfToldTo) {
  StepBounds fixed = bounds();
  fixed.adaptive = false;
  const StepController controller(fixed, 1);
  EXPECT_EQ(controller.plan(0.5, 1).dt, 0.01);
  EXPECT_EQ(controller.plan(0.5, 0.015).dt, 0.01);
  EXPECT_TRUE(controller.accepts(0.01, 100));
}

}  // namespace
}  // namespace scree::test
