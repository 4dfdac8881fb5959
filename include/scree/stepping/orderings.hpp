/// Orderings of unknowns for factorisations, beside those of PETSc.
#pragma once

#include <petscmat.h>

namespace scree {

/// Registers, for -sub_pc_factor_mat_ordering_type and the like:
///
/// "columns_x", "columns_y", "columns_z": nodes from the last to the first, column by column along this axis, the
/// unknowns of each node in their order. The upper faces of a cell belong to the nodes behind it, so that the
/// velocities on all faces of a cell are eliminated before its nu, and before its p_g, whose row has no diagonal until
/// then. Columns are to stand along gravity: an incomplete factor then carries the weight of a column down to its foot.
/// Where the matrix does not know its grid, see grid_of_nodes.hpp, nodes go in the order of their rows.
///
/// "metis": nested dissection by METIS of the graph of single unknowns.
PetscErrorCode register_orderings();

}  // namespace scree
