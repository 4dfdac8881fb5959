/// The flow of gas through the whole box along an axis, and what resists it.
#pragma once

#include "scree/stepping/discrete_problem.hpp"
#include "scree/stepping/flow_control.hpp"

namespace scree {

/// Collective. Superficial velocity (1-nu) u along a periodic axis, mean over the box [m/s].
PetscErrorCode mean_gas_velocity(const DiscreteProblem& problem, double time, Vec state, int axis, double* velocity);

/// Collective. Estimate for FlowControl from inertia and drag in each cell, the particles taken as they move: cells of
/// a layer across the axis are passed side by side, layers one after the other. Walls do not count: gas alone in a
/// channel comes to the wanted flow more slowly where steps are longer than its viscous time.
PetscErrorCode gas_resistance(const DiscreteProblem& problem, Vec state, int axis, GasResistance* gas);

}  // namespace scree
