#include "scree/stepping/corrections.hpp"

#include "scree/balances/layout.hpp"
#include "scree/grid/ghosted.hpp"

namespace scree {

namespace {

MPI_Comm comm_of(DM dm) { return PetscObjectComm(reinterpret_cast<PetscObject>(dm)); }

/// Calls work(state with ghosts as it was, the same without ghosts to be changed).
template <class Work>
PetscErrorCode change(DM dm, Vec state, Work&& work) {
  PetscFunctionBeginUser;
  GhostedArray u;
  double* owned;
  PetscCall(u.open(dm, state));
  PetscCall(VecGetArray(state, &owned));
  work(u.data(), owned);
  PetscCall(VecRestoreArray(state, &owned));
  PetscCall(u.close());
  PetscFunctionReturn(0);
}

}  // namespace

PetscErrorCode correct(const DiscreteProblem& problem, const Stage& stage, Vec residual, Vec state,
                       VolumeImbalance* imbalance) {
  PetscFunctionBeginUser;
  double solids_outflow, gas_outflow, volume_rate;
  PetscCall(impose_gas(problem, stage.time, state));
  PetscCall(project_gas(problem, stage.time, state));
  PetscCall(settle_pressure(problem, state));
  PetscCall(problem.outflow(stage.time, state, Phase::solids, &solids_outflow));
  PetscCall(problem.outflow(stage.time, state, Phase::gas, &gas_outflow));
  PetscCall(renew_solids_fraction(problem, stage, residual, state, &volume_rate));
  // The gas has the rest of the box: its volume changes by -volume_rate.
  const bool with_gas = problem.model().component<GasContinuity>() >= 0;
  *imbalance = {volume_rate + solids_outflow, with_gas ? gas_outflow - volume_rate : 0};
  PetscFunctionReturn(0);
}

PetscErrorCode renew_solids_fraction(const DiscreteProblem& problem, const Stage& stage, Vec residual, Vec state,
                                     double* volume_rate) {
  PetscFunctionBeginUser;
  const Lattice& grid = problem.lattice();
  const Model& model = problem.model();
  double* x;
  const double *f, *rate;
  PetscCall(VecGetArray(state, &x));
  PetscCall(VecGetArrayRead(residual, &f));
  PetscCall(VecGetArrayRead(stage.rate, &rate));
  double sum = 0;
  for_each_node(grid.owned_first, grid.owned_count, [&](const Index& I) {
    if (!model.is_balance(Model::solids_fraction, I)) return;
    const int nu = grid.owned(I) * model.unknowns() + Model::solids_fraction;
    const double excess = f[nu] / model.continuity_scale();
    x[nu] -= excess / stage.shift;
    sum += grid.volume(I) * (rate[nu] - excess);
  });
  PetscCall(VecRestoreArrayRead(stage.rate, &rate));
  PetscCall(VecRestoreArrayRead(residual, &f));
  PetscCall(VecRestoreArray(state, &x));
  PetscCallMPI(MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, comm_of(problem.dm())));
  *volume_rate = sum;
  PetscFunctionReturn(0);
}

PetscErrorCode lag_friction(const DiscreteProblem& problem, double dt, Vec state) {
  PetscFunctionBeginUser;
  const double share = dt / (dt + problem.setup().solids.friction.tau);
  PetscCall(
      change(problem.dm(), state, [&](const double* u, double* owned) { problem.model().relax_chi(u, share, owned); }));
  PetscFunctionReturn(0);
}

PetscErrorCode raise_temperature(const DiscreteProblem& problem, double dt, double least_nu, Vec guess) {
  PetscFunctionBeginUser;
  const Model& model = problem.model();
  if (model.component<GranularEnergy>() < 0) PetscFunctionReturn(0);
  PetscCall(change(problem.dm(), guess,
                   [&](const double* u, double* owned) { model.raise_temperature(u, dt, least_nu, owned); }));
  PetscFunctionReturn(0);
}

PetscErrorCode impose_gas(const DiscreteProblem& problem, double time, Vec state) {
  PetscFunctionBeginUser;
  PetscCall(
      change(problem.dm(), state, [&](const double* u, double* owned) { problem.model().impose_gas(time, u, owned); }));
  PetscFunctionReturn(0);
}

PetscErrorCode project_gas(const DiscreteProblem& problem, double time, Vec state) {
  PetscFunctionBeginUser;
  if (problem.gas_projection()) PetscCall(problem.gas_projection()->apply(time, state));
  PetscFunctionReturn(0);
}

PetscErrorCode settle_pressure(const DiscreteProblem& problem, Vec state) {
  PetscFunctionBeginUser;
  const Lattice& grid = problem.lattice();
  const int p = problem.model().component<GasContinuity>();
  if (p < 0 || problem.barriers().some_open()) PetscFunctionReturn(0);
  double* x;
  double sum[2] = {0, 0};
  PetscCall(VecGetArray(state, &x));
  const auto each_cell = [&](auto&& work) {
    for_each_node(grid.owned_first, grid.owned_count, [&](const Index& I) {
      if (grid.inside(I)) work(x[grid.owned(I) * problem.model().unknowns() + p], grid.volume(I));
    });
  };
  each_cell([&](double value, double volume) {
    sum[0] += volume * value;
    sum[1] += volume;
  });
  PetscCallMPI(MPI_Allreduce(MPI_IN_PLACE, sum, 2, MPI_DOUBLE, MPI_SUM, comm_of(problem.dm())));
  each_cell([&](double& value, double) { value -= sum[0] / sum[1]; });
  PetscCall(VecRestoreArray(state, &x));
  PetscFunctionReturn(0);
}

}  // namespace scree
