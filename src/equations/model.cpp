#include "scree/equations/model.hpp"

namespace scree {

std::unique_ptr<Model> make_model_1d(const ModelSetup& setup);
std::unique_ptr<Model> make_model_2d(const ModelSetup& setup);
std::unique_ptr<Model> make_model_3d(const ModelSetup& setup);

std::pair<int, int> model_extent(int dim, const ModelParameters& model, const FrictionParameters& friction) {
  const int unknowns = 1 + dim + (model.temperature == TemperatureModel::transport ? 1 : 0) +
                       (friction.model == FrictionModel::relaxed ? 1 : 0);
  return {unknowns, model.advection == AdvectionScheme::upwind ? 2 : 3};
}

std::unique_ptr<Model> make_model(const ModelSetup& setup) {
  switch (setup.lattice.dim) {
    case 1:
      return make_model_1d(setup);
    case 2:
      return make_model_2d(setup);
    default:
      return make_model_3d(setup);
  }
}

}  // namespace scree
