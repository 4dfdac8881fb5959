/// A preconditioner that solves for the core of a condensed matrix, see condensation.hpp, and then for the rest.
#pragma once

#include <petscpc.h>

namespace scree {

/// Registers the type "condensed" for -pc_type: a field split whose Schur complement is that of node blocks,
///
///     y_c = S^-1 (x_c - A_cr D^-1 x_r),    y_r = A_rr^-1 (x_r - A_rc y_c).
///
/// S^-1 and A_rr^-1 are KSPs of their own (preonly by default), which have the options of the prefixes
/// "condensed_core_" and "condensed_rest_" behind that of the preconditioner. -pc_condensed_eliminated lists the
/// components of a node that are eliminated. A block of D without inverse, or a solver inside that fails, fails the
/// solver outside. To be called before the type is used; again does no harm.
PetscErrorCode register_condensed_preconditioner();

}  // namespace scree
