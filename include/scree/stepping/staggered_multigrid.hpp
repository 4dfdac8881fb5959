/// Geometric multigrid for the unknowns of a staggered grid.
#pragma once

#include <petscpc.h>

namespace scree {

/// Registers the type "staggered" for -pc_type: one cycle of PCMG over coarser and coarser grids. From one to the
/// next, neighbours along an axis become one cell where both are not wider than a bound, see CoarseAxis; it doubles.
///
/// Interpolation: what is at faces is linear along their axis between the faces of the coarse grid; along the others,
/// and at cells, it has the value of the coarse cell. Linear there as well, velocities save a quarter of the iterations
/// and cost twice the set-up. The matrices of the coarse grids are those of Galerkin, P^T A P. Rows that fix an unknown
/// (walls, padding) take no part: without that corrections would push particles into walls.
///
/// A DMDA tells the nodes and how ranks share them: that of set_grid_of_nodes, else that of the preconditioner
/// (PCSetDM). Options, behind the prefix of the preconditioner:
///   -pc_staggered_axes <-1,0,1,...>        for each unknown of a node: the axis whose faces it is at, -1: cells
///   -pc_staggered_coarse_eq_limit <5000>   unknowns of the coarsest grid, at most
///   -staggered_mg_levels_..., -staggered_mg_coarse_...   those of PCMG's solvers
/// To be called before the type is used; again does no harm.
PetscErrorCode register_staggered_multigrid();

}  // namespace scree
