#include "scree/stepping/remainder.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "scree/grid/ghosted.hpp"
#include "scree/stepping/local_error.hpp"

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

/// Over the cells with a balance of particles. Squares are of numbers in units of the scales.
struct RowSums {
  double nu_change = 0;  ///< squares of what nu lacks
  double flow = 0;       ///< squares of the flows that balance rows of mass
  double cells = 0;      ///< how many
  double speed = 0;      ///< squares of components of v where there are particles
  double faces = 0;      ///< how many
  static constexpr int members = 5;
};

double root_mean(double sum, double count) { return count > 0 ? std::sqrt(sum / count) : 0; }

}  // namespace

PetscErrorCode measure_remainder(const DiscreteProblem& problem, double shift, Vec state, Vec residual,
                                 Remainder* remainder) {
  PetscFunctionBeginUser;
  constexpr double dilute = 0.1, least_storage = 1e-2;  // emptier places count as if they stored this
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
  RowSums sums;
  double most[2]{-PETSC_INFINITY, 0};  // of -nu, of changes of single unknowns
  const auto nu_at = [&](const Index& I) { return u.data()[grid.ghosted(I) * unknowns + Model::solids_fraction]; };
  for_each_node(grid.owned_first, grid.owned_count, [&](const Index& I) {
    if (!model.is_balance(Model::solids_fraction, I)) return;
    const double* rows = f + grid.owned(I) * unknowns;
    const double per_change = model.continuity_scale() * shift, nu = nu_at(I);
    const double correction = rows[Model::solids_fraction] / per_change;
    sums.nu_change += correction * correction;
    sums.cells += 1;
    const double flow_per_row = shortest_side(grid, I) / (model.continuity_scale() * problem.setup().scales.velocity);
    for (const int row : of_mass) sums.flow += std::pow(flow_per_row * rows[row], 2);
    most[0] = std::max(most[0], correction - nu);
    for (const Field& field : stored_with_nu) {
      if (!model.is_balance(field.component, I)) continue;
      if (field.face_axis >= 0 && nu > few_particles) {
        sums.speed += std::pow(u.data()[grid.ghosted(I) * unknowns + field.component], 2);
        sums.faces += 1;
      }
      const double stored = field.face_axis < 0 ? nu : 0.5 * (nu + nu_at(I - unit(field.face_axis)));
      if (stored < dilute)
        most[1] = std::max(most[1], std::abs(rows[field.component]) / (per_change * std::max(stored, least_storage)));
    }
  });
  PetscCall(VecRestoreArrayRead(residual, &f));
  PetscCall(u.close());
  PetscCallMPI(MPI_Allreduce(MPI_IN_PLACE, &sums, RowSums::members, MPI_DOUBLE, MPI_SUM, comm));
  PetscCallMPI(MPI_Allreduce(MPI_IN_PLACE, most, 2, MPI_DOUBLE, MPI_MAX, comm));
  // Particles at rest have no balance.
  *remainder = {root_mean(sums.nu_change, sums.cells), -most[0], most[1],
                root_mean(sums.flow, sums.cells) / std::max(small_share, root_mean(sums.speed, sums.faces))};
  PetscFunctionReturn(0);
}

}  // namespace scree
