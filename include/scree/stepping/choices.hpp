/// Choices that users make among time schemes and solvers.
#pragma once

#include "scree/assembly/newton_tangent.hpp"

namespace scree {

/// Backward Euler, BDF of order 2, stiffly accurate implicit Runge-Kutta of order 2 (TSARKIMEX2E).
enum class TimeScheme { beuler, bdf, arkimex };

/// Named sets of PETSc options, see presets.hpp.
enum class SolverPreset { direct, ilu, multigrid, fieldsplit, condensed };

const char* name_of(TimeScheme scheme);
const char* name_of(SolverPreset preset);

}  // namespace scree
