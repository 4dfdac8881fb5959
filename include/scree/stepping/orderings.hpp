/// Orderings of unknowns for factorisations, beside those of PETSc.
#pragma once

#include <petscmat.h>

namespace scree {

/// Registers "last_node_first" (for -sub_pc_factor_mat_ordering_type and the like): nodes from the last to the first,
/// the unknowns of each in their order. The upper faces of a cell belong to the nodes behind it, so that u on all faces
/// of a cell is eliminated before its p_g, whose row has no diagonal until then.
PetscErrorCode register_orderings();

}  // namespace scree
