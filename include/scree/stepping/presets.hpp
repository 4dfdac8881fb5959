/// Named sets of PETSc options for the nonlinear and linear solvers. A preset is nothing but options; those that the
/// case file or the command line set win, see ScopedOptions.
#pragma once

#include <array>
#include <vector>

#include "scree/grid/index.hpp"
#include "scree/grid/unknown.hpp"
#include "scree/stepping/choices.hpp"
#include "scree/stepping/scoped_options.hpp"

namespace scree {

/// What presets depend on beside the unknowns.
struct PresetScene {
  int ranks = 1;                          ///< that share the grid
  int fill = 0;                           ///< levels of the ILU of `fieldsplit` with gas
  std::array<double, max_dim> gravity{};  ///< [m/s2]; its direction counts
  double cells = 0;                       ///< of the grid
  bool solids_moving = true;
};

/// Options of a preset for nodes with the unknowns `node`, those of Model::fields, nu being the first.
PetscOptionList preset_options(SolverPreset preset, const std::vector<Field>& node, const PresetScene& scene = {});

}  // namespace scree
