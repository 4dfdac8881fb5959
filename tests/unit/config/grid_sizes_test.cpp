#include <algorithm>
#include <cmath>

#include "scene.hpp"

namespace scree {
namespace {

constexpr double mm = 1e-3, cm = 1e-2;

/// Cells by their sizes: 0.5 mm at the places to refine, 1 cm far away.
class GridSizes : public Options {
 protected:
  void sizes() { yaml("grid: {finest: 0.5 mm, coarsest: 1 cm}"); }

  /// A bin of 8 cm x 30 cm about x = 0, with a hole of 1.4 cm in a floor at y = 5 cm.
  void bin() {
    yaml(R"(
extent: [8 cm, 30 cm]
origin: [-4 cm, 0]
gravity: [0, -9.81]
boundary:
  left: {side: x_lower, kind: wall_johnson_jackson}
  right: {side: x_upper, kind: wall_johnson_jackson}
  left_below: {side: x_lower, kind: open, patch: [0, 5 cm], order: 1}
  right_below: {side: x_upper, kind: open, patch: [0, 5 cm], order: 1}
  bottom: {side: y_lower, kind: open}
  top: {side: y_upper, kind: open}
plate:
  floor: {axis: y, position: 5 cm, openings: [-0.7 cm, 0.7 cm]}
initial:
  fill: {box: [-4 cm, 4 cm, 5 cm, 25 cm], solids_fraction: 0.6}
)");
    sizes();
  }

  /// A closed box of 8 cm x 10 cm, to put openings in.
  void closed_box() {
    yaml(R"(
extent: [8 cm, 10 cm]
boundary:
  left: {side: x_lower, kind: wall_free_slip}
  right: {side: x_upper, kind: wall_free_slip}
  floor: {side: y_lower, kind: wall_free_slip}
  top: {side: y_upper, kind: wall_free_slip}
)");
    sizes();
  }

  /// Sizes of the cells below and above a coordinate, 0 beyond the ends; empty where there is no face.
  static std::vector<double> beside(const Case& scene, int axis, double at) {
    const std::vector<double>& faces = scene.box.faces[axis];
    const auto face = std::find_if(faces.begin(), faces.end(), [&](double x) { return std::abs(x - at) < 1e-15; });
    if (face == faces.end()) return {};
    return {face == faces.begin() ? 0 : face[0] - face[-1], face + 1 == faces.end() ? 0 : face[1] - face[0]};
  }

  static void expect_fine(const Case& scene, int axis, double at, double size = 0.5 * mm) {
    const std::vector<double> sizes = beside(scene, axis, at);
    ASSERT_EQ(sizes.size(), 2U) << "no face at " << at;
    for (const double cell : sizes)
      EXPECT_TRUE(cell == 0 || std::abs(cell - size) < 1e-3 * size) << cell << " at " << at;
  }

