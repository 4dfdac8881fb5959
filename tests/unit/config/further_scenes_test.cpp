/// Options of further scenes: regions from other runs, gas along periodic axes, inlets that vary, plates that move.
#include "scene.hpp"

namespace scree {
namespace {

class FurtherScenes : public Options {
 protected:
  void SetUp() override { small_bin(); }

  /// The error where some keys are set beside those of the bin.
  InputError error_with(const std::vector<std::pair<std::string, std::string>>& keys) {
    clear();
    small_bin();
    for (const auto& [key, value] : keys) set(key, value);
    return error_of_case();
  }
};

TEST_F(FurtherScenes, ARegionFromARunTakesWholeCells) {
  yaml("initial: {old: {run: out/settled, box: [1 cm, 8 cm, 0, 4.0000001 cm]}}");
  const Case scene = read_case();
  const InitialRegion& region = scene.initial.back();
  EXPECT_EQ(region.run, "out/settled");
  EXPECT_DOUBLE_EQ(region.upper[1], 0.04);
  EXPECT_TRUE(region.has_own_solids_fraction());
  EXPECT_TRUE(scene.has_particles());
  set("initial_old_box", "1 cm, 8 cm, 0, 4.1 cm");
  EXPECT_EQ(error_of_case().key, "initial_old_box");
}

TEST_F(FurtherScenes, ARunIsTheOneSourceOfTheSolidsFraction) {
  const std::pair<std::string, std::string> run{"initial_bed_run", "out/settled"},
      box{"initial_bed_box", "0, 8 cm, 0, 4 cm"};
  EXPECT_EQ(error_with({run, box, {"initial_bed_profile", "equilibrium"}, {"initial_bed_surface", "0.05"}}).key,
            "initial_bed_run");
  EXPECT_EQ(error_with({run, box, {"initial_bed_table", "nu.txt"}}).key, "initial_bed_run");
  clear();
  small_bin();
  set(run.first, run.second);
  set(box.first, box.second);
  EXPECT_TRUE(has_remark(read_case(), "initial_bed_solids_fraction is not used"));
}

TEST_F(FurtherScenes, GasIsDrivenAlongPeriodicAxes) {
  clear();
  yaml(R"(
extent: [8 cm, 10 cm]
grid: {cells: [8, 5]}
periodic: y
gas: darcy
boundary:
  left: {side: x_lower, kind: symmetry}
  right: {side: x_upper, kind: symmetry}
initial: {bed: {solids_fraction: 0.6}}
mean_pressure_gradient: [0, -4 kPa/m]
)");
  EXPECT_DOUBLE_EQ(read_case().model.mean_pressure_gradient[1], -4000);
  EXPECT_FALSE(read_case().gas_flow.held);
  set("mean_gas_velocity", "0, 40 cm/s");
  EXPECT_TRUE(read_case().gas_flow.held);
  EXPECT_DOUBLE_EQ(read_case().gas_flow.velocity[1], 0.4);
  set("mean_gas_velocity", "0.1, 0");
  EXPECT_EQ(error_of_case().key, "mean_gas_velocity");
  EXPECT_EQ(error_of_case().expected, "0 along x, or periodic x");
  set("gas", "none");
  EXPECT_TRUE(has_remark(read_case(), "mean_gas_velocity is not used: gas is none"));
}

TEST_F(FurtherScenes, InletsVary) {
  yaml(R"(
boundary:
  feed: {side: y_upper, kind: inlet, patch: [2 cm, 6 cm], order: 1, velocity: [0, -1], solids_fraction: 0.1, from: 2,
         profile: {shape: power, exponent: 5, at: [2 cm, 6 cm], factor: [0.5, 1]},
         history: {at: [0, 1], factor: [1, 2]}, rise_time: 300 ms}
)");
  const Case scene = read_case();
  const InletVariation& variation = scene.segments.back().condition.variation;
  EXPECT_EQ(variation.shape, InletShape::power);
  EXPECT_EQ(variation.exponent, 5);
  EXPECT_DOUBLE_EQ(variation.lower[0], 0.02);
  EXPECT_DOUBLE_EQ(variation.upper[0], 0.06);
  EXPECT_EQ(variation.begin, 2);
  EXPECT_DOUBLE_EQ(variation.rise_time, 0.3);
  EXPECT_EQ(variation.profile.factor, (std::vector<double>{0.5, 1}));
  EXPECT_EQ(variation.history.factor, (std::vector<double>{1, 2}));
  EXPECT_EQ(scene.segments.back().condition.gas_variation.rise_time, 0);
  set("boundary_feed_history_factor", "1");
  EXPECT_EQ(error_of_case().key, "boundary_feed_history_factor");
  set("boundary_feed_history_factor", "1, 2");
  set("boundary_feed_profile_axis", "y");
  EXPECT_EQ(error_of_case().key, "boundary_feed_profile_axis");
  set("boundary_feed_profile_axis", "x");
  set("boundary_feed_kind", "open");
  EXPECT_TRUE(has_remark(read_case(), "boundary_feed_rise_time is not used: its kind is not inlet"));
}

/// Without a way out: 0.1 of 4 cm x 1 m/s fill the bin of 80 cm2 with room for 0.65 of it, less a bed of 0.6 in half.
TEST_F(FurtherScenes, RoomCountsWhatComesInWithItsHistory) {
  const double room = 0.65 * 80e-4 - 0.6 * 32e-4, full_rate = 0.1 * 0.04;
  yaml(R"(
end_time: 10
boundary:
  floor: {kind: symmetry}
  top: {kind: symmetry}
  feed: {side: y_upper, kind: inlet, patch: [2 cm, 6 cm], order: 1, velocity: [0, -1], solids_fraction: 0.1}
initial: {bed: {box: [0, 8 cm, 0, 4 cm]}}
)");
  for (const auto& [rise_time, lost] : {std::pair(0.0, 0.0), std::pair(1.0, 0.5)}) {
    set("boundary_feed_rise_time", std::to_string(rise_time));
    set("end_time", std::to_string(0.99 * room / full_rate + lost));
    EXPECT_EQ(error_of_case().key, "") << rise_time;
    set("end_time", std::to_string(1.01 * room / full_rate + lost));
    EXPECT_EQ(error_of_case().key, "boundary_feed_velocity") << rise_time;
  }
}

TEST_F(FurtherScenes, PlatesComeGoAndSlide) {
  yaml("plate: {gate: {axis: y, position: 4 cm, span: [-3 cm, 3.3 cm], slide_speed: 2 cm/s, slide_from: 1, until: 3}}");
  const Case scene = read_case();
  const Plate& gate = scene.plates.at(0);
  EXPECT_EQ(gate.slide_axis, 0);
  EXPECT_DOUBLE_EQ(gate.slide_speed, 0.02);
  EXPECT_DOUBLE_EQ(gate.span.upper[0], 0.033) << "off the grid, since it slides";
  EXPECT_EQ(gate.condition.until, 3);
  for (const auto& [key, value] : {std::pair("plate_gate_from", "4"), std::pair("plate_gate_slide_until", "0.5"),
                                   std::pair("plate_gate_slide_axis", "y"), std::pair("plate_gate_span", "3 cm, 2 cm"),
                                   std::pair("plate_gate_slide_speed", "0")}) {
    clear();
    small_bin();
    yaml(
        "plate: {gate: {axis: y, position: 4 cm, span: [-3 cm, 3.3 cm], slide_speed: 2 cm/s, slide_from: 1, until: "
        "3}}");
    set(key, value);
    const std::string wrong = std::string(key) == "plate_gate_from"          ? "plate_gate_until"
                              : std::string(key) == "plate_gate_slide_speed" ? "plate_gate_span"
                                                                             : key;
    EXPECT_EQ(error_of_case().key, wrong) << key;
  }
}

/// Gas blown in below a plate has a way out until the plate comes, or has slid in.
TEST_F(FurtherScenes, GasFindsItsWayPastPlatesThatMove) {
  clear();
  yaml(R"(
extent: [8 cm, 10 cm]
grid: {cells: [8, 5]}
gas: darcy
end_time: 10
boundary:
  left: {side: x_lower, kind: symmetry}
  right: {side: x_upper, kind: symmetry}
  floor: {side: y_lower, kind: gas_inlet, gas_velocity: 0.1}
  top: {side: y_upper, kind: open}
plate: {lid: {axis: y, position: 4 cm, from: 11}}
)");
  EXPECT_EQ(error_of_case().key, "");
  set("plate_lid_from", "9");
  EXPECT_EQ(error_of_case().key, "boundary_floor_gas_velocity");
  set("plate_lid_from", "0");
  set("plate_lid_span", "-8 cm, 0");
  set("plate_lid_slide_speed", "0.7 cm/s");  // 7 cm in 10 s: a face stays open
  EXPECT_EQ(error_of_case().key, "");
  set("plate_lid_slide_speed", "0.8 cm/s");
  EXPECT_EQ(error_of_case().key, "boundary_floor_gas_velocity");
}

TEST_F(FurtherScenes, WallStressIsAChoice) {
  EXPECT_FALSE(read_case().output.wall_stress);
  set("output_wall_stress", "yes");
  EXPECT_TRUE(read_case().output.wall_stress);
}

}  // namespace
}  // namespace scree
