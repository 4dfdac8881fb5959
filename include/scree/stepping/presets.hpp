/// Named sets of PETSc options for the nonlinear and linear solvers. A preset is nothing but options; those that the
/// case file or the command line set win, see ScopedOptions.
#pragma once

#include <vector>

#include "scree/grid/unknown.hpp"
#include "scree/stepping/choices.hpp"
#include "scree/stepping/scoped_options.hpp"

namespace scree {

/// Options of a preset for nodes with the unknowns `node`, those of Model::fields, nu being the first. With gas the ILU
/// of `fieldsplit` has `fill` levels. `ranks` share the grid.
PetscOptionList preset_options(SolverPreset preset, const std::vector<Field>& node, int ranks = 1, int fill = 0);

}  // namespace scree
