/// The table of boundary kinds: each answer, in words.
#include "scree/boundary/kind.hpp"

#include <gtest/gtest.h>

#include <set>

namespace scree {
namespace {

TEST(BoundaryKind, NamesAreUnique) {
  std::set<std::string_view> names;
  for (const BoundaryKind* kind : standard_boundary_kinds) EXPECT_TRUE(names.insert(kind->name).second) << kind->name;
}

struct Row {
  BoundaryKind kind;
  bool stops_solids, brings_solids, lets_out, shears, stops_gas, brings_gas, open_to_gas, wall, moves;
};

TEST(BoundaryKind, AnswersOfTheTable) {
  const Row rows[] = {
      {BoundaryKind::wall_johnson_jackson, true, false, false, true, true, false, false, true, true},
      {BoundaryKind::wall_free_slip, true, false, false, false, true, false, false, true, true},
      {BoundaryKind::wall_no_slip, true, false, false, true, true, false, false, true, true},
      {BoundaryKind::symmetry, true, false, false, false, true, false, false, false, false},
      {BoundaryKind::open, false, false, true, false, false, false, true, false, false},
      {BoundaryKind::inlet, false, true, false, false, false, true, false, false, true},
      {BoundaryKind::gas_inlet, true, false, false, false, false, true, false, false, false},
  };
  ASSERT_EQ(std::size(rows), standard_boundary_kinds.size());
  for (const Row& row : rows) {
    SCOPED_TRACE(row.kind.name);
    EXPECT_EQ(row.kind.stops_solids(), row.stops_solids);
    EXPECT_EQ(row.kind.brings_solids(), row.brings_solids);
    EXPECT_EQ(row.kind.lets_solids_out(), row.lets_out);
    EXPECT_EQ(row.kind.shears_solids(), row.shears);
    EXPECT_EQ(row.kind.stops_gas(), row.stops_gas);
    EXPECT_EQ(row.kind.brings_gas(), row.brings_gas);
    EXPECT_EQ(row.kind.open_to_gas(), row.open_to_gas);
    EXPECT_EQ(row.kind.is_wall(), row.wall);
    EXPECT_EQ(row.kind.moves(), row.moves);
  }
}

TEST(BoundaryKind, AProgramMayAddARow) {
  constexpr BoundaryKind screen{"screen",
                                "stops particles, lets gas through",
                                SolidsNormal::wall,
                                SolidsTangential::johnson_jackson,
                                Scalars::closed,
                                GasNormal::open,
                                GasTangential::free,
                                GasPressure::prescribed};
  static_assert(screen.stops_solids() && !screen.stops_gas() && screen.open_to_gas() && !screen.is_wall());
  for (const BoundaryKind* kind : standard_boundary_kinds) EXPECT_NE(*kind, screen);
}

}  // namespace
}  // namespace scree
