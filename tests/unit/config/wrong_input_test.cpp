#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <vector>

#include "scene.hpp"

namespace scree {
namespace {

class WrongInput : public Options {
 protected:
  /// Writes the table, names it as that of the bed, and returns what reading the case says.
  std::string complaint_on_table(const std::string& text) {
    const std::string file = testing::TempDir() + "scree_table_" + std::to_string(getpid()) + ".txt";
    std::ofstream(file) << text;
    set("initial_bed_table", file);
    set("initial_bed_table_axis", "y");
    std::string complaint;
    try {
      const Case scene = read_case();
      EXPECT_EQ(scene.initial.back().table_values.value(0.015), 0.25);
    } catch (const InputError& error) {
      EXPECT_EQ(error.key, "initial_bed_table");
      complaint = error.expected;
    }
    std::remove(file.c_str());
    return complaint;
  }
};

/// Settings on top of the small bin, and what the one line of the error must hold.
struct Row {
  std::vector<std::pair<const char*, const char*>> settings;
  const char* key;
  const char* value;
  const char* expected;
};

const Row rows[] = {
    {{{"frction_tau", "1"}}, "frction_tau", "1", "nearest is 'friction_tau'"},
    {{{"boundary_wall_knd", "open"}}, "boundary_wall_knd", "open", "nearest is 'boundary_wall_kind'"},
    {{{"bondary_lid_kind", "open"}}, "bondary_lid_kind", "open", "nearest is 'boundary_lid_kind'"},
    {{{"orifice_width", "2 cm"}}, "orifice_width", "2 cm", "a known key"},
    {{{"boundary_kind", "open"}}, "boundary_kind", "open", "a known key"},
    {{{"friction_tau", "5 cm"}},
     "friction_tau",
     "5 cm",
     "a value in s (or with a unit of that kind), > 0; its unit has another dimension"},
    {{{"friction_tau", "-1"}}, "friction_tau", "-1", "a value in s (or with a unit of that kind), > 0"},
    {{{"friction_tau", "nan"}}, "friction_tau", "nan", "a value in s"},
    {{{"friction_fluctuation", "1.5"}}, "friction_fluctuation", "1.5", "in [0, 1]"},
    {{{"friction_tau", "inf"}}, "friction_tau", "inf", "a value in s"},
    {{{"friction_tau", "1e-3 s soon"}}, "friction_tau", "1e-3 s soon", "not a known unit"},
    {{{"friction_tau", ""}}, "friction_tau", "", "a value in s"},
    {{{"friction_tau", "${slow}"}}, "friction_tau", "${slow}", "'slow' is not defined under 'define'"},
    {{{"friction_model", "schaeffer"}}, "friction_model", "schaeffer", "none, critical_state, instantaneous, relaxed"},
    {{{"friction_model", "${law}"}}, "friction_model", "${law}", "'law' is not defined"},
    {{{"friction_angle", "28.5"}}, "friction_angle", "28.5", "an angle in rad, or with a unit such as '28.5 deg'"},
    {{{"friction_angle", "70 deg"}}, "friction_exponent_dilation", "0.92", "> 1"},
    {{{"friction_solids_fraction_min", "0.7"}}, "friction_solids_fraction_min", "0.7", "solids_fraction_max = 0.65"},
    {{{"particle_density", "0"}}, "particle_density", "0", "> 0"},
    {{{"particle_restitution", "1.1"}}, "particle_restitution", "1.1", "in (0, 1]"},
    {{{"particle_friction", "-0.1"}}, "particle_friction", "-0.1", ">= 0"},
    {{{"particle_friction", "0.3"}, {"particle_restitution", "0.1"}},
     "particle_friction",
     "0.3",
     "effective_restitution (chialvo_sundaresan) of at least 0; with particle_restitution = 0.1 it is -0.083"},
    {{{"wall_particle_friction", "0.3"}, {"wall_restitution", "0.1"}},
     "wall_particle_friction",
     "0.3",
     "with wall_restitution = 0.1 it is"},
    {{{"boundary_wall_particle_friction", "0.3"}, {"boundary_wall_restitution", "0.1"}},
     "boundary_wall_particle_friction",
     "0.3",
     "with boundary_wall_restitution = 0.1 it is"},
    {{{"correlation_length_constant", "0"}}, "correlation_length_constant", "0", "> 0"},
    {{{"friction_coefficient", "cidr"}, {"friction_model", "instantaneous"}},
     "friction_coefficient",
     "cidr",
     "constant for friction_model instantaneous"},
    {{{"friction_coefficient", "mu_i"}, {"friction_angle", "45 deg"}},
     "friction_coefficient_limit",
     "0.6435",
     "at least sin(friction_angle) = 0.707107"},
    {{{"friction_coefficient", "mu_i_regularised"}},
     "friction_coefficient",
     "mu_i_regularised",
     "mu(I) is well-posed at no I"},
    {{{"friction_coefficient", "fluidity"}, {"friction_model", "critical_state"}},
     "friction_coefficient",
     "fluidity",
     "another one where friction_model is critical_state; fluidity takes relaxed"},
    {{{"friction_coefficient", "fluidity"}, {"gas", "darcy"}},
     "friction_coefficient",
     "fluidity",
     "another one where there is a gas; fluidity takes gas none"},
    {{{"friction_coefficient", "fluidity"}, {"friction_fluidity_at_rest", "0"}},
     "friction_fluidity_at_rest",
     "0",
     "a value in 1/s (or with a unit of that kind), > 0"},
    {{{"friction_coefficient", "fluidity"}, {"initial_bed_fluidity", "0"}},
     "initial_bed_fluidity",
     "0",
     "a value in 1/s (or with a unit of that kind), > 0"},
    {{{"friction_inertial_number", "0"}}, "friction_inertial_number", "0", "> 0"},
    {{{"solids_fraction_max", "0.8"}}, "solids_fraction_max", "0.8", "in (0, 0.7405]"},
    {{{"dimension", "4"}}, "dimension", "4", "one of 1, 2, 3"},
    {{{"extent", "1"}}, "extent", "1", "a list of 2 numbers (one per axis)"},
    {{{"extent", "1, 2 s"}}, "extent", "1, 2 s", "another dimension; at '2 s'"},
    {{{"extent", "1,"}}, "extent", "1,", "a number is missing"},
    {{{"grid_cells", "8, 2.5"}}, "grid_cells", "2.5", "a whole number >= 1"},
    {{{"grid_cells", "8, 0"}}, "grid_cells", "0", "a whole number >= 1"},
    {{{"grid_cells", "30000, 30000"}}, "grid", "900060001 nodes", "at most 214748364"},
    {{{"grid_cells", "999999999, 999999999"}, {"grid_refine", "999999999"}}, "grid", "cells along x", "at most 1e+07"},
    {{{"grid_refine", "2 cm"}}, "grid_refine", "2 cm", "a whole number"},
    {{{"grid_x_edges", "0, 0.08"}}, "grid_x_cells", "", "1 entry, one fewer than grid_x_edges"},
    {{{"grid_x_edges", "0, 0.1, 0.08"}, {"grid_x_cells", "1,1"}}, "grid_x_edges", "0.08", "ascending"},
    {{{"gravity", "-9.81"}}, "gravity", "-9.81", "a list of 2 numbers"},
    {{{"periodic", "z"}}, "periodic", "z", "axes of this case"},
    {{{"periodic", "x"}}, "boundary_axis_side", "x_lower", "not periodic"},
    {{{"time_step_adaptive", "maybe"}}, "time_step_adaptive", "maybe", "yes or no"},
    {{{"time_step_max", "1e-9"}}, "time_step_initial", "1e-06", "at most time_step_max"},
    {{{"accuracy", "2"}}, "accuracy", "2", "in (0, 1"},
    {{{"boundary_wall_patch", "0, 4 cm"}}, "side x_upper", "", "none holds at (0.08, 0.07) m"},
    {{{"boundary_wall_patch", "0, 3.5 cm"}}, "boundary_wall_patch", "0.035", "the nearest is at 0.04 m"},
    {{{"boundary_wall_patch", "4 cm, 0"}}, "boundary_wall_patch", "0.04, 0", "lower below upper"},
    {{{"boundary_wall_until", "0.5"}}, "side x_upper", "", "at time 0.75 s"},
    {{{"boundary_wall_from", "2"}, {"boundary_wall_until", "1"}}, "boundary_wall_until", "1 s", "a time after"},
    {{{"boundary_wall_side", "z_upper"}}, "boundary_wall_side", "z_upper", "one of x_lower, x_upper, y_lower, y_upper"},
    {{{"boundary_wall_velocity", "1"}}, "boundary_wall_velocity", "1", "a list of 2 numbers"},
    {{{"boundary_wall_kind", "inlet"}}, "boundary_wall_solids_fraction", "", "required"},
    {{{"boundary_lid_kind", "open"}}, "boundary_lid_side", "", "required"},
    {{{"plate_p_axis", "y"}}, "plate_p_position", "", "required"},
    {{{"plate_p_axis", "y"}, {"plate_p_position", "2 cm"}, {"plate_p_kind", "open"}}, "plate_p_kind", "open", "wall_"},
    {{{"plate_p_axis", "y"}, {"plate_p_position", "0"}}, "plate_p_position", "0 m", "inside the box"},
    {{{"plate_p_axis", "y"}, {"plate_p_position", "2.1 cm"}}, "plate_p_position", "0.021 m", "nearest is at 0.02 m"},
    {{{"plate_p_axis", "y"}, {"plate_p_position", "2 cm"}, {"plate_p_openings", "0,1,2"}},
     "plate_p_openings",
     "0,1,2",
     "a multiple of 2 numbers"},
    {{{"initial_bed_solids_fraction", "0.65"}}, "initial_bed_solids_fraction", "0.65", "in [0, solids_fraction_max"},
    {{{"initial_bed_granular_temperature", "-1"}}, "initial_bed_granular_temperature", "-1", ">= 0"},
    {{{"initial_bed_profile", "equilibrium"}}, "initial_bed_surface", "", "required"},
    {{{"initial_bed_profile", "equilibrium"}, {"initial_bed_surface", "0.05"}, {"gravity", "1, 1"}},
     "initial_bed_profile",
     "equilibrium",
     "gravity along one axis"},
    {{{"initial_bed_box", "9 cm, 10 cm, 0, 1 cm"}}, "initial_bed_box", "0.09, 0.08", "inside the box"},
    {{{"initial_bed_table", "/no/such/file"}}, "initial_bed_table", "/no/such/file", "can be read"},
    {{{"probe_p_point", "1, 1"}}, "probe_p_point", "1, 1", "along axis x is from 0 to 0.08 m"},
    {{{"flux_f_axis", "y"}, {"flux_f_position", "0.011"}}, "flux_f_position", "0.011 m", "grid plane"},
    {{{"gas", "compressible"}}, "gas", "compressible", "one of none, darcy, incompressible"},
    {{{"define_friction_tau", "1"}, {"friction_tau", "1"}}, "define_friction_tau", "1", "not an option itself"}};

TEST_F(WrongInput, IsOneLineThatNamesKeyValueAndWhatWouldBeRight) {
  for (const Row& row : rows) {
    clear();
    small_bin();
    for (const auto& [key, value] : row.settings) set(key, value);
    try {
      read_case();
      ADD_FAILURE() << row.key << " = '" << row.value << "' was accepted";
    } catch (const InputError& error) {
      const std::string line = error.what();
      EXPECT_EQ(error.key, row.key) << line;
      EXPECT_NE(error.value.find(row.value), std::string::npos) << line;
      EXPECT_NE(error.expected.find(row.expected), std::string::npos) << line;
      EXPECT_NE(line.find(row.key), std::string::npos) << line;
      EXPECT_NE(line.find(row.value), std::string::npos) << line;
      EXPECT_EQ(line.find('\n'), std::string::npos) << line;
    }
  }
}

TEST_F(WrongInput, IsOneShortLineWhateverTheTextsHold) {
  small_bin();
  set("friction_tau", "1\n2\t3\x1b[2J" + std::string(5000, '9'));
  try {
    read_case();
    FAIL();
  } catch (const InputError& error) {
    const std::string line = error.what();
    EXPECT_EQ(line.find_first_of("\n\t\x1b"), std::string::npos) << line;
    EXPECT_LT(line.size(), 1000u);
  }
}

TEST_F(WrongInput, Tables) {
  small_bin();
  EXPECT_EQ(complaint_on_table("# x nu\n0.01, 0.2\n 0.02 3e-1 \r\n\n"), "");
  EXPECT_NE(complaint_on_table("0 0.2\n1 nan\n").find("two finite numbers each, but it has '1 nan'"),
            std::string::npos);
  EXPECT_NE(complaint_on_table("inf 0.2\n").find("finite"), std::string::npos);
  EXPECT_NE(complaint_on_table("0 0.2 0.3\n").find("two"), std::string::npos);
  EXPECT_NE(complaint_on_table("0 0.2\n0 0.3\n").find("ascending"), std::string::npos);
  EXPECT_NE(complaint_on_table("0 0.65\n").find("[0, solids_fraction_max = 0.65)"), std::string::npos);
  EXPECT_NE(complaint_on_table("# nothing\n").find("at least one"), std::string::npos);
}

TEST_F(WrongInput, MissingGridAndSides) {
  EXPECT_THROW(read_case(), InputError);
  yaml("extent: [1, 1]\ngrid_cells: [2, 2]");
  try {
    read_case();
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.key, "side x_lower");
  }
}

}  // namespace
}  // namespace scree
