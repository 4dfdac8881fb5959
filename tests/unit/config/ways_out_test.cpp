#include "scene.hpp"
#include "scree/config/connected_parts.hpp"

namespace scree {
namespace {

Box box_of(int dim, std::array<bool, max_dim> periodic = {false, false, false}) {
  Box box;
  box.dim = dim;
  box.periodic = periodic;
  for (int axis = 0; axis < dim; ++axis) box.faces[axis] = {0, 1, 2, 3, 4};
  return box;
}

Plate plate_at(int axis, double position) {
  Plate plate;
  plate.axis = axis;
  plate.position = position;
  return plate;
}

Patch patch(std::array<double, max_dim> lower, std::array<double, max_dim> upper) {
  Patch result;
  result.lower = lower;
  result.upper = upper;
  return result;
}

TEST(ConnectedParts, PlatesDivideTheBox) {
  for (const int dim : {1, 2, 3}) {
    EXPECT_EQ(ConnectedParts(box_of(dim), {}, {}).count(), 1);
    EXPECT_EQ(ConnectedParts(box_of(dim), {}, {plate_at(0, 2)}).count(), 2);
    EXPECT_EQ(ConnectedParts(box_of(dim), {}, {plate_at(0, 1), plate_at(0, 3)}).count(), 3);
  }
  EXPECT_EQ(ConnectedParts(box_of(3), {}, {plate_at(0, 2), plate_at(1, 1), plate_at(2, 3)}).count(), 8);
}

TEST(ConnectedParts, PeriodicAxesGoRound) {
  EXPECT_EQ(ConnectedParts(box_of(2, {true, false, false}), {}, {plate_at(0, 2)}).count(), 1);
  EXPECT_EQ(ConnectedParts(box_of(2, {true, false, false}), {}, {plate_at(0, 1), plate_at(0, 3)}).count(), 2);
  EXPECT_EQ(ConnectedParts(box_of(2, {true, true, false}), {}, {}).side_faces().size(), 0u);
}

TEST(ConnectedParts, OpeningsAndSpansLetPass) {
  Plate plate = plate_at(0, 2);
  plate.openings = {patch({0, 1, 0}, {0, 2, 0})};
  EXPECT_EQ(ConnectedParts(box_of(2), {}, {plate}).count(), 1);
  Plate half = plate_at(0, 2);
  half.span = patch({0, 0, 0}, {0, 3, 0});
  EXPECT_EQ(ConnectedParts(box_of(2), {}, {half}).count(), 1);
  Plate rest = plate_at(1, 3);
  rest.span = patch({0, 0, 0}, {2, 0, 0});
  EXPECT_EQ(ConnectedParts(box_of(2), {}, {half, rest}).count(), 2);
}

TEST(ConnectedParts, FacesCarryAreaAndPart) {
  const ConnectedParts parts(box_of(3), {}, {plate_at(0, 1)});
  double area = 0, volume = 0;
  for (const SideFace& face : parts.side_faces())
    if (face.part == parts.blocks().front().part) area += face.area;
  for (const Block& block : parts.blocks()) volume += block.volume;
  EXPECT_DOUBLE_EQ(area, 16 + 4 * 4);
  EXPECT_DOUBLE_EQ(volume, 64);
}

/// A box of 8 cm with a plate from floor to top in the middle, and an open side over its left half.
class WaysOut : public Options {
 protected:
  void divided(const std::string& gas) {
    yaml("extent: [8 cm, 8 cm]\ngrid_cells: [8, 8]\ngravity: [0, -9.81]\ngas: " + gas + R"(
boundary:
  left:  {side: x_lower, kind: wall_free_slip}
  right: {side: x_upper, kind: wall_free_slip}
  floor: {side: y_lower, kind: wall_free_slip}
  top:   {side: y_upper, kind: wall_free_slip}
  vent:  {side: y_upper, kind: open, patch: [0, 4 cm], order: 1}
plate: {middle: {axis: x, position: 4 cm}}
)");
  }
};

TEST_F(WaysOut, GasBlownIntoAPocketIsRefused) {
  for (const char* gas : {"darcy", "incompressible"}) {
    clear();
    divided(gas);
    yaml("boundary: {blow: {side: y_lower, kind: gas_inlet, gas_velocity: 0.1, patch: [4 cm, 8 cm], order: 1}}");
    const InputError error = error_of_case();
    EXPECT_EQ(error.key, "boundary_blow_gas_velocity");
    EXPECT_NE(error.expected.find("an open side, where the gas can leave"), std::string::npos) << error.what();
    EXPECT_NE(error.expected.find("around (0.06, "), std::string::npos) << error.what();
    EXPECT_EQ(error.place, "test.yaml:1");
    set("boundary_blow_patch", "0, 4 cm");  // below the vent
    EXPECT_NO_THROW(read_case());
    set("boundary_blow_patch", "4 cm, 8 cm");
    set("plate_middle_openings", "3 cm, 4 cm");  // a way to the vent
    EXPECT_NO_THROW(read_case());
  }
}

TEST_F(WaysOut, ParticlesThatDisplaceGasInAPocketAreRefused) {
  divided("darcy");
  yaml(
      "boundary: {rain: {side: y_upper, kind: inlet, solids_fraction: 0.1, velocity: [0, -1], patch: [4 cm, 8 cm],"
      " order: 1}}");
  EXPECT_EQ(error_of_case().key, "boundary_rain_velocity");
}

TEST_F(WaysOut, ParticlesIntoAClosedPartNeedRoom) {
  divided("none");
  yaml(
      "end_time: 0.5\nboundary: {rain: {side: y_upper, kind: inlet, solids_fraction: 0.1, velocity: [0, -1],"
      " patch: [4 cm, 8 cm], order: 1}}");
  EXPECT_NO_THROW(read_case());  // 0.05 m of 0.65 * 0.08 m
  set("initial_fill_solids_fraction", "0.1");
  const InputError error = error_of_case();
  EXPECT_EQ(error.key, "boundary_rain_velocity");
  EXPECT_NE(error.expected.find("1.14 times the room"), std::string::npos) << error.what();
  set("boundary_rain_until", "0.4");
  EXPECT_NO_THROW(read_case());
  set("boundary_rain_until", "1");
  set("boundary_lid_side", "x_upper");
  set("boundary_lid_kind", "open");
  set("boundary_lid_from", "0.3");
  set("boundary_lid_order", "1");
  EXPECT_NO_THROW(read_case());
}

TEST_F(WaysOut, WhatLetsGasOutAloneIsNoWayOutForParticles) {
  static constexpr BoundaryKind sieve{"sieve",         "of this test",  SolidsNormal::wall,  SolidsTangential::free,
                                      Scalars::closed, GasNormal::open, GasTangential::free, GasPressure::prescribed};
  static constexpr BoundaryKind chute{"chute",          "of this test",  SolidsNormal::open,  SolidsTangential::free,
                                      Scalars::outflow, GasNormal::wall, GasTangential::free, GasPressure::free};
  Catalogue catalogue;
  catalogue.further_kinds = {&sieve, &chute};
  divided("none");
  yaml(
      "end_time: 0.5\nboundary: {rain: {side: y_upper, kind: inlet, solids_fraction: 0.1, velocity: [0, -1],"
      " patch: [4 cm, 8 cm], order: 1}, lid: {side: x_upper, kind: sieve, order: 1}}");
  set("initial_fill_solids_fraction", "0.1");
  EXPECT_THROW(scree::read_case(input, catalogue), InputError);
  set("boundary_lid_kind", "chute");
  EXPECT_NO_THROW(scree::read_case(input, catalogue));
  set("gas", "darcy");  // now it is the gas that has to find its way
  EXPECT_THROW(scree::read_case(input, catalogue), InputError);
  set("boundary_lid_kind", "sieve");
  EXPECT_NO_THROW(scree::read_case(input, catalogue));
}

TEST_F(WaysOut, OddNumbersGetARemarkAndSensibleOnesNone) {
  const auto remarks = [this](std::initializer_list<std::pair<const char*, const char*>> settings) {
    clear();
    small_bin();
    for (const auto& [key, value] : settings) set(key, value);
    return read_case();
  };
  EXPECT_TRUE(remarks({}).remarks.empty());
  EXPECT_TRUE(remarks({{"particle_diameter", "1.5 cm"}, {"periodic", "none"}}).remarks.empty());  // over a cell
  const Case forgot_mm = remarks({{"particle_diameter", "0.5"}});
  EXPECT_TRUE(has_remark(forgot_mm, "particle_diameter = 0.5 m is odd: the box along x is 0.08 m, 0.16 particle"));
  EXPECT_TRUE(has_remark(forgot_mm, "particle_diameter = 0.5 m is odd: the box along y"));

  clear();
  weightless_bin();
  EXPECT_TRUE(has_remark(read_case(), "gravity is not given: it is 0; \"gravity: 0, -9.81\" is that of the earth"));
  set("gravity", "0, 0");
  EXPECT_TRUE(read_case().remarks.empty());

  const std::pair<const char*, const char*> axis{"plate_p_axis", "y"}, position{"plate_p_position", "2 cm"},
      d{"particle_diameter", "4 mm"};
  EXPECT_TRUE(has_remark(remarks({axis, position, d, {"plate_p_openings", "3 cm, 4 cm"}}),
                         "plate_p_openings is odd: it leaves a width of 0.01 m, 2.5 particle diameters"));
  EXPECT_TRUE(remarks({axis, position, d, {"plate_p_openings", "3 cm, 5 cm"}}).remarks.empty());
  EXPECT_TRUE(has_remark(remarks({axis, position, {"particle_diameter", "4.1 mm"}, {"plate_p_openings", "0, 1 cm"}}),
                         "plate_p_openings is odd: it leaves a width of 0.02 m, 4.88"));  // with its mirror image
}

TEST_F(WaysOut, OutletUnderABedNeedsNoRemark) {
  small_bin();
  yaml("boundary: {floor: {kind: wall_free_slip}, slit: {side: y_lower, kind: open, patch: [0, 2 cm], order: 1}}");
  EXPECT_TRUE(read_case().remarks.empty());
}

}  // namespace
}  // namespace scree
