#include "scree/grid/rank_split.hpp"

#include <gtest/gtest.h>
#include <petscdmda.h>

#include <array>

namespace scree::test {
namespace {

SharedGrid grid(std::array<int, max_dim> nodes, int width = 2) {
  SharedGrid result;
  result.nodes = nodes;
  result.stencil_width = width;
  return result;
}

TEST(RankSplit, RefusesPartsNarrowerThanTheStencil) {
  EXPECT_FALSE(split_over_ranks(grid({11, 11, 1}), 7));
  EXPECT_EQ(most_ranks(grid({11, 11, 1}), 7), 6);
  EXPECT_FALSE(split_over_ranks(grid({3, 3, 1}), 2));
  EXPECT_EQ(most_ranks(grid({3, 3, 1}), 2), 1);
  EXPECT_FALSE(split_over_ranks(grid({5, 9, 1}), 5));
  EXPECT_EQ(most_ranks(grid({5, 9, 1}), 5), 4);
}

TEST(RankSplit, TakesAnotherThanPetscsWhereThatIsTooNarrow) {
  // PETSc: 2 x 2, with parts of two nodes along y.
  EXPECT_EQ(*split_over_ranks(grid({12, 5, 1}, 3), 4), (RankSplit{4, 1, 1}));
}

TEST(RankSplit, KeepsToWhatTheUserAsksFor) {
  SharedGrid shared = grid({20, 20, 1});
  shared.given = {4, 0, 0};
  EXPECT_EQ(*split_over_ranks(shared, 8), (RankSplit{4, 2, 1}));
  EXPECT_FALSE(split_over_ranks(shared, 6));
}

TEST(RankSplit, NeedsAPeriodicAxisAsWideAsTheStencil) {
  SharedGrid shared = grid({1, 8, 1});
  EXPECT_TRUE(split_over_ranks(shared, 1));
  shared.periodic[0] = true;
  EXPECT_FALSE(split_over_ranks(shared, 1));
  EXPECT_EQ(most_ranks(shared, 4), 0);
}

/// On grids large enough for all, so that numbers and files of earlier versions stay as they are.
TEST(RankSplit, IsPetscsWhereThatWorks) {
  int ranks;
  MPI_Comm_size(PETSC_COMM_WORLD, &ranks);
  for (const std::array<int, max_dim> nodes :
       {std::array{40, 1, 1}, {40, 30, 1}, {30, 400, 1}, {400, 30, 1}, {20, 30, 50}, {50, 20, 30}, {30, 50, 20}}) {
    const int dim = nodes[1] == 1 ? 1 : nodes[2] == 1 ? 2 : 3;
    DM dm;
    ASSERT_EQ(DMDACreate(PETSC_COMM_WORLD, &dm), 0);
    ASSERT_EQ(DMSetDimension(dm, dim), 0);
    ASSERT_EQ(DMDASetSizes(dm, nodes[0], nodes[1], nodes[2]), 0);
    ASSERT_EQ(DMDASetStencilWidth(dm, 1), 0);
    ASSERT_EQ(DMDASetDof(dm, 1), 0);
    ASSERT_EQ(DMSetUp(dm), 0);
    PetscInt m, n, p;
    ASSERT_EQ(DMDAGetInfo(dm, nullptr, nullptr, nullptr, nullptr, &m, &n, &p, nullptr, nullptr, nullptr, nullptr,
                          nullptr, nullptr),
              0);
    EXPECT_EQ(*split_over_ranks(grid(nodes), ranks), (RankSplit{int(m), int(n), int(p)}));
    EXPECT_EQ(DMDestroy(&dm), 0);
  }
}

}  // namespace
}  // namespace scree::test
