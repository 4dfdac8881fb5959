#include "scree/stepping/presets.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../../support/sample_problem.hpp"
#include "scree/stepping/preset_trial.hpp"

namespace scree::test {
namespace {

/// Options that exist only within a test.
class Presets : public testing::Test {
 protected:
  Presets() {
    check(PetscOptionsCreate(&options_));
    check(PetscOptionsPush(options_));
  }
  ~Presets() override {
    (void)PetscOptionsPop();
    (void)PetscOptionsDestroy(&options_);
  }
  static std::string value(const char* name) {
    char text[100] = "";
    PetscBool set;
    check(PetscOptionsGetString(nullptr, nullptr, name, text, sizeof text, &set));
    return set ? text : "(not set)";
  }

 private:
  PetscOptions options_ = nullptr;
};

TEST_F(Presets, GiveWayToTheUser) {
  check(PetscOptionsSetValue(nullptr, "-ksp_rtol", "1e-9"));
  check(PetscOptionsSetValue(nullptr, "-pc_type", "asm"));
  ScopedOptions options;
  check(options.set("", preset_options(SolverPreset::ilu, 4)));
  EXPECT_EQ(value("-ksp_rtol"), "1e-9");
  EXPECT_EQ(value("-pc_type"), "asm");
  EXPECT_EQ(value("-ksp_type"), "bcgs");
  check(options.clear());
}

TEST_F(Presets, OneTakesThePlaceOfAnotherButNotOfTheUsers) {
  check(PetscOptionsSetValue(nullptr, "-ksp_rtol", "1e-9"));
  ScopedOptions options;
  check(options.set("", preset_options(SolverPreset::fieldsplit, 8, 5)));
  EXPECT_EQ(value("-fieldsplit_0_sub_pc_type"), "ilu");
  check(options.set("", preset_options(SolverPreset::multigrid, 8, 5)));
  EXPECT_EQ(value("-fieldsplit_0_pc_type"), "gamg");
  EXPECT_EQ(value("-fieldsplit_0_sub_pc_type"), "(not set)");
  EXPECT_EQ(value("-ksp_rtol"), "1e-9");
  check(options.clear());
}

TEST(PresetTrial, TriesMultigridAndComesBack) {
  PresetTrial trial(PresetTrial::with_gas);
  EXPECT_TRUE(trial.turns(10, 450));                                       // fill comes first
  for (int step = 0; step < 10; ++step) EXPECT_FALSE(trial.turns(2, 90));  // 45 are not too many
  EXPECT_FALSE(trial.turns(9, 900));                                       // not enough to go by
  EXPECT_TRUE(trial.turns(1, 100));
  EXPECT_TRUE(trial.multigrid());
  EXPECT_EQ(trial.iterations(), 100);
  EXPECT_FALSE(trial.turns(10, 500));  // it pays
  EXPECT_TRUE(trial.turns(10, 510));
  EXPECT_FALSE(trial.multigrid());
}

TEST(PresetTrial, FillComesWhereIterationsAreManyAndGoesWhereTheyAreFew) {
  PresetTrial trial(PresetTrial::with_gas);
  EXPECT_FALSE(trial.turns(10, 120));
  EXPECT_EQ(trial.fill(), 0);
  EXPECT_TRUE(trial.turns(10, 121));
  EXPECT_EQ(trial.fill(), 1);
  EXPECT_FALSE(trial.multigrid());
  EXPECT_FALSE(trial.turns(10, 40));
  EXPECT_TRUE(trial.turns(10, 39));
  EXPECT_EQ(trial.fill(), 0);
  for (const PresetTrial::Rule& rule : {PresetTrial::without_gas, PresetTrial::with_gas_without_friction}) {
    PresetTrial other(rule);
    other.turns(10, 121);
    EXPECT_EQ(other.fill(), 0);
  }
}

/// Once it is known what multigrid takes, it comes when it pays.
TEST(PresetTrial, ComesBackToMultigridWhereTheFirstTakesMore) {
  PresetTrial trial(PresetTrial::with_gas);
  EXPECT_TRUE(trial.turns(10, 800));  // fill
  EXPECT_TRUE(trial.turns(10, 800));
  EXPECT_TRUE(trial.turns(10, 450));
  EXPECT_FALSE(trial.turns(10, 890));
  EXPECT_TRUE(trial.turns(10, 910));
  EXPECT_FALSE(trial.turns(10, 450));
}

/// A bed packed to nu_max loses steps with multigrid, which has to save more there.
TEST(PresetTrial, WithoutFrictionMultigridHasToSaveMore) {
  for (const bool friction : {true, false}) {
    PresetTrial trial(friction ? PresetTrial::with_gas : PresetTrial::with_gas_without_friction);
    while (!trial.multigrid()) trial.turns(10, 800);
    trial.turns(10, 300);
    EXPECT_EQ(trial.multigrid(), friction);
  }
}

/// Where it does not, what it took is forgotten after a while, twice as long each time.
TEST(PresetTrial, AsksMultigridAgainAfterAWhile) {
  PresetTrial trial(PresetTrial::without_gas);
  EXPECT_FALSE(trial.turns(10, 150));
  for (const int windows : {2, 4, 8}) {
    while (!trial.multigrid()) trial.turns(10, 160);
    EXPECT_FALSE(trial.turns(10, 120));  // it pays
    EXPECT_TRUE(trial.turns(10, 130));
    for (int k = 1; k < windows; ++k) EXPECT_FALSE(trial.turns(10, 160)) << windows;
    EXPECT_TRUE(trial.turns(10, 160)) << windows;
  }
}

/// A step that failed once says nothing of the preset; steps that fail often do.
TEST(PresetTrial, PassesOverSeldomFailures) {
  PresetTrial trial(PresetTrial::without_gas);
  EXPECT_TRUE(trial.turns(10, 160));
  for (int k = 0; k < 20; ++k) {
    EXPECT_FALSE(trial.turns(8, 430, true));
    for (int step = 0; step < PresetTrial::seldom; ++step) EXPECT_FALSE(trial.turns(5, 50));
  }
  EXPECT_FALSE(trial.turns(8, 430, true));
  for (int step = 1; step < PresetTrial::seldom; ++step) EXPECT_FALSE(trial.turns(5, 50));
  EXPECT_TRUE(trial.turns(10, 430, true));
  EXPECT_FALSE(trial.multigrid());
}

/// What a checkpoint keeps is all that decides.
TEST(PresetTrial, GoesOnFromItsState) {
  PresetTrial trial(PresetTrial::without_gas), again(PresetTrial::without_gas);
  trial.turns(10, 160);
  trial.turns(9, 110);
  EXPECT_FALSE(trial.turns(8, 430, true));
  again.state() = trial.state();
  EXPECT_TRUE(again.multigrid());
  EXPECT_TRUE(trial.turns(1, 25, true));
  EXPECT_TRUE(again.turns(1, 25, true));
}

std::string option(const PetscOptionList& list, const std::string& name) {
  for (const auto& [key, text] : list)
    if (key == name) return text;
  return "(not set)";
}

constexpr SolverPreset all_presets[] = {SolverPreset::direct, SolverPreset::ilu, SolverPreset::multigrid,
                                        SolverPreset::fieldsplit};

TEST_F(Presets, FieldsplitNamesEveryUnknownOnce) {
  const PetscOptionList list = preset_options(SolverPreset::fieldsplit, 5);
  std::string fields;
  for (const char* name : {"pc_fieldsplit_0_fields", "pc_fieldsplit_1_fields"}) fields += option(list, name) + ',';
  for (const char c : std::string("01234"))
    EXPECT_EQ(std::count(fields.begin(), fields.end(), c), 1) << "component " << c << " in " << fields;
}

TEST_F(Presets, GasPressureIsSplitFromAllOthers) {
  for (const SolverPreset preset : {SolverPreset::fieldsplit, SolverPreset::multigrid}) {
    const PetscOptionList list = preset_options(preset, 8, 5);
    EXPECT_EQ(option(list, "pc_fieldsplit_0_fields"), "0,1,2,3,4,6,7") << name_of(preset);
    EXPECT_EQ(option(list, "pc_fieldsplit_1_fields"), "5") << name_of(preset);
  }
}

TEST_F(Presets, NameNoOptionTwice) {
  for (const SolverPreset preset : all_presets)
    for (const int gas_pressure : {-1, 5}) {
      PetscOptionList options = preset_options(preset, 8, gas_pressure);
      std::sort(options.begin(), options.end());
      const auto same_name = [](const auto& a, const auto& b) { return a.first == b.first; };
      EXPECT_EQ(std::adjacent_find(options.begin(), options.end(), same_name), options.end()) << name_of(preset);
    }
}

TEST_F(Presets, FillIsThatOfTheGasFieldsplit) {
  for (const int fill : {0, 1})
    EXPECT_EQ(option(preset_options(SolverPreset::fieldsplit, 8, 5, fill), "fieldsplit_0_sub_pc_factor_levels"),
              std::to_string(fill));
}

}  // namespace
}  // namespace scree::test
