#include "scree/stepping/local_error.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace scree {

namespace {

/// Share of L4 in the norm.
constexpr double local_share = 0.5;

/// Of one unknown, all components of a vector together. Integrals over the box.
struct Sums {
  double volume = 0;            ///< in which there is what carries the unknown [m^dim]
  double state = 0, error = 0;  ///< of squares
  double error_4 = 0;           ///< of fourth powers, of the components of a vector each
  static constexpr int members = 4;

  /// Square of the norm of the error, relative to the state, where that is no less than `floor`.
  double squared_norm(double floor) const {
    if (!(volume > 0)) return 0;
    const double mean_square = error / volume + local_share * local_share * std::sqrt(error_4 / volume);
    return mean_square / (state / volume + floor * floor);
  }
};

/// An unknown that a step is judged by, and its components in a node.
struct Judged {
  const Unknown* unknown;
  std::vector<Field> components;
};

std::vector<Judged> judged_unknowns(const DiscreteProblem& problem) {
  const ProblemSetup& setup = problem.setup();
  const bool gas_alone = !setup.model.solids_moving || setup.scales.density != setup.solids.kinetic.rho_s;
  std::vector<Judged> result;
  for (const Field& field : problem.model().fields()) {
    const ErrorNorm counts = field.unknown->error;
    if (counts == ErrorNorm::none || (counts == ErrorNorm::gas_alone && !gas_alone)) continue;
    if (result.empty() || result.back().unknown != field.unknown) result.push_back({field.unknown, {}});
    result.back().components.push_back(field);
  }
  return result;
}

/// Volume about the place of a component in node I; 0 where the box has none [m^dim].
double volume_about(const Lattice& grid, const Field& field, const Index& I) {
  const int axis = field.face_axis;
  if (axis < 0) return grid.inside(I) ? grid.volume(I) : 0;
  return grid.is_face(axis, I) ? grid.face_area(axis, I) * grid.control_length(axis, I) : 0;
}

/// Adds node I to the sums of an unknown; x, e: the node in the state and in the error.
void add_node(const Lattice& grid, const Judged& judged, const Index& I, const double* x, const double* e, Sums* sums) {
  const bool of_gas = judged.unknown->error == ErrorNorm::gas_alone;
  const double filled = of_gas ? 1 : std::clamp(x[Model::solids_fraction] / few_particles, 0.0, 1.0);
  const double counts = judged.unknown->error == ErrorNorm::everywhere ? 1 : filled;
  for (const Field& field : judged.components) {
    const double volume = volume_about(grid, field, I), x_c = x[field.component], e_c = e[field.component];
    sums->volume += volume * filled / static_cast<double>(judged.components.size());
    sums->state += volume * counts * x_c * x_c;
    sums->error += volume * counts * e_c * e_c;
    sums->error_4 += volume * counts * e_c * e_c * e_c * e_c;
  }
}

/// Below which root mean square an unknown counts as that [scale]: T goes with the square of velocities.
double floor_of(const Unknown& unknown, const Scales& scales) {
  Scales slower = scales;
  slower.velocity *= small_share;
  return std::min(small_share, unknown.scale(slower) / unknown.scale(scales));
}

}  // namespace

PetscErrorCode norm_of_error(const DiscreteProblem& problem, Vec state, Vec error, double* norm) {
  PetscFunctionBeginUser;
  static_assert(sizeof(Sums) == Sums::members * sizeof(double));
  const std::vector<Judged> judged = judged_unknowns(problem);
  const Lattice& grid = problem.lattice();
  const int unknowns = problem.model().unknowns();
  std::vector<Sums> sums(judged.size());
  const double *e, *x;
  PetscCall(VecGetArrayRead(error, &e));
  PetscCall(VecGetArrayRead(state, &x));
  for_each_node(grid.owned_first, grid.owned_count, [&](const Index& I) {
    const int node = grid.owned(I) * unknowns;
    for (std::size_t k = 0; k < judged.size(); ++k) add_node(grid, judged[k], I, x + node, e + node, &sums[k]);
  });
  PetscCall(VecRestoreArrayRead(state, &x));
  PetscCall(VecRestoreArrayRead(error, &e));
  PetscCallMPI(MPI_Allreduce(MPI_IN_PLACE, sums.data(), Sums::members * static_cast<int>(sums.size()), MPI_DOUBLE,
                             MPI_SUM, PetscObjectComm(reinterpret_cast<PetscObject>(error))));
  double total = 0;
  for (std::size_t k = 0; k < judged.size(); ++k)
    total += sums[k].squared_norm(floor_of(*judged[k].unknown, problem.setup().scales));
  *norm = std::sqrt(total / static_cast<double>(judged.size()));
  PetscFunctionReturn(0);
}

}  // namespace scree
