#include "scree/stepping/orderings.hpp"

#include <gtest/gtest.h>

#include "../../support/sample_problem.hpp"
#include "scree/stepping/grid_of_nodes.hpp"

namespace scree::test {
namespace {

/// The rows of a grid of 2 x 3 nodes with two unknowns each, in the order of `type`.
std::vector<PetscInt> ordering(const char* type, bool knows_grid) {
  DM dm;
  Mat A;
  IS rows, columns;
  const PetscInt* order;
  check(register_orderings());
  check(create_dm(PETSC_COMM_SELF, uniform_box(2, {1, 2, 1}), 2, 1, &dm));
  check(DMCreateMatrix(dm, &A));
  if (knows_grid) check(set_grid_of_nodes(A, dm));
  check(MatGetOrdering(A, type, &rows, &columns));
  check(ISGetIndices(rows, &order));
  std::vector<PetscInt> found(order, order + 12);
  check(ISRestoreIndices(rows, &order));
  check(ISDestroy(&rows));
  check(ISDestroy(&columns));
  check(MatDestroy(&A));
  check(DMDestroy(&dm));
  return found;
}

TEST(Orderings, TakeNodesByColumnsFromTheLast) {
  EXPECT_EQ(ordering("columns_y", true), (std::vector<PetscInt>{10, 11, 6, 7, 2, 3, 8, 9, 4, 5, 0, 1}));
  EXPECT_EQ(ordering("columns_x", true), (std::vector<PetscInt>{10, 11, 8, 9, 6, 7, 4, 5, 2, 3, 0, 1}));
}

TEST(Orderings, WithoutAGridTakeTheRowsFromTheLast) {
  EXPECT_EQ(ordering("columns_y", false), ordering("columns_x", true));
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
