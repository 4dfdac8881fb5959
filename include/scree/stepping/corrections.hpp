/// Maps on states that stand beside Newton's method: what a converged state is put right by, and what a first guess is.
/// All are collective.
#pragma once

#include "scree/stepping/discrete_problem.hpp"
#include "scree/stepping/stage.hpp"

namespace scree {

/// Rate of change of the volume of each phase in the box plus its outflow through the sides [m^dim/s].
struct VolumeImbalance {
  double solids = 0, gas = 0;
};

/// Puts right what Newton's method leaves undone: u obeys its conditions and makes room, p_g gets its level, nu is
/// renewed from continuity. `residual` belongs to `state` before. The imbalances are zero but for rounding; where u is
/// no unknown (gas darcy) that of the gas is what Newton's method leaves. u goes with nu as it was before, as in the
/// fluxes of the step.
PetscErrorCode correct(const DiscreteProblem& problem, const Stage& stage, Vec residual, Vec state,
                       VolumeImbalance* imbalance);

/// Renews nu of each cell from its own balance (1), with the fluxes of the state that `residual` belongs to: an
/// explicit correction of the size of Newton's tolerance, after which the balance of mass is exact to rounding for
/// whatever tolerance. `volume_rate` receives the rate of the volume of solids afterwards [m^dim/s].
PetscErrorCode renew_solids_fraction(const DiscreteProblem& problem, const Stage& stage, Vec residual, Vec state,
                                     double* volume_rate);
/// Makes u obey the conditions on sides and plates at `time`, where u is an unknown.
PetscErrorCode impose_gas(const DiscreteProblem& problem, double time, Vec state);
/// Makes div(nu v + (1-nu) u) vanish by changing u inside and on open sides, where u is an unknown.
PetscErrorCode project_gas(const DiscreteProblem& problem, double time, Vec state);
/// Makes the mean of p_g zero where no side is open, i.e. where (2) and (4) leave it undetermined.
PetscErrorCode settle_pressure(const DiscreteProblem& problem, Vec state);

/// Friction lagged by a step: chi of `state` after a step of dt of (23) without advection, or chi* itself.
PetscErrorCode lag_friction(const DiscreteProblem& problem, double dt, Vec state);
/// Cells that the first guess of T is raised in hold more than this [-]: what velocities are left of an earlier step in
/// thinner ones says nothing.
inline constexpr double least_nu_of_guess = 0.02;
/// Cells in which T is raised when Newton's method wanted T < 0 [-]: there is no production in thinner ones, see
/// production_share.
inline constexpr double least_nu_with_production = 1e-4;
/// Raises T where it is too cold for a step of dt, see Model::raise_temperature.
PetscErrorCode raise_temperature(const DiscreteProblem& problem, double dt, double least_nu, Vec guess);

}  // namespace scree
