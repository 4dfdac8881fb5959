#include "scree/config/read_case.hpp"

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "scene.hpp"
#include "scree/config/case_options.hpp"
#include "scree/config/quantity.hpp"

namespace scree {
namespace {

using ReadCase = Options;

TEST_F(ReadCase, SmallBin) {
  small_bin();
  const Case scene = read_case();
  EXPECT_EQ(scene.box.dim, 2);
  EXPECT_EQ(scene.box.cells(0), 8);
  EXPECT_EQ(scene.box.cells(1), 5);
  EXPECT_DOUBLE_EQ(scene.box.upper(0), 0.08);
  EXPECT_DOUBLE_EQ(scene.box.faces[1][1], 0.02);
  EXPECT_TRUE(scene.box.faces[2].empty());
  EXPECT_EQ(scene.model.gravity[1], -9.81);
  ASSERT_EQ(scene.segments.size(), 4u);
  EXPECT_EQ(scene.segments[0].condition.name, "axis");
  EXPECT_EQ(scene.segments[1].condition.name, "floor");
  EXPECT_EQ(scene.segments[1].condition.kind, BoundaryKind::open);
  EXPECT_EQ(scene.segments[1].axis, 1);
  EXPECT_FALSE(scene.segments[1].upper);
  ASSERT_EQ(scene.initial.size(), 2u);
  EXPECT_EQ(scene.initial[0].name, "default");
  EXPECT_EQ(scene.initial[0].find(SolidsContinuity::unknown)->value[0], 0);
  EXPECT_EQ(scene.initial[0].find(GranularEnergy::unknown)->value[0], 1e-4);
  EXPECT_EQ(scene.initial[0].upper[1], 0.1);
  EXPECT_EQ(scene.initial[1].find(SolidsContinuity::unknown)->value[0], 0.6);
  EXPECT_EQ(scene.initial[1].find(SolidsMomentum::unknown), nullptr);
  EXPECT_TRUE(scene.remarks.empty());
}

TEST_F(ReadCase, DefaultsAreThoseOfThePaper) {
  small_bin();
  const Case scene = read_case();
  EXPECT_DOUBLE_EQ(scene.friction.phi, quantity("28.5 deg", "rad"));
  EXPECT_DOUBLE_EQ(scene.friction.n_dilation, std::sqrt(3.0) / (2 * std::sin(scene.friction.phi)));
  EXPECT_DOUBLE_EQ(scene.friction.F, 0.05);
  EXPECT_DOUBLE_EQ(scene.wall.delta, quantity("12.3 deg", "rad"));
}

TEST_F(ReadCase, CollisionsLeaveTemperatureWhereNothingElseCarries) {
  small_bin();
  EXPECT_EQ(read_case().kinetic.T_rest, 0);
  yaml("friction: {model: none}");
  EXPECT_EQ(read_case().kinetic.T_rest, 1e-6);
  yaml("friction: {model: none}\ngranular_temperature_at_rest: 1 cm2/s2");
  EXPECT_EQ(read_case().kinetic.T_rest, 1e-4);
}

TEST_F(ReadCase, ShareOfFluctuationsInFriction) {
  small_bin();
  EXPECT_EQ(read_case().friction.fluctuation, 1);
  yaml("friction: {strain_rate_fluctuation: no}");
  EXPECT_EQ(read_case().friction.fluctuation, 0);
  yaml("friction: {fluctuation: 0.1, strain_rate_floor: 1e-6}");
  EXPECT_EQ(read_case().friction.fluctuation, 0.1);
  EXPECT_EQ(read_case().friction.strain_rate_floor, 1e-6);
}

TEST_F(ReadCase, ParticlesReachAllClosures) {
  small_bin();
  yaml("particle: {density: 2.5 g/cm3, diameter: 100 um}\nsolids_fraction_max: 64 %\nfriction: {angle: 30 deg}");
  const Case scene = read_case();
  EXPECT_DOUBLE_EQ(scene.kinetic.rho_s, 2500);
  EXPECT_DOUBLE_EQ(scene.friction.d, 1e-4);
  EXPECT_DOUBLE_EQ(scene.friction.nu_max, 0.64);
  EXPECT_DOUBLE_EQ(scene.segments[0].condition.wall.nu_max, 0.64);
  EXPECT_NEAR(scene.friction.n_dilation, std::sqrt(3.0), 1e-12);
}

TEST_F(ReadCase, KeysDoNotDependOnCase) {
  small_bin();
  yaml("Friction: {Model: critical_state}");
  EXPECT_EQ(read_case().friction.model, FrictionModel::critical_state);
}

TEST_F(ReadCase, WhatComesLaterWins) {
  small_bin();
  yaml("friction: {tau: 1 ms, model: relaxed}\nend_time: 2");
  yaml("friction_tau: 3 ms");
  EXPECT_EQ(read_case().friction.tau, 3e-3);
  set("friction_tau", "1e-2");
  set("Gravity", "0,-1");
  const Case scene = read_case();
  EXPECT_EQ(scene.friction.tau, 1e-2);
  EXPECT_EQ(scene.time.end_time, 2);
  EXPECT_EQ(scene.model.gravity[1], -1);
}

TEST_F(ReadCase, DefinitionsAndTheirOverride) {
  small_bin();
  yaml("define: {orifice_width: 4 cm}\nplate: {floor: {axis: y, position: 2 cm, openings: '0, ${orifice_width}/2'}}");
  Case scene = read_case();
  ASSERT_EQ(scene.plates.size(), 1u);
  ASSERT_EQ(scene.plates[0].openings.size(), 1u);
  EXPECT_EQ(scene.plates[0].openings[0].upper[0], scene.box.faces[0][2]);
  EXPECT_EQ(scene.plates[0].position, scene.box.faces[1][1]);
  set("orifice_width", "6 cm");
  scene = read_case();
  EXPECT_EQ(scene.plates[0].openings[0].upper[0], scene.box.faces[0][3]);
}

TEST_F(ReadCase, DefinitionsStandForWordsToo) {
  small_bin();
  yaml("define: {law: relaxed, run: a}\nfriction: {model: '${law}'}\noutput: {dir: 'out/${run}'}");
  set("law", "critical_state");
  const Case scene = read_case();
  EXPECT_EQ(scene.friction.model, FrictionModel::critical_state);
  EXPECT_EQ(scene.output.directory, "out/a");
}

TEST_F(ReadCase, GradedBlocks) {
  small_bin();
  yaml("grid: {x_edges: [0, 2 cm, 8 cm], x_cells: [4, 3], x_ratio: [1, 4], refine: 1}");
  const std::vector<double> faces = read_case().box.faces[0];
  ASSERT_EQ(faces.size(), 8u);
  EXPECT_DOUBLE_EQ(faces[1], 0.005);
  EXPECT_DOUBLE_EQ(faces[4], 0.02);
  EXPECT_NEAR((faces[7] - faces[6]) / (faces[5] - faces[4]), 4, 1e-12);
  EXPECT_NEAR((faces[6] - faces[5]) / (faces[5] - faces[4]), 2, 1e-12);
  EXPECT_EQ(faces[7], 0.08);
  set("grid_refine", "2");
  EXPECT_EQ(read_case().box.cells(0), 14);
}

TEST_F(ReadCase, OneAndThreeDimensions) {
  yaml("dimension: 1\nextent: 1\ngrid_cells: 4\nperiodic: x");
  EXPECT_TRUE(read_case().box.periodic[0]);
  clear();
  yaml(R"(
dimension: 3
extent: [1, 2, 3]
grid_cells: [2, 2, 3]
periodic: [x, y]
boundary:
  floor_left: {side: z_lower, kind: open, patch: [0, 0.5, 0, 2]}
  floor_right: {side: z_lower, kind: wall_no_slip, velocity: [0, 1, 0], patch: [0.5, 1, 0, 2]}
  top: {side: z_upper, kind: wall_free_slip}
)");
  const Case scene = read_case();
  EXPECT_EQ(scene.segments[1].condition.name, "floor_right");
  EXPECT_EQ(scene.segments[1].patch.lower[0], 0.5);
  EXPECT_EQ(scene.segments[1].patch.upper[1], 2);
  EXPECT_EQ(scene.segments[1].condition.velocity[1], 1);
}

TEST_F(ReadCase, OrderDecidesOverlaps) {
  small_bin();
  yaml(
      "boundary: {a_slit: {side: y_upper, kind: inlet, solids_fraction: 0.3, patch: [0, 2 cm], order: 1, until: 0.2}}");
  const Case scene = read_case();
  EXPECT_EQ(scene.segments.back().condition.name, "a_slit");
  EXPECT_EQ(scene.segments.back().condition.until, 0.2);
}

TEST_F(ReadCase, NamesMayHoldUnderscoresAndAttributes) {
  small_bin();
  yaml(
      "initial: {all_of_it: {velocity_gradient: [0, 1, 2, 3], velocity: [1, 0]}}\n"
      "flux: {orifice_from_wall: {axis: y, position: 2 cm, direction: positive}}\n"
      "probe: {in_bed: {point: [1 cm, 1 cm], fields: [solids_fraction, velocity]}}\n"
      "line: {from_to: {from: [0, 0], to: [0, 10 cm]}}");
  const Case scene = read_case();
  EXPECT_EQ(scene.initial[1].name, "all_of_it");
  EXPECT_EQ(scene.initial[1].velocity_gradient[1], 1);
  EXPECT_EQ(scene.initial[1].velocity_gradient[3], 2);
  EXPECT_EQ(scene.flux_planes.at(0).name, "orifice_from_wall");
  EXPECT_TRUE(scene.flux_planes.at(0).upward);
  EXPECT_EQ(scene.probes.at(0).fields.at(1), "velocity");
  EXPECT_EQ(scene.lines.at(0).name, "from_to");
  EXPECT_EQ(scene.lines.at(0).to[1], 0.1);
}

TEST_F(ReadCase, RemarksOnWhatTheSceneDoesNotUse) {
  small_bin();
  yaml("friction: {model: critical_state, tau: 1}\ndefine: {depth: 1}\nboundary: {axis: {specularity: 0.1}}");
  const Case scene = read_case();
  EXPECT_EQ(scene.remarks.size(), 3u);
  EXPECT_TRUE(has_remark(scene, "friction_tau is not used: friction_model is not relaxed"));
  EXPECT_TRUE(has_remark(scene, "boundary_axis_specularity is not used"));
  EXPECT_TRUE(has_remark(scene, "define_depth is not used"));
}

std::string petsc_value(const Case& scene, const std::string& key) {
  for (const PetscOption& option : scene.petsc_options)
    if (option.key == key) return option.value + (option.on_command_line ? " here" : "");
  return "none";
}

TEST_F(ReadCase, PetscOptionsOfItsSectionTheTopLevelAndTheCommandLine) {
  small_bin();
  yaml("snes: {rtol: 1e-9}\nts_monitor:\npetsc: {mg: {levels_ksp_type: richardson}, any_name: [1, 2], ksp_rtol: 1}");
  set("ksp_rtol", "1e-3");
  const Case scene = read_case();
  EXPECT_EQ(scene.petsc_options.size(), 5u);
  EXPECT_EQ(petsc_value(scene, "snes_rtol"), "1e-9");
  EXPECT_EQ(petsc_value(scene, "ts_monitor"), "");
  EXPECT_EQ(petsc_value(scene, "mg_levels_ksp_type"), "richardson");
  EXPECT_EQ(petsc_value(scene, "any_name"), "1, 2");
  EXPECT_EQ(petsc_value(scene, "ksp_rtol"), "1e-3 here");
}

TEST_F(ReadCase, CommandLineOverridesAnyKeyOfThePetscSection) {
  small_bin();
  yaml("petsc: {any_name: 1}");
  set("any_name", "2");
  EXPECT_EQ(petsc_value(read_case(), "any_name"), "2 here");
  set("other_name", "3");
  EXPECT_EQ(error_of_case().key, "other_name");
}

TEST_F(ReadCase, PresetThatWasNotGivenIsNotGivenByTheEffectiveCase) {
  small_bin();
  const Case first = read_case();
  EXPECT_FALSE(first.solver.preset_given);
  clear();
  yaml(first.effective_yaml);
  const Case again = read_case();
  EXPECT_FALSE(again.solver.preset_given);
  EXPECT_EQ(again.solver.preset, SolverPreset::ilu);
  yaml("solver: multigrid");
  const Case given = read_case();
  EXPECT_TRUE(given.solver.preset_given);
  clear();
  yaml(given.effective_yaml);
  EXPECT_TRUE(read_case().solver.preset_given);
  EXPECT_EQ(read_case().solver.preset, SolverPreset::multigrid);
}

TEST_F(ReadCase, TableStandsBesideTheFileThatNamesIt) {
  namespace fs = std::filesystem;
  const fs::path directory = fs::path(testing::TempDir()) / ("scree_table_beside_" + std::to_string(getpid()));
  fs::create_directories(directory / "tables");
  std::ofstream(directory / "tables" / "nu.txt") << "0 0.25\n";
  small_bin();
  input.insert(yaml_entries("initial_bed_table: tables/nu.txt", (directory / "case.yaml").string()));
  const Case first = read_case();
  const std::string absolute = (fs::absolute(directory) / "tables" / "nu.txt").lexically_normal().string();
  EXPECT_EQ(first.initial.at(1).table, absolute);
  EXPECT_EQ(first.initial.at(1).table_values.factor, std::vector<double>{0.25});
  clear();
  input.insert(yaml_entries(first.effective_yaml, "/somewhere/else/case.yaml"));
  EXPECT_EQ(read_case().initial.at(1).table, absolute);
  fs::remove_all(directory);
  set("initial_bed_table", "nowhere.txt");
  EXPECT_EQ(error_of_case().value, (fs::current_path() / "nowhere.txt").string());
}

TEST_F(ReadCase, VectorsWithoutAValueHaveAllComponents) {
  static const Unknown drift = [] {
    Unknown unknown = SolidsMomentum::unknown;
    unknown.dataset = "drift";
    unknown.initial.otherwise = 2;
    return unknown;
  }();
  small_bin();
  Catalogue catalogue;
  catalogue.further_unknowns = {&drift};
  const Case scene = scree::read_case(input, catalogue);
  EXPECT_EQ(scene.initial.at(0).find(drift)->value, (std::array<double, max_dim>{2, 2, 2}));
}

TEST_F(ReadCase, PetscSectionIsForPetscAlone) {
  small_bin();
  yaml("petsc: {friction_tau: 1}");
  const InputError error = error_of_case();
  EXPECT_EQ(error.key, "petsc: friction_tau");
  EXPECT_EQ(error.place, "test.yaml:1");
  EXPECT_THROW(yaml("petsc: 1"), InputError);
  EXPECT_NO_THROW(yaml("petsc:"));
}

TEST_F(ReadCase, NoOptionOfOursLooksLikeOneOfPetsc) {
  OptionSet options;
  GridInput grid;
  Case scene;
  declare_all(options, grid, scene);
  for (const OptionEntry& entry : options.entries()) EXPECT_FALSE(is_petsc_option(entry.key)) << entry.key;
}

TEST_F(ReadCase, NestingTellsNamesThatFlatKeysLeaveOpen) {
  small_bin();
  yaml("gas: darcy\nboundary: {axis_gas: {side: x_lower, kind: symmetry, velocity: [0, 0]}}");
  const Case scene = read_case();
  EXPECT_EQ(scene.segments.at(1).condition.name, "axis_gas");
  set("boundary_axis_gas_velocity", "1, 2");  // the velocity of axis_gas, not the gas_velocity of axis
  set("boundary_axis_gas_kind", "wall_free_slip");
  EXPECT_EQ(read_case().segments.at(1).condition.velocity[1], 2);
  EXPECT_EQ(read_case().segments.at(0).condition.gas_velocity, 0);
}

TEST_F(ReadCase, FormerNamesAreUnderstoodWithARemark) {
  small_bin();
  yaml("void_fraction_floor: 1e-5");
  Case scene = read_case();
  EXPECT_EQ(scene.model.solids_fraction_floor, 1e-5);
  EXPECT_TRUE(has_remark(scene, "void_fraction_floor (test.yaml:1) is now called solids_fraction_floor"));
  set("solids_fraction_floor", "1e-6");
  scene = read_case();
  EXPECT_EQ(scene.model.solids_fraction_floor, 1e-6);
  EXPECT_NE(scene.effective_yaml.find("\nsolids_fraction_floor: "), std::string::npos);
}

TEST_F(ReadCase, ErrorsOfKeysInFilesNameTheirLine) {
  small_bin();
  yaml("end_time: 1\nfriction:\n  tau: 1 cm\n");
  EXPECT_EQ(error_of_case().place, "test.yaml:3");
  EXPECT_EQ(std::string(error_of_case().what()).find("test.yaml:3: friction_tau = '1 cm': expected a value in s"), 0u);
  set("friction_tau", "2 cm");
  EXPECT_EQ(std::string(error_of_case().what()).find("friction_tau = '2 cm': expected a value in s"), 0u);
  set("friction_tau", "1 ms");
  yaml("x: 1\nboundary: {wall: {kind: inlet, velocity: [0, 0],\n  until: -1, solids_fraction: 0}}\ndefine: {x: 2}");
  set("boundary_wall_from", "1");
  EXPECT_EQ(error_of_case().place, "test.yaml:3");
}

/// Everything that effective_yaml has to carry.
const char* const rich_case = R"(
define: {width: 4 cm}
friction: {model: relaxed, tau: 3 ms, angle: 31 deg}
particle: {density: 2.9 g/cm3}
grid: {y_edges: [0, 4 cm, 10 cm], y_cells: [2, 3], y_ratio: [1, 1.3]}
plate: {floor: {axis: y, position: 4 cm, openings: ['0', '${width}/2', 6 cm, 7 cm], span: [0, 7 cm]}}
boundary: {slit: {side: x_upper, kind: inlet, solids_fraction: 0.1, velocity: [-1 cm/s, 0], from: 0.1, until: 0.3}}
initial: {bed: {profile: equilibrium, surface: 8 cm, granular_temperature: 1 cm2/s2, velocity: [0, 0.1]}}
probe: {p: {point: [1 cm, 1 cm], fields: [solids_fraction]}}
flux: {out: {axis: y, position: 4 cm}}
output: {dir: "it's out", mirror: 2}
time: {scheme: bdf, step_adaptive: no}
snes: {rtol: 1e-9}
ksp_monitor:
)";

TEST_F(ReadCase, EffectiveYamlReadsBackAsTheSameCase) {
  small_bin();
  yaml(rich_case);
  const Case first = read_case();
  clear();
  yaml(first.effective_yaml);
  const Case second = read_case();
  EXPECT_EQ(second.effective_yaml, first.effective_yaml);
  EXPECT_EQ(second.friction.phi, first.friction.phi);
  EXPECT_EQ(second.friction.n_dilation, first.friction.n_dilation);
  EXPECT_EQ(second.box.faces, first.box.faces);
  ASSERT_EQ(second.plates.at(0).openings.size(), 2u);
  EXPECT_EQ(second.plates[0].openings[0].upper, first.plates[0].openings[0].upper);
  EXPECT_EQ(second.output.directory, "it's out");
  EXPECT_FALSE(second.time.adaptive);
  EXPECT_EQ(second.segments.size(), first.segments.size());
  EXPECT_EQ(second.initial[1].surface, first.initial[1].surface);
  EXPECT_EQ(petsc_value(second, "snes_rtol"), "1e-9");
  EXPECT_EQ(petsc_value(second, "ksp_monitor"), "");
}

TEST(OptionReport, HelpAndTableNameEveryIdea) {
  for (const std::string& text : {help_text(), option_table_markdown()}) {
    for (const char* key : {"dimension", "grid_z_ratio", "gas_density", "friction_tau", "boundary_<name>_side",
                            "boundary_<name>_gas_history_at", "plate_<name>_openings", "plate_<name>_gas_wall",
                            "initial_<name>_profile", "probe_<name>_point", "time_scheme", "scale_velocity"})
      EXPECT_NE(text.find(key), std::string::npos) << key;
  }
  EXPECT_NE(
      option_table_markdown().find("| tau | `friction_tau` | s | 0.001 | > 0 | relaxation time of chi, eq. (23) |"),
      std::string::npos);
}

}  // namespace
}  // namespace scree
