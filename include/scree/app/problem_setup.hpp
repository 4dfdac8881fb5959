/// From a scene as the user describes it to the problem that the solver knows.
#pragma once

#include "scree/config/case.hpp"
#include "scree/stepping/discrete_problem.hpp"

namespace scree {

/// Grid, conditions, parameters and scales of a scene. Unless the case gives scale_velocity, velocities are scaled by
/// sqrt(g d) and times by sqrt(d/g).
ProblemSetup problem_setup(const Case& the_case, const ModelFactory& models = {make_model, {}});

}  // namespace scree
