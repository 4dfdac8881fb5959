#include "scree/stepping/local_error.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace scree {

namespace {

/// Solids fraction below which v, T and chi count less.
constexpr double few = 1e-2;

/// Components by the weight with which they count.
struct Judged {
  std::vector<int> everywhere, with_particles;

  explicit Judged(const DiscreteProblem& problem) {
    const ProblemSetup& setup = problem.setup();
    const Model& model = problem.model();
    const bool gas_alone = !setup.model.solids_moving || setup.scales.density != setup.solids.kinetic.rho_s;
    for (const Field& field : model.fields()) {
      const ErrorNorm counts = field.unknown->error;
      if (counts == ErrorNorm::everywhere || (counts == ErrorNorm::gas_alone && gas_alone))
        everywhere.push_back(field.component);
      else if (counts == ErrorNorm::with_particles)
        with_particles.push_back(field.component);
    }
  }
  std::size_t size() const { return everywhere.size() + with_particles.size(); }
};

}  // namespace

PetscErrorCode norm_of_error(const DiscreteProblem& problem, Vec state, Vec error, double* norm) {
  PetscFunctionBeginUser;
  const Judged judged(problem);
  const int unknowns = problem.model().unknowns();
  PetscInt size, local_size;
  const double *d, *x;
  PetscCall(VecGetSize(error, &size));
  PetscCall(VecGetLocalSize(error, &local_size));
  PetscCall(VecGetArrayRead(error, &d));
  PetscCall(VecGetArrayRead(state, &x));
  double sum = 0;
  for (PetscInt node = 0; node < local_size; node += unknowns) {
    const double weight = std::clamp(x[node + Model::solids_fraction] / few, 0.0, 1.0);
    for (const int c : judged.everywhere) sum += d[node + c] * d[node + c];
    for (const int c : judged.with_particles) sum += weight * d[node + c] * d[node + c];
  }
  PetscCall(VecRestoreArrayRead(state, &x));
  PetscCall(VecRestoreArrayRead(error, &d));
  PetscCallMPI(
      MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, PetscObjectComm(reinterpret_cast<PetscObject>(error))));
  const double nodes = static_cast<double>(size) / unknowns;
  *norm = std::sqrt(sum / (nodes * static_cast<double>(judged.size())));
  PetscFunctionReturn(0);
}

}  // namespace scree
