/// The state at t = 0, from the regions of a case.
#pragma once

#include <string>
#include <vector>

#include "scree/config/case.hpp"
#include "scree/stepping/discrete_problem.hpp"

namespace scree {

/// Collective. Fills the global vector `state`; later regions overwrite earlier ones. Returns a line for the log for
/// each region that another run fills. Throws InputError on all ranks where such a run does not fit.
std::vector<std::string> set_initial_state(const Case& the_case, const DiscreteProblem& problem, Vec state);

/// Solids fractions of a column at rest under its own weight, one a cell of `axis`, as the discrete momentum balance
/// has it: p_c(nu_i) - p_c(nu_above) = rho_s g nu_face distance, T4; with wall friction in a bin of width
/// `janssen_width` > 0, less 2 tan(delta) p/W distance, T5. Cells whose centres lie above `surface` hold nothing.
/// `down` is the sign of gravity along the axis.
std::vector<double> equilibrium_column(const Axis& axis, double gravity, int down, double surface, double janssen_width,
                                       const Case& the_case);

}  // namespace scree
