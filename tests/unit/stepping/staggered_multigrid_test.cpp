#include "scree/stepping/staggered_multigrid.hpp"

#include <gtest/gtest.h>
#include <petscksp.h>

#include "../../support/sample_problem.hpp"
#include "scree/stepping/staggered_interpolation.hpp"

namespace scree::test {
namespace {

/// A grid of so many cells an axis for `unknowns` a node, spread over the ranks, and the one with half the cells along
/// each.
struct TwoGrids {
  TwoGrids(int dim, std::array<int, max_dim> cells, bool periodic, int unknowns) {
    Box box = uniform_box(dim, cells);
    box.periodic[0] = periodic;
    check(create_dm(PETSC_COMM_WORLD, box, unknowns, 2, &fine));
    const NodeGrid grid(fine);
    axes = coarsened(grid, 2.5 * (grid.faces[0][1] - grid.faces[0][0]));
    check(create_coarse_dm(fine, axes, unknowns, &coarse));
  }
  ~TwoGrids() {
    (void)DMDestroy(&fine);
    (void)DMDestroy(&coarse);
  }
  TwoGrids(const TwoGrids&) = delete;
  TwoGrids& operator=(const TwoGrids&) = delete;
  DM fine = nullptr, coarse = nullptr;
  std::array<CoarseAxis, max_dim> axes{CoarseAxis({0, 1}, 0), CoarseAxis({0, 1}, 0), CoarseAxis({0, 1}, 0)};
};

/// Entries of the vector of interpolated values, of which `values` are those of the coarse grid.
std::vector<double> interpolated(Mat P, double (*values)(PetscInt)) {
  Vec from, to;
  PetscInt first, end;
  const PetscScalar* found;
  check(MatCreateVecs(P, &from, &to));
  check(VecGetOwnershipRange(from, &first, &end));
  for (PetscInt k = first; k < end; ++k) check(VecSetValue(from, k, values(k), INSERT_VALUES));
  check(VecAssemblyBegin(from));
  check(VecAssemblyEnd(from));
  check(MatMult(P, from, to));
  check(VecGetLocalSize(to, &end));
  check(VecGetArrayRead(to, &found));
  std::vector<double> result(found, found + end);
  check(VecRestoreArrayRead(to, &found));
  check(VecDestroy(&from));
  check(VecDestroy(&to));
  return result;
}

TEST(StaggeredInterpolation, KeepsConstants) {
  for (const bool periodic : {false, true})
    for (const int dim : {2, 3}) {
      std::vector<PetscInt> axes{-1};
      for (int axis = 0; axis < dim; ++axis) axes.push_back(axis);
      TwoGrids grids(dim, {periodic ? 12 : 13, 7, 6}, periodic, static_cast<int>(axes.size()));
      const NodeGrid coarse(grids.coarse);
      EXPECT_EQ(coarse.cells(0), periodic ? 6 : 7);
      EXPECT_EQ(coarse.cells(1), 4);
      const NodeGrid fine(grids.fine);
      std::vector<char> fixed(static_cast<std::size_t>(fine.count[0] * fine.count[1] * fine.count[2]) * axes.size(), 0);
      Mat P;
      check(create_interpolation(grids.fine, grids.coarse, grids.axes, axes, fixed, &P));
      for (const double one : interpolated(P, [](PetscInt) { return 1.0; })) EXPECT_NEAR(one, 1, 1e-14);
      EXPECT_EQ(std::count(fixed.begin(), fixed.end(), 1), 0);
      check(MatDestroy(&P));
    }
}

TEST(StaggeredInterpolation, LeavesOutWhatIsFixed) {
  TwoGrids grids(2, {8, 8, 1}, false, 3);
  const NodeGrid fine(grids.fine);
  std::vector<char> fixed;
  for_each_node(fine.first, fine.count, [&](const Index& I) {
    const bool padding_x = I[0] == 8, padding_y = I[1] == 8;
    fixed.push_back(padding_x || padding_y);
    fixed.push_back(I[0] == 0 || padding_x || padding_y);  // v_x: both sides are walls
    fixed.push_back(padding_x);                            // v_y: open sides
  });
  const auto before = fixed;
  Mat P;
  check(create_interpolation(grids.fine, grids.coarse, grids.axes, {-1, 0, 1}, fixed, &P));
  const auto ones = interpolated(P, [](PetscInt) { return 1.0; });
  std::size_t row = 0;
  for_each_node(fine.first, fine.count, [&](const Index& I) {
    for (int c = 0; c < 3; ++c, ++row) {
      if (before[row]) continue;
      const bool beside_wall = c == 1 && (I[0] == 1 || I[0] == 7);
      EXPECT_NEAR(ones[row], beside_wall ? 0.5 : 1, 1e-14) << c << ' ' << I[0] << ' ' << I[1];
    }
  });
  row = 0;
  const NodeGrid coarse(grids.coarse);
  for_each_node(coarse.first, coarse.count, [&](const Index& I) {
    const bool padding_x = I[0] == 4, padding_y = I[1] == 4;
    EXPECT_EQ(fixed[row++], padding_x || padding_y);
    EXPECT_EQ(fixed[row++], I[0] == 0 || padding_x || padding_y);
    EXPECT_EQ(fixed[row++], padding_x);
  });
  check(MatDestroy(&P));
}

/// Iterations for the five-point Laplacian at cells, with rows of padding.
PetscInt laplacian_iterations(int cells) {
  Box box = uniform_box(2, {cells, cells, 1});
  DM dm;
  Mat A;
  Vec x, b;
  KSP ksp;
  PC pc;
  PetscInt iterations;
  check(create_dm(PETSC_COMM_WORLD, box, 1, 1, &dm));
  check(DMSetMatrixPreallocateOnly(dm, PETSC_TRUE));  // rows of padding are to have their diagonal alone
  check(DMCreateMatrix(dm, &A));
  const NodeGrid grid(dm);
  for_each_node(grid.first, grid.count, [&](const Index& I) {
    const auto at = [](const Index& J) { return MatStencil{0, J[1], J[0], 0}; };
    const auto inside = [&](const Index& J) { return J[0] >= 0 && J[0] < cells && J[1] >= 0 && J[1] < cells; };
    const MatStencil row = at(I);
    double diagonal = inside(I) ? 0 : 1;
    for (int axis = 0; axis < 2 && inside(I); ++axis)
      for (const int step : {-1, 1}) {
        const Index J = I + step * unit(axis);
        const MatStencil column = at(J);
        const double entry = -1;
        diagonal += inside(J) ? 1 : 2;
        if (inside(J)) check(MatSetValuesStencil(A, 1, &row, 1, &column, &entry, INSERT_VALUES));
      }
    check(MatSetValuesStencil(A, 1, &row, 1, &row, &diagonal, INSERT_VALUES));
  });
  check(MatAssemblyBegin(A, MAT_FINAL_ASSEMBLY));
  check(MatAssemblyEnd(A, MAT_FINAL_ASSEMBLY));
  check(MatCreateVecs(A, &x, &b));
  check(VecSet(b, 1));
  check(KSPCreate(PETSC_COMM_WORLD, &ksp));
  check(KSPSetOperators(ksp, A, A));
  check(KSPSetType(ksp, KSPFGMRES));
  check(KSPSetTolerances(ksp, 1e-8, PETSC_DEFAULT, PETSC_DEFAULT, 100));
  check(KSPSetDM(ksp, dm));
  check(KSPSetDMActive(ksp, PETSC_FALSE));
  check(KSPGetPC(ksp, &pc));
  check(PCSetType(pc, "staggered"));
  check(KSPSolve(ksp, b, x));
  check(KSPGetIterationNumber(ksp, &iterations));
  check(KSPDestroy(&ksp));
  check(MatDestroy(&A));
  check(VecDestroy(&x));
  check(VecDestroy(&b));
  check(DMDestroy(&dm));
  return iterations;
}

/// What lives at cells is not linear between coarse cells, so that a few iterations more are to be expected of cells;
/// ILU alone takes four times as many on the finer grid.
TEST(StaggeredMultigrid, TakesFewIterationsOnFineGridsToo) {
  check(register_staggered_multigrid());
  check(PetscOptionsSetValue(nullptr, "-pc_staggered_coarse_eq_limit", "100"));
  EXPECT_LE(laplacian_iterations(16), 12);
  EXPECT_LE(laplacian_iterations(64), 16);
  check(PetscOptionsClearValue(nullptr, "-pc_staggered_coarse_eq_limit"));
}

}  // namespace
}  // namespace scree::test
