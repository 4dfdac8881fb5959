/// Named sets of PETSc options for the nonlinear and linear solvers. A preset is nothing but options; those that the
/// case file or the command line set win, see ScopedOptions.
#pragma once

#include "scree/stepping/choices.hpp"
#include "scree/stepping/scoped_options.hpp"

namespace scree {

/// Options of a preset for a node of `unknowns` unknowns, nu being the first and p_g, with gas, at place
/// `gas_pressure`. With gas the ILU of `fieldsplit` has `fill` levels.
PetscOptionList preset_options(SolverPreset preset, int unknowns, int gas_pressure = -1, int fill = 0);

}  // namespace scree
