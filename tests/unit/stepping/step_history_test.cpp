#include "scree/stepping/step_history.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <type_traits>

namespace scree::test {
namespace {

void easy_steps(FirstGuessPolicy& policy, int count) {
  for (int step = 0; step < count; ++step) policy.step_done(2, false, true);
}

TEST(FirstGuess, IsTheStateUntilStepsHaveBeenEasy) {
  FirstGuessPolicy policy;
  easy_steps(policy, 2);
  EXPECT_FALSE(policy.considers_line());
  easy_steps(policy, 1);
  EXPECT_TRUE(policy.considers_line());
  policy.step_done(5, false, false);
  EXPECT_FALSE(policy.considers_line());
}

TEST(FirstGuess, IsTheBetterOneAndThenStaysWhatDidWell) {
  for (const bool line_is_better : {true, false}) {
    FirstGuessPolicy policy;
    easy_steps(policy, 3);
    EXPECT_TRUE(policy.asks_residuals());
    policy.compare(1, line_is_better ? 0.5 : 2);
    EXPECT_EQ(policy.choice, line_is_better ? FirstGuess::line : FirstGuess::state);
    policy.step_done(2, false, true);
    EXPECT_FALSE(policy.asks_residuals());
    EXPECT_EQ(policy.considers_line(), line_is_better);
  }
}

TEST(FirstGuess, IsAskedAgainAfterManyIterationsOrALostAttempt) {
  for (const bool lost : {true, false}) {
    FirstGuessPolicy policy;
    easy_steps(policy, 3);
    policy.compare(1, 2);
    policy.step_done(lost ? 2 : 3, lost, !lost);
    EXPECT_EQ(policy.choice, FirstGuess::better);
  }
}

TEST(FirstGuess, IsNoLineWithoutAFiniteResidual) {
  FirstGuessPolicy policy;
  policy.compare(1, std::nan(""));
  EXPECT_EQ(policy.choice, FirstGuess::state);
}

TEST(StepHistory, GoesThroughACheckpointByName) {
  StepHistory history;
  history.dt_next = 1;
  history.dt_past = {2, 3};
  history.error = 7;
  history.guess = {FirstGuess::line, 4};
  history.newton.calm = 5;
  history.newton.wait = 6;
  std::map<std::string, double> saved;
  history.each_member([&](const char* name, const auto& member) { saved[name] = static_cast<double>(member); });
  const std::map<std::string, double> expected{{"dt_next", 1},    {"dt_past_0", 2}, {"dt_past_1", 3}, {"easy_steps", 4},
                                               {"calm_steps", 5}, {"calm_wait", 6}, {"guess", 2},     {"error", 7}};
  EXPECT_EQ(saved, expected);
  StepHistory again;
  again.each_member([&](const char* name, auto& member) {
    member = static_cast<std::remove_reference_t<decltype(member)>>(saved.at(name));
  });
  again.each_member([&](const char* name, const auto& member) { EXPECT_EQ(static_cast<double>(member), saved[name]); });
  EXPECT_EQ(again.guess.choice, FirstGuess::line);
}

TEST(StepHistory, BeginsSmallAndAsksAnewAfterAnEvent) {
  StepHistory history;
  history.dt_next = 0.1;
  history.dt_past = {0.1, 0.1};
  history.error = 0.5;
  history.guess = {FirstGuess::line, 9};
  history.newton.calm = 50;
  history.forget_past(1e-4);
  EXPECT_EQ(history.dt_next, 1e-4);
  EXPECT_EQ(history.dt_past, (PastSteps{0, 0}));
  EXPECT_EQ(history.error, 0);
  EXPECT_EQ(history.guess.choice, FirstGuess::better);
  EXPECT_EQ(history.guess.easy_steps, 0);
  EXPECT_EQ(history.newton.calm, 50) << "how well Newton's method does is not forgotten";
  history.dt_next = 1e-5;
  history.forget_past(1e-4);
  EXPECT_EQ(history.dt_next, 1e-5) << "not longer than planned";
}

}  // namespace
}  // namespace scree::test
