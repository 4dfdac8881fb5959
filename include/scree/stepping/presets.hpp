/// Named sets of PETSc options for the nonlinear and linear solvers. A preset is nothing but options; those that the
/// case file or the command line set win.
#pragma once

#include <petscsys.h>

#include <string>
#include <utility>
#include <vector>

namespace scree {

using PetscOptionList = std::vector<std::pair<std::string, std::string>>;

/// Options of preset "direct", "ilu", "multigrid" or "fieldsplit" for a node of `unknowns` unknowns, nu being the
/// first and p_g, with gas, at place `gas_pressure`. With gas the ILU of "fieldsplit" has `fill` levels.
PetscOptionList preset_options(const std::string& preset, int unknowns, int gas_pressure = -1, int fill = 0);

/// Puts those options that are not set yet into the options database; `added` receives their names.
PetscErrorCode apply_preset(const std::string& preset, int unknowns, int gas_pressure = -1,
                            std::vector<std::string>* added = nullptr, int fill = 0);

/// Takes the options `names` out of the options database.
PetscErrorCode remove_options(const std::vector<std::string>& names);

}  // namespace scree
