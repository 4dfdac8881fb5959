/// Cell-centred fields for output that are no unknowns, but follow from them.
#pragma once

#include <vector>

#include "scree/assembly/parameters.hpp"
#include "scree/grid/unknown.hpp"

namespace scree {

/// The closures that the fields below are, in their order: T where it is algebraic, p_f where there is friction.
std::vector<CellClosure::Entry> derived_entries(const ModelParameters& model, const SolidsParameters& solids);

/// Their names. The component is the place in this list, the scale 1.
std::vector<Field> derived_fields(const ModelParameters& model, const SolidsParameters& solids);

}  // namespace scree
