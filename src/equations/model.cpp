#include "scree/equations/model.hpp"

namespace scree {

/// Explicitly instantiated, one file a dimension and gas model.
template <int dim, GasModel gas>
std::unique_ptr<Model> choose_model(const ModelSetup& setup);

namespace {

template <int dim>
std::unique_ptr<Model> with_gas(const ModelSetup& setup) {
  switch (setup.solids.gas.model) {
    case GasModel::none:
      return choose_model<dim, GasModel::none>(setup);
    case GasModel::darcy:
      return choose_model<dim, GasModel::darcy>(setup);
    default:
      return choose_model<dim, GasModel::incompressible>(setup);
  }
}

}  // namespace

std::pair<int, int> model_extent(int dim, const ModelParameters& model, const SolidsParameters& solids) {
  const GasModel gas = solids.gas.model;
  const int unknowns = 1 + dim + (model.temperature == TemperatureModel::transport ? 1 : 0) +
                       (solids.friction.model->has_unknown ? 1 : 0) + (gas == GasModel::incompressible ? dim : 0) +
                       (gas != GasModel::none ? 1 : 0);
  return {unknowns, model.advection == AdvectionScheme::upwind ? 2 : 3};
}

std::unique_ptr<Model> make_model(const ModelSetup& setup) {
  switch (setup.lattice.dim) {
    case 1:
      return with_gas<1>(setup);
    case 2:
      return with_gas<2>(setup);
    default:
      return with_gas<3>(setup);
  }
}

}  // namespace scree