  static void expect_coarse(const Case& scene, int axis, double at) {
    const std::vector<double> sizes = beside(scene, axis, at);
    ASSERT_EQ(sizes.size(), 2U) << "no face at " << at;
    for (const double cell : sizes) EXPECT_TRUE(cell == 0 || cell > 2 * mm) << cell << " at " << at;
  }
};

TEST_F(GridSizes, RefineTheLipsOfAHoleAndItsPlate) {
  bin();
  const Case scene = read_case();
  for (const double lip : {-0.7 * cm, 0.7 * cm}) expect_fine(scene, 0, lip);
  expect_fine(scene, 1, 5 * cm);
  // Where the open sides below the floor end there is a plate and no lip, and at sides of the box nothing is fine.
  for (const double side : {-4 * cm, 4 * cm}) expect_coarse(scene, 0, side);
  expect_coarse(scene, 1, 30 * cm);
  expect_coarse(scene, 1, 0);
}

TEST_F(GridSizes, GiveASymmetricSceneTheSameBitsOnBothSides) {
  bin();
  const std::vector<double> faces = read_case().box.faces[0];
  for (std::size_t i = 0; i < faces.size(); ++i) EXPECT_EQ(faces[i], -faces[faces.size() - 1 - i]);
}

TEST_F(GridSizes, MayDifferByAxis) {
  bin();
  yaml("grid: {finest: [0.1 mm, 0.3 mm], coarsest: [1 cm, 3 cm], growth: [1.4, 1.2]}");
  const Case scene = read_case();
  expect_fine(scene, 0, 0.7 * cm, 0.1 * mm);
  expect_fine(scene, 1, 5 * cm, 0.3 * mm);
}

TEST_F(GridSizes, RefineSlitsAndInletsInTheirSide) {
  closed_box();
  yaml(
      "gas: incompressible\nboundary: {top: {kind: open},\n"
      "  slit: {side: y_lower, kind: gas_inlet, gas_velocity: 1, patch: [3 cm, 5 cm], order: 1}}");
  const Case scene = read_case();
  for (const double edge : {3 * cm, 5 * cm}) expect_fine(scene, 0, edge);
  expect_fine(scene, 1, 0);
  expect_coarse(scene, 0, 0);
  expect_coarse(scene, 1, 10 * cm);  // a whole side that is open is no opening in a wall
}

TEST_F(GridSizes, RefineOpeningsInUprightSides) {
  closed_box();
  yaml("boundary: {mouth: {side: x_upper, kind: open, patch: [1 cm, 3 cm], order: 1}}");
  const Case scene = read_case();
  for (const double edge : {1 * cm, 3 * cm}) expect_fine(scene, 1, edge);
  expect_fine(scene, 0, 8 * cm);
  expect_coarse(scene, 0, 0);
}

TEST_F(GridSizes, RefineFreeEdgesOfPlates) {
  closed_box();
  yaml("plate: {baffle: {axis: x, position: 2 cm, span: [0, 6 cm]}}");
  const Case scene = read_case();
  expect_fine(scene, 0, 2 * cm);
  expect_fine(scene, 1, 6 * cm);
  expect_coarse(scene, 1, 0);
}

TEST_F(GridSizes, RefineWhatIsNamed) {
  closed_box();
  yaml(R"(
grid: {fine_at: [bed, left], fine_x: 5 cm}
initial:
  bed: {box: [0, 8 cm, 0, 4 cm], solids_fraction: 0.6}
  high: {box: [0, 8 cm, 7 cm, 8 cm], solids_fraction: 0.1}
)");
  const Case scene = read_case();
  expect_fine(scene, 1, 4 * cm);
  expect_fine(scene, 0, 0);
  expect_fine(scene, 0, 5 * cm);
  expect_coarse(scene, 0, 8 * cm);
  expect_coarse(scene, 1, 8 * cm);  // the edge of a region is a plane, though not a fine one
}

TEST_F(GridSizes, HitAllEdgesWithoutRefiningThem) {
  closed_box();
  yaml(R"(
grid: {x_edges: [0, 2.7 cm, 8 cm], fine_at: none, fine_y: 0}
boundary: {upper_left: {side: x_lower, kind: wall_no_slip, patch: [3.1 cm, 10 cm], order: 1}}
flux: {across: {axis: y, position: 6.6 cm, patch: [1.3 cm, 8 cm]}}
)");
  const Case scene = read_case();
  for (const double at : {1.3 * cm, 2.7 * cm}) expect_coarse(scene, 0, at);
  for (const double at : {3.1 * cm, 6.6 * cm}) expect_coarse(scene, 1, at);
}

TEST_F(GridSizes, EdgesOfRegionsGiveWayToOtherPlanes) {
  bin();
  set("initial_fill_box", "-4 cm, 4 cm, 5.01 cm, 25 cm");
  const Case scene = read_case();
  EXPECT_TRUE(beside(scene, 1, 5.01 * cm).empty());
  expect_fine(scene, 1, 5 * cm);
  expect_coarse(scene, 1, 25 * cm);
}

TEST_F(GridSizes, WrapRoundPeriodicAxes) {
  closed_box();
  yaml("periodic: x\ngrid: {fine_at: none, fine_x: 0}");
  for (const char* key : {"boundary_left_side", "boundary_right_side"}) set(key, "y_upper");
  const Case scene = read_case();
  expect_fine(scene, 0, 0);
  expect_fine(scene, 0, 8 * cm);
}

TEST_F(GridSizes, HoldInThreeDimensions) {
  yaml(R"(
dimension: 3
extent: [8 cm, 30 cm, 6 cm]
origin: [-4 cm, 0, 0]
periodic: z
boundary:
  left: {side: x_lower, kind: wall_johnson_jackson}
  right: {side: x_upper, kind: wall_johnson_jackson}
  bottom: {side: y_lower, kind: open}
  top: {side: y_upper, kind: open}
plate:
  floor: {axis: y, position: 5 cm, openings: [-0.7 cm, 0.7 cm, 2 cm, 4 cm]}
)");
  sizes();
  const Case scene = read_case();
  for (const double lip : {-0.7 * cm, 0.7 * cm}) expect_fine(scene, 0, lip);
  for (const double lip : {2 * cm, 4 * cm}) expect_fine(scene, 2, lip);
  expect_fine(scene, 1, 5 * cm);
  const std::vector<double>& z = scene.box.faces[2];
  EXPECT_NEAR((z[1] - z[0]) / (z[z.size() - 1] - z[z.size() - 2]), 1, 1e-9) << "round the periodic axis";
  set("plate_floor_openings", "-0.7 cm, 0.7 cm, 0, 6 cm");  // a slot along all of z
  EXPECT_LE(read_case().box.cells(2), 6) << "it has no edges along z";
}

TEST_F(GridSizes, AreCutByRefinement) {
  bin();
  const std::vector<double> once = read_case().box.faces[1];
  set("grid_refine", "2");
  const std::vector<double> twice = read_case().box.faces[1];
  ASSERT_EQ(twice.size(), 2 * once.size() - 1);
  for (std::size_t i = 0; i < once.size(); ++i) EXPECT_NEAR(twice[2 * i], once[i], 1e-15);
}

TEST_F(GridSizes, TheEffectiveCaseHasTheSameFaces) {
  bin();
  yaml("grid: {fine_at: [openings, fill], fine_x: 2.2 cm, growth: 1.3}");
  const Case scene = read_case();
  clear();
  yaml(scene.effective_yaml);
  EXPECT_EQ(read_case().box.faces, scene.box.faces);
}

TEST_F(GridSizes, WinOverNumbersWithARemark) {
  bin();
  yaml("grid: {cells: [8, 30], x_edges: [-4 cm, 4 cm], x_cells: 8, x_ratio: 1}");
  const Case scene = read_case();
  expect_fine(scene, 0, 0.7 * cm);
  for (const char* key : {"grid_cells", "grid_x_cells", "grid_x_ratio"})
    EXPECT_TRUE(has_remark(scene, std::string(key) + " is not used: ")) << key;
}

TEST_F(GridSizes, TheSummaryCountsTheCells) {
  bin();
  const Case scene = read_case();
  ASSERT_EQ(scene.grid_summary.size(), 3U);
  const std::string x = std::to_string(scene.box.cells(0)), y = std::to_string(scene.box.cells(1));
  EXPECT_EQ(scene.grid_summary[0],
            "grid: " + x + " x " + y + " = " + std::to_string(scene.box.cells(0) * scene.box.cells(1)) + " cells");
  EXPECT_EQ(scene.grid_summary[1].find("grid along x: " + x + " cells of 0.0005 m to 0.00"), 0U);
  EXPECT_NE(scene.grid_summary[1].find("neighbours within a factor of 1.2"), std::string::npos);
}

struct Row {
  const char* setting;
  const char* value;
  const char* key;
  const char* value_of_error;
  const char* expected;
};

TEST_F(GridSizes, WhatCannotBeIsOneClearError) {
  const Row rows[] = {
      {"grid_finest", "2 cm", "grid_finest", "0.02 m", "at most grid_coarsest = 0.01 m along x"},
      {"grid_finest", "0", "grid_finest", "0", "> 0"},
      {"grid_finest", "1 mm, 1 mm, 1 mm", "grid_finest", "3 entries", "1 entry, or 2 entries, one per axis"},
      {"grid_finest", "1e-15", "grid_finest", "1e-15 m", "at least 4e-11 m along x"},
      {"grid_finest", "1 s", "grid_finest", "1 s", "another dimension"},
      {"grid_coarsest", "0.1 mm", "grid_finest", "0.0005 m", "at most grid_coarsest = 0.0001 m along x"},
      {"grid_growth", "1", "grid_growth", "1", "in (1, 2]"},
      {"grid_growth", "2.5", "grid_growth", "2.5", "in (1, 2]"},
      {"grid_fine_at", "flor", "grid_fine_at", "flor", "flux planes and initial regions of the case: openings, "},
      {"grid_fine_at", "openings, none", "grid_fine_at", "none", "names of boundaries"},
      {"grid_fine_at", "none", "grid_fine_at", "", "a place where cells are to be finest"},
      {"grid_fine_x", "5 cm", "grid_fine_x", "0.05 m", "places in the box, which is from -0.04 m to 0.04 m along x"},
      {"grid_fine_x", "0.71 cm", "grid_finest", "0.0005 m",
       "a whole number of cells fits between the planes at 0.007 m and 0.0071 m along x, which are 0.0001 m apart"},
      {"plate_floor_openings", "0.7 cm, 0.71 cm", "grid_finest", "0.0005 m", "such as 0.0001 m"},
      {"grid_refine", "1000000", "grid", "cells along x", "at most 1e+07 along an axis"},
      {"grid_x_edges", "4 cm, -4 cm", "grid_x_edges", "-0.04", "ascending edges"},
  };
  for (const Row& row : rows) {
    SCOPED_TRACE(std::string(row.setting) + " " + row.value);
    clear();
    bin();
    set(row.setting, row.value);
    const InputError error = error_of_case();
    EXPECT_EQ(error.key, row.key);
    EXPECT_NE(error.value.find(row.value_of_error), std::string::npos) << error.value;
    EXPECT_NE(error.expected.find(row.expected), std::string::npos) << error.expected;
  }
}

TEST_F(GridSizes, OneOfTheTwoSizesIsNotEnough) {
  small_bin();
  yaml("grid_finest: 1 mm");
  EXPECT_EQ(error_of_case().key, "grid_coarsest");
  clear();
  small_bin();
  yaml("grid_coarsest: 1 mm");
  EXPECT_EQ(error_of_case().key, "grid_finest");
}

}  // namespace
}  // namespace scree
