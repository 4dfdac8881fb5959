/// The line search of the presets: full Newton steps, shortened only where they fail badly.
#pragma once

#include <petscsnes.h>

namespace scree {

/// Makes `snes` take full steps (within NewtonLimits), halving a step up to six times while the residual is not finite
/// or more than ten times the one before. Demanding descent, as PETSc's "bt" does, costs an iteration a step: where
/// wall slip or div v changes sign, the norm often rises once before it falls quadratically.
/// Does nothing if the options database names a line search for the prefix of `snes`.
PetscErrorCode use_guarded_full_steps(SNES snes);

}  // namespace scree
