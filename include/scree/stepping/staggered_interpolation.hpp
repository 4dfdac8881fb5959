/// A grid of staggered unknowns with half the cells, and the interpolation from it.
#pragma once

#include <petscdmda.h>

#include <array>
#include <vector>

#include "scree/grid/index.hpp"

namespace scree {

/// The nodes of a rank on one of the grids of a multigrid. As in Lattice, an axis that is not periodic has one node
/// more than cells.
struct NodeGrid {
  explicit NodeGrid(DM dm);

  int dim = 1;
  Index nodes{{1, 1, 1}}, first, count{{1, 1, 1}};  ///< all of them; the owned ones
  std::array<bool, max_dim> periodic{};
  std::array<std::vector<PetscInt>, max_dim> owned;  ///< nodes of each part of the axis

  int cells(int axis) const { return nodes[axis] - (periodic[axis] ? 0 : 1); }
};

/// Where a place along an axis of the fine grid has its value from: up to two places of the coarse one.
struct AxisWeights {
  int count = 1;
  std::array<int, 2> place{};
  std::array<double, 2> weight{{1, 0}};
};

/// Of cell i of an axis of `cells` cells that is halved: the coarse cell it lies in; of padding the padding.
AxisWeights halved_cell(int i, int cells);
/// Of face i: linear between the faces of the coarse cells.
AxisWeights halved_face(int i, int cells);

/// Makes the DMDA of a grid with half the cells along each axis that can be halved, for as many unknowns a node as
/// `unknowns`, and with its nodes on the ranks where they were. *coarse is a null pointer where no axis can be.
PetscErrorCode create_coarse_dm(DM fine, PetscInt unknowns, DM* coarse);

/// The interpolation from `coarse` to `fine` for matrices of nodes with `face_axis.size()` unknowns each, face_axis
/// being the axis whose faces an unknown is at, or -1. fixed: for each row of `fine` on this rank, whether it fixes its
/// unknown; replaced by that of the coarse grid.
PetscErrorCode create_interpolation(DM fine, DM coarse, const std::vector<PetscInt>& face_axis,
                                    std::vector<char>& fixed, Mat* interpolation);

}  // namespace scree
