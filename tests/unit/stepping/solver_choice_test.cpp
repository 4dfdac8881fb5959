#include "scree/stepping/solver_choice.hpp"

#include <gtest/gtest.h>

namespace scree {
namespace {

/// A cheap one that is set up at each Newton iteration, and a dear one of few iterations. Hoped: 4 + 5 = 9, 10 + 20
/// = 30.
SolverChoice cheap_and_strong() {
  return SolverChoice({{SolverPreset::ilu, 0, 4, 1, 5, 1}, {SolverPreset::condensed, 0, 20, 4, 5, 0.5, true}});
}

TEST(SolverChoice, GoesToTheOtherWhereItIsHopedToPay) {
  SolverChoice choice = cheap_and_strong();
  EXPECT_FALSE(choice.turns(10, 330, 10)) << "4 + 33 against 30: less than a fifth to gain";
  EXPECT_FALSE(choice.turns(9, 330, 9)) << "not enough to go by";
  EXPECT_TRUE(choice.turns(1, 50, 1)) << "4 + 38";
  EXPECT_EQ(choice.iterations(), 38);
  EXPECT_EQ(choice.current().preset, SolverPreset::condensed);
  EXPECT_FALSE(choice.turns(10, 50, 5));
}

TEST(SolverChoice, ComesBackFromADisappointmentAndWaitsTwiceAsLongEachTime) {
  SolverChoice choice = cheap_and_strong();
  for (const int windows : {16, 32}) {
    ASSERT_EQ(choice.current().preset, SolverPreset::ilu);
    while (choice.current().preset == SolverPreset::ilu) choice.turns(10, 400, 10);  // 44
    EXPECT_TRUE(choice.turns(10, 150, 5)) << "10 + 60 against the 44 of before";
    int waited = 0;
    SolverChoice ahead = choice;
    while (!ahead.turns(10, 400, 10)) ++waited;
    EXPECT_EQ(waited, windows - 1);
  }
}

/// What is left is asked again too: steps grow, and what it took then says little.
TEST(SolverChoice, AsksTheFirstAgain) {
  SolverChoice choice = cheap_and_strong();
  EXPECT_TRUE(choice.turns(10, 400, 10));
  int windows = 0;
  while (!choice.turns(10, 50, 5)) ++windows;
  EXPECT_EQ(choice.current().preset, SolverPreset::ilu);
  EXPECT_EQ(windows, 2 * SolverChoice::patience - 1);
}

TEST(SolverChoice, GoesToTheStrongestWhereALinearSystemIsNotSolved) {
  SolverChoice choice = cheap_and_strong();
  EXPECT_TRUE(choice.strengthens());
  EXPECT_EQ(choice.current().preset, SolverPreset::condensed);
  EXPECT_FALSE(choice.strengthens()) << "there is nothing stronger";
  for (int k = 1; k < 2 * SolverChoice::patience; ++k) EXPECT_FALSE(choice.turns(10, 1000, 5)) << "however dear";
  EXPECT_TRUE(choice.turns(10, 1000, 5)) << "for a while";
}

/// A step that failed once says nothing of the preset; steps that fail often do.
TEST(SolverChoice, PassesOverSeldomFailures) {
  SolverChoice choice = cheap_and_strong();
  for (int k = 0; k < 20; ++k) {
    EXPECT_FALSE(choice.turns(10, 430, 10, true));
    for (int step = 0; step < SolverChoice::seldom; ++step) EXPECT_FALSE(choice.turns(5, 50, 5));
  }
  EXPECT_FALSE(choice.turns(10, 430, 10, true));
  EXPECT_TRUE(choice.turns(10, 430, 10, true));
}

/// What a checkpoint keeps is all that decides.
TEST(SolverChoice, GoesOnFromItsState) {
  SolverChoice choice = cheap_and_strong(), again = cheap_and_strong();
  choice.turns(10, 400, 10);
  choice.turns(9, 170, 4);
  again.state() = choice.state();
  EXPECT_EQ(again.current().preset, SolverPreset::condensed);
  EXPECT_TRUE(choice.turns(1, 25, 1));
  EXPECT_TRUE(again.turns(1, 25, 1));
}

TEST(SolverCandidates, HaveOneThatIsStrongestAndFitTheState) {
  for (const bool gas : {false, true})
    for (const int dim : {1, 2, 3}) {
      int strongest = 0;
      const auto candidates = solver_candidates(gas, dim, 1e4, 2);
      EXPECT_LE(candidates.size(), SolverChoice::most);
      for (const SolverCandidate& c : candidates) {
        strongest += c.strongest;
        EXPECT_GT(c.setup * c.iteration * c.hoped * c.renewed, 0);
      }
      EXPECT_EQ(strongest, 1);
      EXPECT_EQ(candidates[0].preset, gas ? SolverPreset::fieldsplit : SolverPreset::ilu);
      EXPECT_EQ(candidates[0].iteration, 1);
    }
}

}  // namespace
}  // namespace scree
