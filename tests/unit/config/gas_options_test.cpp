#include <array>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "scene.hpp"

namespace scree {
namespace {

/// A face without extent.
FaceExtent at_point(const std::array<double, max_dim>& point) { return {point, point}; }

/// The small bin as a bed whose floor brings gas.
class GasOptions : public Options {
 protected:
  void small_bed(const std::string& model) {
    small_bin();
    yaml("gas: " + model + "\nboundary: {floor: {kind: gas_inlet, gas_velocity: 22 cm/s}}");
  }
};

const Segment& segment(const Case& scene, const std::string& name) {
  for (const Segment& candidate : scene.segments)
    if (candidate.condition.name == name) return candidate;
  throw std::runtime_error("there is no segment " + name);
}

const Condition& condition(const Case& scene, const std::string& name) { return segment(scene, name).condition; }

TEST_F(GasOptions, NoGasUnlessAskedFor) {
  small_bin();
  const Case scene = read_case();
  EXPECT_EQ(scene.gas.model, GasModel::none);
  EXPECT_EQ(scene.effective_yaml.find("gas_"), std::string::npos);
  EXPECT_NE(scene.effective_yaml.find("gas: none\n"), std::string::npos);
  EXPECT_NE(scene.initial[0].find(GasMomentum::unknown), nullptr);
  EXPECT_EQ(scene.initial[1].find(GasMomentum::unknown), nullptr);
}

TEST_F(GasOptions, DefaultsAreThoseOfThePaper) {
  small_bin();
  yaml("gas: incompressible");
  const Case scene = read_case();
  EXPECT_EQ(scene.gas.model, GasModel::incompressible);
  EXPECT_DOUBLE_EQ(scene.gas.rho_g, 1.3);
  EXPECT_DOUBLE_EQ(scene.gas.mu_g, 1.8e-5);
  EXPECT_FALSE(scene.model.gas_viscous_stress);
  EXPECT_TRUE(scene.remarks.empty());
}

TEST_F(GasOptions, PropertiesWithUnits) {
  small_bin();
  yaml(
      "gas: darcy\ngas_density: 1.2e-3 g/cm3\ngas_viscosity: 1.8e-4 g/(cm s)\n"
      "gas_darcy_solids_fraction: 0.5 %");
  const Case scene = read_case();
  EXPECT_EQ(scene.gas.model, GasModel::darcy);
  EXPECT_DOUBLE_EQ(scene.gas.rho_g, 1.2);
  EXPECT_DOUBLE_EQ(scene.gas.mu_g, 1.8e-5);
  EXPECT_DOUBLE_EQ(scene.model.darcy_solids_fraction, 5e-3);
}

TEST_F(GasOptions, GasInlet) {
  small_bed("darcy");
  const Case scene = read_case();
  EXPECT_EQ(condition(scene, "floor").kind, BoundaryKind::gas_inlet);
  EXPECT_DOUBLE_EQ(condition(scene, "floor").gas_velocity, 0.22);
  EXPECT_DOUBLE_EQ(gas_inflow(condition(scene, "floor"), at_point({0.01, 0, 0}), 3), 0.22);
}

TEST_F(GasOptions, ProfileAndHistoryOfTheInflow) {
  small_bed("incompressible");
  yaml(
      "boundary: {floor: {gas_profile: {at: [0, 4 cm, 8 cm], factor: [0, 150 %, 0]},"
      " gas_history: {at: [0, 200 ms], factor: [1, 0.5]}}}");
  const Case scene = read_case();
  const Condition& floor = condition(scene, "floor");
  EXPECT_EQ(floor.gas_variation.axis, 0);
  EXPECT_EQ(floor.gas_variation.profile.at, (std::vector<double>{0, 0.04, 0.08}));
  EXPECT_EQ(floor.gas_variation.history.at, (std::vector<double>{0, 0.2}));
  EXPECT_DOUBLE_EQ(gas_inflow(floor, at_point({0.02, 0, 0}), 0.1), 0.22 * 0.75 * 0.75);
  EXPECT_DOUBLE_EQ(gas_inflow(floor, at_point({0.04, 0, 0}), 9), 0.22 * 1.5 * 0.5);
}

TEST_F(GasOptions, ProfileAxisIsTheFirstOneAlongTheSide) {
  const auto box = [this] {
    clear();
    yaml(
        "dimension: 3\nextent: [1, 2, 3]\ngrid_cells: [2, 2, 3]\nperiodic: [y, z]\ngas: darcy\n"
        "boundary: {left: {side: x_lower, kind: gas_inlet, gas_velocity: 1, gas_profile_at: [0, 2],"
        " gas_profile_factor: [0, 1]}, right: {side: x_upper, kind: open}}");
  };
  box();
  EXPECT_EQ(condition(read_case(), "left").gas_variation.axis, 1);
  set("boundary_left_gas_profile_axis", "z");
  EXPECT_EQ(condition(read_case(), "left").gas_variation.axis, 2);
  set("boundary_left_gas_profile_axis", "x");
  const InputError error = error_of_case();
  EXPECT_EQ(error.key, "boundary_left_gas_profile_axis");
  EXPECT_NE(error.expected.find("an axis along the side x_lower"), std::string::npos) << error.what();
}

TEST_F(GasOptions, PressureOfOpenSides) {
  small_bed("darcy");
  yaml("boundary: {top: {gas_pressure: -0.1 kPa}}");
  const Case scene = read_case();
  EXPECT_DOUBLE_EQ(condition(scene, "top").gas_pressure, -100);
  EXPECT_TRUE(scene.remarks.empty());
}

TEST_F(GasOptions, SlipAtWallsAndPlates) {
  small_bin();
  yaml(
      "gas: incompressible\ngas_viscous_stress: yes\nboundary: {wall: {gas_wall: no_slip}}\n"
      "plate: {shelf: {axis: y, position: 2 cm, span: [0, 4 cm], gas_wall: no_slip},"
      " rim: {axis: y, position: 4 cm, span: [0, 4 cm]}}");
  const Case scene = read_case();
  EXPECT_TRUE(scene.model.gas_viscous_stress);
  EXPECT_TRUE(condition(scene, "wall").gas_no_slip);
  EXPECT_FALSE(condition(scene, "top").gas_no_slip);
  EXPECT_FALSE(scene.plates.at(0).condition.gas_no_slip);
  EXPECT_TRUE(scene.plates.at(1).condition.gas_no_slip);
  EXPECT_TRUE(scene.remarks.empty());
}

TEST_F(GasOptions, InitialVelocity) {
  small_bin();
  yaml("gas: incompressible\ninitial: {bed: {gas_velocity: [0, 50 cm/s]}, gas: {velocity: [0, 1]}}");
  const Case scene = read_case();
  ASSERT_EQ(scene.initial.size(), 3u);
  EXPECT_NE(scene.initial[1].find(GasMomentum::unknown), nullptr);
  EXPECT_EQ(scene.initial[1].find(SolidsMomentum::unknown), nullptr);
  EXPECT_DOUBLE_EQ(scene.initial[1].find(GasMomentum::unknown)->value[1], 0.5);
  EXPECT_EQ(scene.initial[2].name, "gas");
  EXPECT_NE(scene.initial[2].find(SolidsMomentum::unknown), nullptr);
  EXPECT_EQ(scene.initial[2].find(GasMomentum::unknown), nullptr);
}

TEST_F(GasOptions, RemarksOnWhatTheSceneDoesNotUse) {
  const std::vector<std::array<std::string, 4>> rows{
      {"none", "gas_density", "1.2", "gas is none"},
      {"none", "gas_viscosity", "1e-5", "gas is none"},
      {"none", "boundary_top_gas_pressure", "1", "gas is none"},
      {"none", "boundary_top_gas_velocity", "1", "gas is none"},
      {"darcy", "gas_viscous_stress", "yes", "gas is not incompressible"},
      {"incompressible", "gas_darcy_solids_fraction", "0.01", "gas is not darcy"},
      {"darcy", "initial_bed_gas_velocity", "0, 1", "gas is not incompressible"},
      {"darcy", "boundary_wall_gas_velocity", "1", "its kind is neither inlet nor gas_inlet"},
      {"darcy", "boundary_wall_gas_pressure", "1", "its kind is not open"},
      {"darcy", "boundary_wall_gas_profile_axis", "y", "its kind is neither inlet nor gas_inlet"},
      {"darcy", "boundary_wall_gas_wall", "no_slip", "gas is not incompressible"},
      {"incompressible", "boundary_wall_gas_wall", "no_slip", "gas_viscous_stress is no"}};
  for (const auto& [model, key, value, why] : rows) {
    clear();
    small_bin();
    set("gas", model);
    set(key, value);
    const Case scene = read_case();
    EXPECT_EQ(scene.remarks.size(), 1u) << key;
    EXPECT_TRUE(has_remark(scene, key + " is not used: " + why)) << key;
  }
}

TEST_F(GasOptions, RemarksOnASideThatIsNoWall) {
  small_bed("incompressible");
  yaml("gas_viscous_stress: yes\nboundary: {floor: {gas_wall: no_slip, gas_profile_axis: x, velocity: [0, 1]}}");
  const Case scene = read_case();
  EXPECT_TRUE(has_remark(scene, "boundary_floor_gas_wall is not used: its kind is not a wall"));
  EXPECT_TRUE(has_remark(scene, "boundary_floor_gas_profile_axis is not used: there is no gas_profile_at"));
  EXPECT_TRUE(has_remark(scene, "boundary_floor_velocity is not used: its kind has no velocity"));
  EXPECT_EQ(condition(scene, "floor").velocity[1], 0);
}

TEST_F(GasOptions, WrongValues) {
  struct Row {
    std::vector<std::pair<const char*, const char*>> settings;
    const char *key, *value, *expected;
  };
  const std::vector<Row> rows{
      {{{"gas_density", "0"}}, "gas_density", "0", "> 0"},
      {{{"gas_viscosity", "1 m"}}, "gas_viscosity", "1 m", "a value in Pa s"},
      {{{"gas_darcy_solids_fraction", "0"}}, "gas_darcy_solids_fraction", "0", "in (0, solids_fraction_max"},
      {{{"gas", "none"}}, "boundary_floor_kind", "gas_inlet", "gas darcy or incompressible"},
      {{{"boundary_floor_gas_velocity", "1 Pa"}}, "boundary_floor_gas_velocity", "1 Pa", "a value in m/s"},
      {{{"boundary_top_gas_pressure", "1 m"}}, "boundary_top_gas_pressure", "1 m", "a value in Pa"},
      {{{"boundary_wall_gas_wall", "rough"}}, "boundary_wall_gas_wall", "rough", "one of free_slip, no_slip"},
      {{{"initial_bed_gas_velocity", "1"}}, "initial_bed_gas_velocity", "1", "a list of 2 numbers"},
      {{{"boundary_lid_side", "y_upper"}, {"boundary_lid_kind", "gas_inlet"}},
       "boundary_lid_gas_velocity",
       "",
       "required"},
      {{{"boundary_floor_gas_history_at", "0, 1"}}, "boundary_floor_gas_history_factor", "", "2 entries, as many as"},
      {{{"boundary_floor_gas_history_factor", "1"}}, "boundary_floor_gas_history_at", "", "1 entry, as many as"},
      {{{"boundary_floor_gas_profile_at", "0, 1 cm"}, {"boundary_floor_gas_profile_factor", "1, 2, 3"}},
       "boundary_floor_gas_profile_factor",
       "1, 2, 3",
       "2 entries, as many as boundary_floor_gas_profile_at has"},
      {{{"boundary_floor_gas_profile_at", "0, 4 cm, 3 cm"}, {"boundary_floor_gas_profile_factor", "1, 2, 3"}},
       "boundary_floor_gas_profile_at",
       "0, 0.04, 0.03",
       "ascending numbers, but 0.03 follows 0.04"},
      {{{"boundary_floor_gas_history_at", "1, 1"}, {"boundary_floor_gas_history_factor", "1, 2"}},
       "boundary_floor_gas_history_at",
       "1, 1",
       "ascending"},
      {{{"boundary_floor_gas_profile_at", "0, 1"},
        {"boundary_floor_gas_profile_factor", "1, 2"},
        {"boundary_floor_gas_profile_axis", "y"}},
       "boundary_floor_gas_profile_axis",
       "y",
       "an axis along the side y_lower"},
      {{{"plate_p_axis", "y"}, {"plate_p_position", "2 cm"}, {"plate_p_kind", "gas_inlet"}},
       "plate_p_kind",
       "gas_inlet",
       "wall_"}};
  for (const Row& row : rows) {
    clear();
    small_bed("darcy");
    for (const auto& [key, value] : row.settings) set(key, value);
    const InputError error = error_of_case();
    EXPECT_EQ(error.key, row.key) << error.what();
    EXPECT_NE(error.value.find(row.value), std::string::npos) << error.what();
    EXPECT_NE(error.expected.find(row.expected), std::string::npos) << error.what();
  }
}

TEST_F(GasOptions, NoProfileInOneDimension) {
  yaml(
      "dimension: 1\nextent: 1\ngrid_cells: 4\ngas: darcy\nboundary: {left: {side: x_lower, kind: gas_inlet,"
      " gas_velocity: 1}, right: {side: x_upper, kind: open}}");
  EXPECT_NO_THROW(read_case());
  yaml("boundary: {left: {gas_profile: {at: [0, 1], factor: [0, 1]}}}");
  EXPECT_EQ(error_of_case().key, "boundary_left_gas_profile_at");
}

TEST_F(GasOptions, GasThatComesInNeedsAnOpenSide) {
  for (const char* model : {"darcy", "incompressible"}) {
    clear();
    small_bed(model);
    set("boundary_top_kind", "wall_free_slip");
    const InputError error = error_of_case();
    EXPECT_EQ(error.key, "boundary_floor_gas_velocity");
    EXPECT_EQ(error.value, "0.22 m/s");
    EXPECT_NE(error.expected.find("an open side, where the gas can leave"), std::string::npos) << error.what();
    set("boundary_floor_gas_velocity", "0");
    EXPECT_NO_THROW(read_case());
  }
}

TEST_F(GasOptions, OpenSideMayBeHiddenByLaterSegments) {
  small_bed("darcy");
  yaml("boundary: {z_lid: {side: y_upper, kind: wall_free_slip, patch: [0, 4 cm]}}");
  EXPECT_NO_THROW(read_case());
  set("boundary_z_lid_patch", "0, 8 cm");
  EXPECT_EQ(error_of_case().key, "boundary_floor_gas_velocity");
}

TEST_F(GasOptions, InflowAndOpenSideInTimeWindows) {
  small_bed("darcy");
  yaml("end_time: 2\nboundary: {z_lid: {side: y_upper, kind: wall_free_slip, from: 0.5}}");
  const InputError error = error_of_case();
  EXPECT_EQ(error.key, "boundary_floor_gas_velocity");
  EXPECT_NE(error.expected.find("at time 1.25 s"), std::string::npos) << error.what();
  yaml("boundary: {floor: {gas_history: {at: [0, 0.5], factor: [1, 0]}}}");
  EXPECT_NO_THROW(read_case());
  set("boundary_floor_gas_history_at", "0, 0.6");
  EXPECT_EQ(error_of_case().key, "boundary_floor_gas_velocity");
  set("end_time", "0.5");
  EXPECT_NO_THROW(read_case());
}

TEST_F(GasOptions, InflowThatTurnsRound) {
  small_bed("darcy");
  yaml("end_time: 1\nboundary: {top: {kind: symmetry}, floor: {gas_history: {at: [0, 1], factor: [1, -1]}}}");
  EXPECT_EQ(error_of_case().key, "boundary_floor_gas_velocity");
}

TEST_F(GasOptions, ParticlesThatComeInNeedAnOpenSideToo) {
  small_bin();
  yaml(
      "gas: darcy\nboundary: {floor: {kind: wall_free_slip}, top: {kind: inlet, solids_fraction: 0.1,"
      " velocity: [0, -1 cm/s]}}");
  EXPECT_EQ(error_of_case().key, "boundary_top_velocity");
  set("gas", "none");
  EXPECT_NO_THROW(read_case());
}

TEST_F(GasOptions, EffectiveYamlReadsBackAsTheSameCase) {
  small_bed("incompressible");
  yaml(R"(
gas_density: 1.2
gas_viscous_stress: yes
boundary:
  floor: {gas_profile: {at: [1 cm, 7 cm], factor: [0.5, 1]}, gas_history: {at: [0, 0.2], factor: [5, 1]}}
  top: {gas_pressure: 2 mbar}
  wall: {gas_wall: no_slip}
  x_jet: {side: y_lower, kind: inlet, solids_fraction: 0.1, patch: [0, 2 cm], until: 0.2, gas_velocity: 1}
plate: {shelf: {axis: y, position: 2 cm, span: [0, 4 cm], gas_wall: no_slip}}
initial: {bed: {gas_velocity: [0, 50 cm/s]}}
)");
  const Case first = read_case();
  clear();
  yaml(first.effective_yaml);
  const Case second = read_case();
  EXPECT_EQ(second.effective_yaml, first.effective_yaml);
  EXPECT_TRUE(second.remarks.empty());
  EXPECT_EQ(second.gas.model, GasModel::incompressible);
  EXPECT_EQ(second.gas.rho_g, 1.2);
  EXPECT_TRUE(second.model.gas_viscous_stress);
  const Condition &before = condition(first, "floor"), &after = condition(second, "floor");
  EXPECT_EQ(after.gas_velocity, before.gas_velocity);
  EXPECT_EQ(after.gas_variation.profile.at, before.gas_variation.profile.at);
  EXPECT_EQ(after.gas_variation.profile.factor, before.gas_variation.profile.factor);
  EXPECT_EQ(after.gas_variation.history.at, before.gas_variation.history.at);
  EXPECT_EQ(after.gas_variation.history.factor, before.gas_variation.history.factor);
  EXPECT_EQ(condition(second, "top").gas_pressure, 200);
  EXPECT_EQ(condition(second, "x_jet").gas_velocity, 1);
  EXPECT_TRUE(condition(second, "wall").gas_no_slip);
  EXPECT_TRUE(second.plates.at(0).condition.gas_no_slip);
  EXPECT_EQ(second.initial[1].find(GasMomentum::unknown)->value[1], 0.5);
}

}  // namespace
}  // namespace scree
