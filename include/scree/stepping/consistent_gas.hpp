/// Consistent p_g and u for a state whose gas is not in balance: at the start, and where the flow of an inlet jumps.
#pragma once

#include "scree/stepping/time_stepper.hpp"

namespace scree {

/// Changes p_g and u of `state`: u is projected onto (2); then a short step, in which nu, v, T and chi stand still,
/// gives p_g the value that belongs to u under (4), and not the impulse that a jump of u takes. Does nothing for models
/// without gas. *done is false, and p_g as it was, if that step fails. `solver` are PETSc's options for the solvers of
/// that step; the user's own for them have the prefix "gas_start_". Collective.
PetscErrorCode make_gas_consistent(const DiscreteProblem& problem, const StepControl& control,
                                   const PetscOptionList& solver, double time, Vec state, bool* done);

}  // namespace scree
