/// Lattice on the DMDA that the solver uses, on any number of ranks.
#include <gtest/gtest.h>

#include <memory>

#include "../../support/sample_problem.hpp"

namespace scree {
namespace {

/// A lattice and its DMDA.
struct Grid {
  DM dm = nullptr;
  std::unique_ptr<Lattice> lattice;
  Grid(const Box& box, int unknowns, int stencil_width) {
    test::check(create_dm(PETSC_COMM_WORLD, box, unknowns, stencil_width, &dm));
    lattice = std::make_unique<Lattice>(box, dm);
  }
  ~Grid() { (void)DMDestroy(&dm); }
  Grid(const Grid&) = delete;
  Grid& operator=(const Grid&) = delete;
};

int sum_over_ranks(int mine) {
  int all = 0;
  MPI_Allreduce(&mine, &all, 1, MPI_INT, MPI_SUM, PETSC_COMM_WORLD);
  return all;
}

struct Counts {
  int dim;
  std::array<bool, max_dim> periodic;
  int nodes, cells;
  std::array<int, max_dim> faces;  ///< nodes whose lower face belongs to the box, per axis
};

TEST(Lattice, CountsNodesCellsAndFacesOnce) {
  const Counts rows[] = {
      {1, {false, false, false}, 7, 6, {7, 0, 0}},       {1, {true, false, false}, 6, 6, {6, 0, 0}},
      {2, {false, false, false}, 35, 24, {28, 30, 0}},   {2, {true, false, false}, 30, 24, {24, 30, 0}},
      {3, {false, false, false}, 140, 72, {84, 90, 96}}, {3, {false, true, false}, 112, 72, {84, 72, 96}},
  };
  for (const Counts& row : rows) {
    Box box = test::uniform_box(row.dim, {6, 4, 3});
    box.periodic = row.periodic;
    const Grid grid(box, 3, 2);
    const Lattice& lattice = *grid.lattice;
    int nodes = 0, cells = 0;
    std::array<int, max_dim> faces{0, 0, 0};
    double volume = 0;
    for_each_node(lattice.owned_first, lattice.owned_count, [&](const Index& I) {
      EXPECT_TRUE(lattice.is_owned(I) && lattice.is_ghosted(I));
      ++nodes;
      cells += lattice.inside(I);
      if (lattice.inside(I)) volume += lattice.volume(I);
      for (int axis = 0; axis < row.dim; ++axis) faces[axis] += lattice.is_face(axis, I);
    });
    SCOPED_TRACE(std::to_string(row.dim) + "d, periodic " + std::to_string(row.periodic[0]) +
                 std::to_string(row.periodic[1]));
    EXPECT_EQ(sum_over_ranks(nodes), row.nodes);
    EXPECT_EQ(sum_over_ranks(nodes), sum_over_ranks(lattice.owned_size()));
    EXPECT_EQ(sum_over_ranks(cells), row.cells);
    for (int axis = 0; axis < row.dim; ++axis)
      EXPECT_EQ(sum_over_ranks(faces[axis]), row.faces[axis]) << "axis " << axis;
    double total = 0;
    MPI_Allreduce(&volume, &total, 1, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
    EXPECT_NEAR(total, row.cells * std::pow(2e-3, row.dim), 1e-12 * total);
  }
}

TEST(Lattice, NumbersNodesAsTheDmdaDoes) {
  Box box = test::graded_box(2, {6, 4, 0});
  box.periodic = {true, false, false};
  const Grid grid(box, 2, 2);
  const Lattice& lattice = *grid.lattice;
  Vec global, local;
  double* x;
  test::check(DMGetGlobalVector(grid.dm, &global));
  test::check(DMGetLocalVector(grid.dm, &local));
  test::check(VecGetArray(global, &x));
  const auto code = [](const Index& I, int component) { return 100 * component + 10 * I[1] + I[0]; };
  for_each_node(lattice.owned_first, lattice.owned_count, [&](const Index& I) {
    for (int c = 0; c < 2; ++c) x[lattice.owned(I) * 2 + c] = code(I, c);
  });
  test::check(VecRestoreArray(global, &x));
  test::check(VecSet(local, -1));
  test::check(DMGlobalToLocal(grid.dm, global, INSERT_VALUES, local));
  test::check(VecGetArray(local, &x));
  for_each_node(lattice.ghosted_first, lattice.ghosted_count, [&](const Index& I) {
    const bool beyond = I[1] < 0 || I[1] > 4;  // no node there: y is closed
    const Index wrapped{{(I[0] + 6) % 6, I[1], 0}};
    for (int c = 0; c < 2; ++c)
      EXPECT_EQ(x[lattice.ghosted(I) * 2 + c], beyond ? -1 : code(wrapped, c))
          << "node (" << I[0] << ", " << I[1] << "), component " << c;
  });
  test::check(VecRestoreArray(local, &x));
  test::check(DMRestoreLocalVector(grid.dm, &local));
  test::check(DMRestoreGlobalVector(grid.dm, &global));
}

TEST(Lattice, PeriodicAxesHaveNoOutside) {
  Box box = test::uniform_box(2, {6, 4, 0});
  box.periodic = {true, false, false};
  const Grid grid(box, 1, 2);
  const Lattice& lattice = *grid.lattice;
  EXPECT_TRUE(lattice.inside({{-1, 0, 0}}));
  EXPECT_TRUE(lattice.inside({{6, 3, 0}}));
  EXPECT_FALSE(lattice.inside({{2, -1, 0}}));
  EXPECT_FALSE(lattice.inside({{2, 4, 0}}));
  EXPECT_TRUE(lattice.is_face(1, {{2, 4, 0}})) << "the upper side";
  EXPECT_FALSE(lattice.is_face(0, {{2, 4, 0}})) << "padding beyond the upper side";
  EXPECT_FALSE(lattice.is_face(1, {{2, 5, 0}}));
}

}  // namespace
}  // namespace scree
