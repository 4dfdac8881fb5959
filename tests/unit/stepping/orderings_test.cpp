#include "scree/stepping/orderings.hpp"

#include <gtest/gtest.h>

#include "../../support/sample_problem.hpp"
#include "scree/stepping/grid_of_nodes.hpp"

namespace scree::test {
namespace {

/// The rows of a grid of (nodes) x 2 nodes with two unknowns each, in the order of `type`.
std::vector<PetscInt> ordering(const char* type, bool knows_grid, int nodes = 3) {
  DM dm;
  Mat A;
  IS rows, columns;
  const PetscInt* order;
  check(register_orderings());
  check(create_dm(PETSC_COMM_SELF, uniform_box(2, {nodes - 1, 1, 1}), 2, 1, &dm));
  check(DMCreateMatrix(dm, &A));
  if (knows_grid) check(set_grid_of_nodes(A, dm));
  check(MatGetOrdering(A, type, &rows, &columns));
  check(ISGetIndices(rows, &order));
  std::vector<PetscInt> found(order, order + 4 * nodes);
  check(ISRestoreIndices(rows, &order));
  check(ISDestroy(&rows));
  check(ISDestroy(&columns));
  check(MatDestroy(&A));
  check(DMDestroy(&dm));
  return found;
}

TEST(Orderings, TakeNodesByColumnsFromTheLast) {
  EXPECT_EQ(ordering("columns_y", true), (std::vector<PetscInt>{10, 11, 4, 5, 8, 9, 2, 3, 6, 7, 0, 1}));
  EXPECT_EQ(ordering("columns_x", true), (std::vector<PetscInt>{10, 11, 8, 9, 6, 7, 4, 5, 2, 3, 0, 1}));
}

TEST(Orderings, WithoutAGridTakeTheRowsFromTheLast) {
  EXPECT_EQ(ordering("columns_y", false), ordering("columns_x", true));
}

/// Of 2 x 2 nodes, each of which sees all others, PETSc factors rows 0 to 4 and 5 to 7 together.
TEST(Orderings, LeaveTogetherWhatPetscFactorsTogether) {
  for (const char* type : {"columns_x", "columns_y"})
    EXPECT_EQ(ordering(type, true, 2), (std::vector<PetscInt>{5, 6, 7, 0, 1, 2, 3, 4})) << type;
}

TEST(Orderings, AreKnownToTheBlockOfARank) {
  DM dm, found;
  Mat A, own;
  check(create_dm(PETSC_COMM_WORLD, uniform_box(2, {7, 9, 1}), 2, 1, &dm));
  check(DMCreateMatrix(dm, &A));
  check(set_grid_of_nodes(A, dm));
  check(MatGetDiagonalBlock(A, &own));
  check(get_grid_of_nodes(own, &found));
  EXPECT_EQ(found, dm);
  check(MatDestroy(&A));
  check(DMDestroy(&dm));
}

}  // namespace
}  // namespace scree::test
