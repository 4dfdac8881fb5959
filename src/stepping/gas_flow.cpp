#include "scree/stepping/gas_flow.hpp"

#include <vector>

#include "scree/balances/layout.hpp"
#include "scree/grid/ghosted.hpp"

namespace scree {

namespace {

MPI_Comm comm_of(const DiscreteProblem& problem) {
  return PetscObjectComm(reinterpret_cast<PetscObject>(problem.dm()));
}

/// (1-nu)/beta of a cell [m3 s/kg]; `at` gives the SI value of a component at a node.
template <class Value>
double mobility(const DiscreteProblem& problem, const Index& I, double nu, Value&& at) {
  const SolidsParameters& solids = problem.setup().solids;
  const ModelParameters& model = problem.setup().model;
  const Model& unknowns = problem.model();
  if (solids.gas.model == GasModel::darcy) {
    double gradient_squared = 0;
    for (const double g : model.mean_pressure_gradient) gradient_squared += g * g;
    return darcy_mobility(nu, gradient_squared, model.darcy_solids_fraction, solids.kinetic.d, solids.gas);
  }
  double slip_squared = 0;
  for (int a = 0; a < problem.box().dim; ++a) {
    const int u = unknowns.component<GasMomentum>(a), v = unknowns.component<SolidsMomentum>(a);
    const Index upper = I + unit(a);
    const double slip = 0.5 * (at(u, I) + at(u, upper) - at(v, I) - at(v, upper));
    slip_squared += slip * slip;
  }
  constexpr double none = 1e-30;  // of beta, where there are no particles
  return (1 - nu) / (drag_coefficient(nu, slip_squared, solids.kinetic.d, solids.gas) + none);
}

}  // namespace

PetscErrorCode mean_gas_velocity(const DiscreteProblem& problem, double time, Vec state, int axis, double* velocity) {
  PetscFunctionBeginUser;
  const Lattice& grid = problem.lattice();
  GhostedArray u;
  PetscCall(u.open(problem.dm(), state));
  double sum[2] = {0, 0};
  for_each_node(grid.owned_first, grid.owned_count, [&](const Index& I) {
    if (!grid.inside(I)) return;
    const double volume = grid.face_area(axis, I) * grid.axes[axis].distance(I[axis]);
    sum[0] += volume * problem.model().gas_flux(time, u.data(), axis, I);
    sum[1] += volume;
  });
  PetscCall(u.close());
  PetscCallMPI(MPI_Allreduce(MPI_IN_PLACE, sum, 2, MPI_DOUBLE, MPI_SUM, comm_of(problem)));
  *velocity = sum[0] / sum[1];
  PetscFunctionReturn(0);
}

PetscErrorCode gas_resistance(const DiscreteProblem& problem, Vec state, int axis, GasResistance* gas) {
  PetscFunctionBeginUser;
  const Lattice& grid = problem.lattice();
  const Model& model = problem.model();
  const GasParameters& parameters = problem.setup().solids.gas;
  const std::size_t layers = static_cast<std::size_t>(grid.axes[axis].cells());
  std::vector<double> sums(3 * layers, 0.0);  // of a layer: area, and area over either resistance
  GhostedArray u;
  PetscCall(u.open(problem.dm(), state));
  for_each_node(grid.owned_first, grid.owned_count, [&](const Index& I) {
    if (!grid.inside(I)) return;
    const auto at = [&](int component, const Index& node) {
      return model.fields()[static_cast<std::size_t>(component)].scale *
             u.data()[grid.ghosted(node) * model.unknowns() + component];
    };
    const double nu = at(Model::solids_fraction, I), area = grid.face_area(axis, I);
    double* layer = &sums[3 * static_cast<std::size_t>(I[axis])];
    layer[0] += area;
    layer[1] += area * (1 - nu) / parameters.rho_g;
    layer[2] += area * (1 - nu) * mobility(problem, I, nu, at);
  });
  PetscCall(u.close());
  PetscCallMPI(
      MPI_Allreduce(MPI_IN_PLACE, sums.data(), static_cast<int>(sums.size()), MPI_DOUBLE, MPI_SUM, comm_of(problem)));
  *gas = GasResistance();
  double length = 0;
  for (std::size_t i = 0; i < layers; ++i) {
    const double width = grid.axes[axis].width(static_cast<int>(i)), *layer = &sums[3 * i];
    length += width;
    if (parameters.model == GasModel::incompressible) gas->inertia += width * layer[0] / layer[1];
    gas->drag += width * layer[0] / layer[2];
  }
  gas->inertia /= length;
  gas->drag /= length;
  PetscFunctionReturn(0);
}

}  // namespace scree
