/// The fields of a state that are no unknowns, for output.
#pragma once

#include <vector>

#include "scree/output/field_writer.hpp"
#include "scree/stepping/discrete_problem.hpp"

namespace scree {

/// Collective. The derived_fields of the model with their values.
std::vector<CellField> derived_cells(const DiscreteProblem& problem, Vec state);

}  // namespace scree
