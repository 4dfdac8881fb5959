/// The models of nonlocal friction in 2 dimensions, gas none, friction relaxed, compiled once.
#include <stdexcept>

#include "scree/model/assembled_model.hpp"

namespace scree {

std::unique_ptr<Model> with_fluidity(const ModelSetup& setup) {
  if (!setup.solids.friction.model->has_unknown)
    throw std::runtime_error("the balance of fluidity takes friction_model relaxed");
  const auto with = [&](auto T, auto second_order) -> std::unique_ptr<Model> {
    using Nonlocal = Layout<2, T(), true, GasModel::none, Fluidity>;
    return std::make_unique<AssembledModel<Nonlocal, second_order()>>(setup);
  };
  const auto with_T = [&](auto T) {
    return setup.model.advection == AdvectionScheme::upwind ? with(T, std::false_type{}) : with(T, std::true_type{});
  };
  return setup.model.temperature == TemperatureModel::transport ? with_T(std::true_type{}) : with_T(std::false_type{});
}

}  // namespace scree
