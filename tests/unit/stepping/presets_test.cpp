#include "scree/stepping/presets.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../../support/sample_problem.hpp"
#include "scree/balances/layout.hpp"

namespace scree::test {
namespace {

/// The unknowns of a node in the plane with all that the paper has, and without gas.
const std::vector<Field> with_gas = Layout<2, true, true, GasModel::incompressible>::fields({}),
                         without_gas = Layout<2, true, true, GasModel::none>::fields({}),
                         in_space = Layout<3, true, true, GasModel::none>::fields({});

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
  check(options.set("", preset_options(SolverPreset::ilu, without_gas)));
  EXPECT_EQ(value("-ksp_rtol"), "1e-9");
  EXPECT_EQ(value("-pc_type"), "asm");
  EXPECT_EQ(value("-ksp_type"), "gmres");
  check(options.clear());
}

TEST_F(Presets, OneTakesThePlaceOfAnotherButNotOfTheUsers) {
  check(PetscOptionsSetValue(nullptr, "-ksp_rtol", "1e-9"));
  ScopedOptions options;
  check(options.set("", preset_options(SolverPreset::fieldsplit, with_gas)));
  EXPECT_EQ(value("-fieldsplit_0_sub_pc_type"), "ilu");
  check(options.set("", preset_options(SolverPreset::multigrid, with_gas)));
  EXPECT_EQ(value("-fieldsplit_0_pc_type"), "gamg");
  EXPECT_EQ(value("-fieldsplit_0_sub_pc_type"), "(not set)");
  EXPECT_EQ(value("-ksp_rtol"), "1e-9");
  check(options.clear());
}

std::string option(const PetscOptionList& list, const std::string& name) {
  for (const auto& [key, text] : list)
    if (key == name) return text;
  return "(not set)";
}

constexpr SolverPreset all_presets[] = {SolverPreset::direct, SolverPreset::ilu, SolverPreset::multigrid,
                                        SolverPreset::fieldsplit, SolverPreset::condensed};

TEST_F(Presets, FieldsplitNamesEveryUnknownOnce) {
  const PetscOptionList list = preset_options(SolverPreset::fieldsplit, without_gas);
  std::string fields;
  for (const char* name : {"pc_fieldsplit_0_fields", "pc_fieldsplit_1_fields"}) fields += option(list, name) + ',';
  for (const char c : std::string("01234"))
    EXPECT_EQ(std::count(fields.begin(), fields.end(), c), 1) << "component " << c << " in " << fields;
}

TEST_F(Presets, GasPressureIsSplitFromAllOthers) {
  for (const SolverPreset preset : {SolverPreset::fieldsplit, SolverPreset::multigrid}) {
    const PetscOptionList list = preset_options(preset, with_gas);
    EXPECT_EQ(option(list, "pc_fieldsplit_0_fields"), "0,1,2,3,4,6,7") << name_of(preset);
    EXPECT_EQ(option(list, "pc_fieldsplit_1_fields"), "5") << name_of(preset);
  }
}

TEST_F(Presets, NameNoOptionTwice) {
  for (const SolverPreset preset : all_presets)
    for (const auto& node : {with_gas, without_gas, in_space}) {
      PetscOptionList options = preset_options(preset, node);
      std::sort(options.begin(), options.end());
      const auto same_name = [](const auto& a, const auto& b) { return a.first == b.first; };
      EXPECT_EQ(std::adjacent_find(options.begin(), options.end(), same_name), options.end()) << name_of(preset);
    }
}

TEST_F(Presets, FillIsThatOfTheGasFieldsplit) {
  for (const int fill : {0, 1})
    EXPECT_EQ(
        option(preset_options(SolverPreset::fieldsplit, with_gas, {1, fill}), "fieldsplit_0_sub_pc_factor_levels"),
        std::to_string(fill));
}

/// nu, v (and p_g) stay; what acts in its node goes.
TEST_F(Presets, CondensedEliminatesWhatActsInItsNode) {
  EXPECT_EQ(option(preset_options(SolverPreset::condensed, with_gas), "pc_condensed_eliminated"), "3,4,6,7");
  EXPECT_EQ(option(preset_options(SolverPreset::condensed, without_gas), "pc_condensed_eliminated"), "3,4");
  PresetScene fixed_bed;
  fixed_bed.solids_moving = false;
  EXPECT_EQ(option(preset_options(SolverPreset::condensed, with_gas, fixed_bed), "pc_condensed_eliminated"), "6,7");
}

// A cold scene with critical_state friction: a run comes to the preset by itself, and must go on.
TEST_F(Presets, CondensedWithNothingToEliminateIsItsCore) {
  const PetscOptionList in_plane =
      preset_options(SolverPreset::condensed, Layout<2, false, false, GasModel::none>::fields({}));
  EXPECT_EQ(option(in_plane, "pc_type"), "lu");
  EXPECT_EQ(option(in_plane, "pc_factor_mat_solver_type"), "mumps");
  EXPECT_EQ(
      option(preset_options(SolverPreset::condensed, Layout<3, false, false, GasModel::none>::fields({})), "pc_type"),
      "staggered");
}

TEST_F(Presets, IncompleteFactorsTakeColumnsAlongGravity) {
  const char* name = "sub_pc_factor_mat_ordering_type";
  EXPECT_EQ(option(preset_options(SolverPreset::ilu, without_gas), name), "columns_y") << "without gravity";
  EXPECT_EQ(option(preset_options(SolverPreset::ilu, without_gas, {1, 0, {-9, 1, 0}}), name), "columns_x");
  EXPECT_EQ(option(preset_options(SolverPreset::ilu, in_space, {1, 0, {-9, 1, 0}}), name), "columns_x");
  EXPECT_EQ(option(preset_options(SolverPreset::ilu, in_space), name), "columns_z");
  PresetScene many{1, 0, {-9, 1, 0}};
  many.cells = 1e5;
  EXPECT_EQ(option(preset_options(SolverPreset::condensed, without_gas, many),
                   "condensed_core_staggered_mg_levels_sub_pc_factor_mat_ordering_type"),
            "columns_x");
}

TEST_F(Presets, CondensedHasMultigridWhereAFactorIsDear) {
  const auto core = [](double cells, int ranks) {
    return option(preset_options(SolverPreset::condensed, without_gas, {ranks, 0, {}, cells}),
                  "condensed_core_pc_type");
  };
  EXPECT_EQ(core(2500, 1), "lu");
  EXPECT_EQ(core(1e5, 1), "staggered");
  EXPECT_EQ(core(1e4, 4), "staggered");
}

TEST_F(Presets, CondensedHasAFactorInThePlaneAndMultigridInSpace) {
  EXPECT_EQ(option(preset_options(SolverPreset::condensed, without_gas), "condensed_core_pc_type"), "lu");
  EXPECT_EQ(option(preset_options(SolverPreset::condensed, in_space), "condensed_core_pc_type"), "staggered");
  const PetscOptionList on_four = preset_options(SolverPreset::condensed, without_gas, {4});
  EXPECT_EQ(option(on_four, "condensed_core_pc_type"), "telescope");
  EXPECT_EQ(option(on_four, "condensed_core_pc_telescope_reduction_factor"), "4");
  EXPECT_EQ(option(on_four, "condensed_core_telescope_pc_type"), "lu");
}

}  // namespace
}  // namespace scree::test
