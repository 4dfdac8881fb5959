/// The norm in which the local error of a step is measured.
#pragma once

#include "scree/stepping/discrete_problem.hpp"

namespace scree {

/// Solids fraction below which v, T and chi count less.
constexpr double few_particles = 1e-2;
/// Of the scales of nu, chi and velocities: errors of what is smaller are absolute.
constexpr double small_share = 0.1;

/// Of `error` in a step that led to `state`, relative to what is there: root mean square over the unknowns that a step
/// is judged by of
///
///     sqrt(rms^2 + L4^2/4) / sqrt(rms(unknown)^2 + floor^2),    rms^2 = <e^2>, L4^2 = sqrt(<e^4>),
///
/// the floor being a tenth for nu and chi, and what v, T or u are at a tenth of the velocity scale. <> is the mean over
/// the volume in which there are particles, or gas where it alone can change. L4 sees what the mean square does not:
/// lips, fronts and bubbles are small parts of a bed. Neither empty space nor its cells, nor the scales of the scene,
/// change the norm. v, T and chi count less where `state` has fewer particles: in voids they follow eddies of the gas,
/// with much shorter steps than the bed asks for. p_g has no error of its own. Collective.
PetscErrorCode norm_of_error(const DiscreteProblem& problem, Vec state, Vec error, double* norm);

}  // namespace scree
