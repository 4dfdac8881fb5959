/// What grid the rows of a matrix belong to, for those who see the matrix alone.
#pragma once

#include <petscdmda.h>
#include <petscmat.h>

namespace scree {

/// Lets a matrix, and the block of it that couples the unknowns of a rank to one another, know the grid whose nodes its
/// blocks of rows are. Factors and smoothers of a rank are handed that block.
PetscErrorCode set_grid_of_nodes(Mat matrix, DM dm);
/// A null pointer where the matrix knows none. The caller does not destroy it.
PetscErrorCode get_grid_of_nodes(Mat matrix, DM* dm);

}  // namespace scree
