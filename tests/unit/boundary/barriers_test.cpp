#include "scree/boundary/barriers.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "../../support/sample_problem.hpp"

namespace scree {
namespace {

using test::condition;
using test::side;

Condition named(const std::string& name, BoundaryKind kind = BoundaryKind::wall_free_slip) {
  Condition result = condition(kind);
  result.name = name;
  return result;
}

/// Lattice and conditions of a box whose cells are 1 x 1, seen by one rank.
struct Scene {
  DM dm = nullptr;
  std::unique_ptr<Lattice> lattice;
  std::unique_ptr<Barriers> barriers;

  Scene(Box box, const std::vector<Segment>& segments, const std::vector<Plate>& plates, double time = 0) {
    test::check(create_dm(PETSC_COMM_SELF, box, 1, halo, &dm));
    lattice = std::make_unique<Lattice>(box, dm);
    barriers = std::make_unique<Barriers>(*lattice, segments, plates, time);
  }
  ~Scene() { (void)DMDestroy(&dm); }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  /// Name of the condition at the lower `axis` face of cell (i, j, k), "-" for none.
  std::string at(int axis, int i, int j, int k = 0) const {
    const Index I{{i, j, k}};
    return barriers->at(axis, I) ? barriers->condition(axis, I).name : "-";
  }
  /// The names along a row or column of faces, one letter each.
  std::string along(int axis, int first, int last, int fixed) const {
    std::string names;
    for (int m = first; m <= last; ++m) names += axis == 0 ? at(0, fixed, m) : at(1, m, fixed);
    return names;
  }
};

Box unit_box(int dim, std::array<int, max_dim> cells) { return test::uniform_box(dim, cells, 1.0); }

Segment part(Segment segment, int axis, double lower, double upper) {
  segment.patch.lower[axis] = lower;
  segment.patch.upper[axis] = upper;
  return segment;
}

TEST(Barriers, SidesCarryTheirConditionsAndNothingElseDoes) {
  const Scene scene(
      unit_box(2, {3, 4, 0}),
      {side(0, false, named("l")), side(0, true, named("r")), side(1, false, named("b")), side(1, true, named("t"))},
      {});
  EXPECT_EQ(scene.along(0, 0, 3, 0), "llll");
  EXPECT_EQ(scene.along(0, 0, 3, 3), "rrrr");
  EXPECT_EQ(scene.along(1, 0, 2, 0), "bbb");
  EXPECT_EQ(scene.along(1, 0, 2, 4), "ttt");
  EXPECT_EQ(scene.along(0, 0, 3, 1), "----");
  EXPECT_EQ(scene.along(1, 0, 2, 2), "---");
  EXPECT_EQ(scene.at(0, 0, 4), "-") << "x face of the padding above the upper side";
  EXPECT_EQ(scene.at(0, 0, -1), "-");
}

TEST(Barriers, LaterSegmentHoldsWhereTheyOverlap) {
  const Scene scene(unit_box(2, {6, 2, 0}),
                    {side(1, false, named("a")), part(side(1, false, named("b")), 0, 1.0, 5.0),
                     part(side(1, false, named("c")), 0, 2.0, 3.0)},
                    {});
  EXPECT_EQ(scene.along(1, 0, 5, 0), "abcbba") << "a face belongs to a patch if its centre does";
}

TEST(Barriers, TimeWindowsAreClosedBelowAndOpenAbove) {
  Condition pulse = named("p");
  pulse.from = 1;
  pulse.until = 2;
  const std::vector<Segment> segments{side(0, false, named("a")), side(0, false, pulse), side(0, true, named("r"))};
  for (const auto& [time, expected] :
       {std::pair(0.0, "a"), std::pair(1.0, "p"), std::pair(1.9, "p"), std::pair(2.0, "a")}) {
    const Scene scene(unit_box(1, {4, 0, 0}), segments, {}, time);
    EXPECT_EQ(scene.at(0, 0, 0), expected) << "time " << time;
  }
}

TEST(Barriers, PlateLeavesItsOpeningsOpen) {
  Plate plate;
  plate.condition = named("p");
  plate.axis = 1;
  plate.position = 2;
  plate.span.lower[0] = 1;  // cells 1 ... 6
  plate.span.upper[0] = 7;
  Patch opening;
  opening.lower[0] = 2;
  opening.upper[0] = 4;
  plate.openings.push_back(opening);
  const Scene scene(unit_box(2, {8, 4, 0}), {side(0, false, named("l")), side(1, false, named("b"))}, {plate});
  EXPECT_EQ(scene.along(1, 0, 7, 2), "-p--ppp-");
  EXPECT_EQ(scene.along(1, 0, 7, 1), "--------");
  EXPECT_EQ(scene.along(1, 0, 7, 3), "--------");
  EXPECT_EQ(scene.along(0, 0, 3, 3), "----") << "a plate has no faces along itself";
  EXPECT_TRUE(scene.barriers->wall(1, {{1, 2, 0}}));
}

TEST(Barriers, PlateInThreeDimensionsHasARectangularOpening) {
  Plate plate;
  plate.condition = named("p");
  plate.axis = 2;
  plate.position = 1;
  Patch opening;
  opening.lower = {1, 2, 0};
  opening.upper = {3, 3, 0};
  plate.openings.push_back(opening);
  const Scene scene(unit_box(3, {4, 4, 3}), {}, {plate});
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const bool open = i >= 1 && i < 3 && j == 2;
      EXPECT_EQ(scene.at(2, i, j, 1), open ? "-" : "p") << "cell (" << i << ", " << j << ')';
    }
}

TEST(Barriers, SegmentsAndPlatesWrapAlongAPeriodicAxis) {
  Box box = unit_box(2, {6, 4, 0});
  box.periodic = {true, false, false};
  Plate plate;
  plate.condition = named("p");
  plate.axis = 1;
  plate.position = 2;
  plate.span.upper[0] = 2;
  const Scene scene(box,
                    {part(side(1, false, named("a")), 0, 0.0, 3.0), part(side(1, false, named("b")), 0, 3.0, 6.0),
                     side(1, true, named("t"))},
                    {plate});
  EXPECT_EQ(scene.along(1, -3, 8, 0), "bbbaaabbbaaa") << "ghosts see what their images are";
  EXPECT_EQ(scene.along(1, -3, 8, 2), "---pp----pp-");
}

TEST(Barriers, PlateAcrossAPeriodicAxisIsSeenFromBothEnds) {
  for (const int position : {1, 3, 5}) {
    Box box = unit_box(2, {6, 3, 0});
    box.periodic = {true, false, false};
    Plate plate;
    plate.condition = named("p");
    plate.axis = 0;
    plate.position = position;
    const Scene scene(box, {}, {plate});
    for (int i = -halo; i < 6 + halo; ++i)
      EXPECT_EQ(scene.at(0, i, 1), (i + 6) % 6 == position ? "p" : "-")
          << "plate at face " << position << ", seen at face " << i;
  }
}

TEST(Barriers, WallsAreTheKindsThatLetNoParticlesThrough) {
  struct {
    BoundaryKind kind;
    bool wall, stops_gas, brings_gas;
  } const expected[] = {{BoundaryKind::wall_johnson_jackson, true, true, false},
                        {BoundaryKind::wall_free_slip, true, true, false},
                        {BoundaryKind::wall_no_slip, true, true, false},
                        {BoundaryKind::symmetry, true, true, false},
                        {BoundaryKind::open, false, false, false},
                        {BoundaryKind::inlet, false, false, true},
                        {BoundaryKind::gas_inlet, true, false, true}};
  for (const auto& [kind, wall, stops, brings] : expected) {
    SCOPED_TRACE("kind " + std::string(kind.name));
    EXPECT_EQ(kind.stops_solids(), wall);
    EXPECT_EQ(kind.stops_gas(), stops);
    EXPECT_EQ(kind.brings_gas(), brings);
    const Scene scene(unit_box(1, {4, 0, 0}), {side(0, false, condition(kind))}, {});
    EXPECT_EQ(scene.barriers->wall(0, {{0, 0, 0}}), wall);
    EXPECT_FALSE(scene.barriers->wall(0, {{1, 0, 0}}));
  }
}

TEST(Barriers, NearMeansWithinTheHalo) {
  const Scene scene(unit_box(1, {12, 0, 0}), {side(0, false, named("l")), side(0, true, named("r"))}, {});
  for (int i = 0; i <= 12; ++i)
    EXPECT_EQ(scene.barriers->near({{i, 0, 0}}), i <= halo || i >= 12 - halo) << "node " << i;
}

}  // namespace
}  // namespace scree
