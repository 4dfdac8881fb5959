/// The norm in which the local error of a step is measured.
#pragma once

#include "scree/stepping/discrete_problem.hpp"

namespace scree {

/// Root mean square of `error` over the unknowns that a step is judged by, in units of the scales: nu, v, T and chi, or
/// u in scenes where it alone can change; p_g has no error of its own. v, T and chi count less where `state` has fewer
/// particles: in voids they follow eddies of the gas, with much shorter steps than the bed asks for. Collective.
PetscErrorCode norm_of_error(const DiscreteProblem& problem, Vec state, Vec error, double* norm);

}  // namespace scree
