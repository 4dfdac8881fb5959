#include "scree/stepping/remainder.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "scree/grid/ghosted.hpp"

namespace scree {

namespace {

/// v, T and chi, and what else the particles carry: nu times their rate is what their balances store.
std::vector<Field> rows_stored_with_nu(const Model& model) {
  std::vector<Field> rows;
  for (const Field& field : model.fields())
    if (field.unknown->error == ErrorNorm::with_particles) rows.push_back(field);
  return rows;
}

/// Continuity of the particles, and of both phases.
std::vector<int> rows_of_mass(const Model& model) {
  std::vector<int> rows{Model::solids_fraction};
  for (const Field& field : model.fields())
    if (field.unknown->error == ErrorNorm::none) rows.push_back(field.component);
  return rows;
}

double shortest_side(const Lattice& grid, const Index& I) {
  double h = grid.axes[0].width(I[0]);
  for (int axis = 1; axis < grid.dim; ++axis) h = std::min(h, grid.axes[axis].width(I[axis]));
  return h;
}

}  // namespace

PetscErrorCode measure_remainder(const DiscreteProblem& problem, double shift, Vec state, Vec residual,
                                 Remainder* remainder) {
  PetscFunctionBeginUser;
  constexpr double dilute = 0.1, least_storage = 1e-2;  // emptier places count as if they stored this
  constexpr double few = 1e-2, small = 0.1;             // as in the norm of local errors
  const Lattice& grid = problem.lattice();
  const MPI_Comm comm = PetscObjectComm(reinterpret_cast<PetscObject>(problem.dm()));
  const Model& model = problem.model();
  const int unknowns = model.unknowns();
  const std::vector<Field> stored_with_nu = rows_stored_with_nu(model);
  const std::vector<int> of_mass = rows_of_mass(model);
  GhostedArray u;
  const double* f;
  PetscCall(u.open(problem.dm(), state));
  PetscCall(VecGetArrayRead(residual, &f));
  double sums[5]{};                                // of squares of corrections to nu, of cells, of squares of ...
  enum { nu_change, cells, flow, speed, speeds };  // ... flows that are missing, of speeds, of faces
  double most[2]{-PETSC_INFINITY, 0};              // of -nu, of changes of single unknowns
  const auto nu_at = [&](const Index& I) { return u.data()[grid.ghosted(I) * unknowns + Model::solids_fraction]; };
  for_each_node(grid.owned_first, grid.owned_count, [&](const Index& I) {
    if (!model.is_balance(Model::solids_fraction, I)) return;
    const double* rows = f + grid.owned(I) * unknowns;
    const double per_change = model.continuity_scale() * shift, nu = nu_at(I);
    const double correction = rows[Model::solids_fraction] / per_change;
    sums[nu_change] += correction * correction;
    sums[cells] += 1;
    const double h = shortest_side(grid, I) / model.continuity_scale();
    for (const int row : of_mass) sums[flow] += h * h * rows[row] * rows[row];
    most[0] = std::max(most[0], correction - nu);
    for (const Field& field : stored_with_nu) {
      if (!model.is_balance(field.component, I)) continue;
      if (field.face_axis >= 0 && nu > few) {
        const double v = u.data()[grid.ghosted(I) * unknowns + field.component];
        sums[speed] += v * v;
        sums[speeds] += 1;
      }
      const double stored = field.face_axis < 0 ? nu : 0.5 * (nu + nu_at(I - unit(field.face_axis)));
      if (stored < dilute)
        most[1] = std::max(most[1], std::abs(rows[field.component]) / (per_change * std::max(stored, least_storage)));
    }
  });
  PetscCall(VecRestoreArrayRead(residual, &f));
  PetscCall(u.close());
  PetscCallMPI(MPI_Allreduce(MPI_IN_PLACE, sums, 5, MPI_DOUBLE, MPI_SUM, comm));
  PetscCallMPI(MPI_Allreduce(MPI_IN_PLACE, most, 2, MPI_DOUBLE, MPI_MAX, comm));
  // Particles at rest have no balance.
  const auto mean = [&](int sum, int count) { return sums[count] > 0 ? sums[sum] / sums[count] : 0; };
  const double velocity = problem.setup().scales.velocity;
  *remainder = {std::sqrt(mean(nu_change, cells)), -most[0], most[1],
                std::sqrt(mean(flow, cells)) / velocity / std::max(small, std::sqrt(mean(speed, speeds)))};
  PetscFunctionReturn(0);
}

}  // namespace scree
