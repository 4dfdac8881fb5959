#include "scree/closures/friction.hpp"

namespace scree {

std::vector<FrictionModel>& friction_models() {
  static std::vector<FrictionModel> models{FrictionModel::none, FrictionModel::critical_state,
                                           FrictionModel::instantaneous, FrictionModel::relaxed};
  return models;
}

}  // namespace scree
