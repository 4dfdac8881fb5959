/// Orderings of unknowns for factorisations, beside those of PETSc.
#pragma once

#include <petscmat.h>

namespace scree {

/// Registers, for -sub_pc_factor_mat_ordering_type and the like:
///
/// "last_node_first": nodes from the last to the first, the unknowns of each in their order. The upper faces of a cell
/// belong to the nodes behind it, so that u on all faces of a cell is eliminated before its p_g, whose row has no
/// diagonal until then.
///
/// "metis": nested dissection by METIS of the graph of single unknowns.
PetscErrorCode register_orderings();

}  // namespace scree
