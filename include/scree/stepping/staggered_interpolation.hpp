/// A coarser grid of staggered unknowns, and the interpolation from it.
#pragma once

#include <petscdmda.h>

#include <array>
#include <vector>

#include "scree/grid/coarse_axis.hpp"
#include "scree/grid/index.hpp"

namespace scree {

/// The nodes of a rank on one of the grids of a multigrid. As in Lattice, an axis that is not periodic has one node
/// more than cells.
struct NodeGrid {
  explicit NodeGrid(DM dm);

  int dim = 1;
  Index nodes{{1, 1, 1}}, first, count{{1, 1, 1}};  ///< all of them; the owned ones
  std::array<bool, max_dim> periodic{};
  std::array<std::vector<double>, max_dim> faces;    ///< [m]
  std::array<std::vector<PetscInt>, max_dim> owned;  ///< nodes of each part of the axis

  int cells(int axis) const { return nodes[axis] - (periodic[axis] ? 0 : 1); }
};

/// Axes of the coarser grid: neighbours become one cell where together they are not wider than `widest`.
std::array<CoarseAxis, max_dim> coarsened(const NodeGrid& fine, double widest);

/// Makes the DMDA of the grid of `axes`, for as many unknowns a node as `unknowns`, and with its nodes on the ranks
/// where they were.
PetscErrorCode create_coarse_dm(DM fine, const std::array<CoarseAxis, max_dim>& axes, PetscInt unknowns, DM* coarse);

/// The interpolation from `coarse`, made of `fine` with `axes`, for matrices of nodes with `face_axis.size()` unknowns
/// each, face_axis being the axis whose faces an unknown is at, or -1. fixed: for each row of `fine` on this rank,
/// whether it fixes its unknown; replaced by that of the coarse grid.
PetscErrorCode create_interpolation(DM fine, DM coarse, const std::array<CoarseAxis, max_dim>& axes,
                                    const std::vector<PetscInt>& face_axis, std::vector<char>& fixed,
                                    Mat* interpolation);

}  // namespace scree
