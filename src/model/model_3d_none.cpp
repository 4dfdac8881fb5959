/// The models in 3 dimensions, gas none, compiled once.
#include "scree/model/assembled_model.hpp"

namespace scree {

template std::unique_ptr<Model> choose_model<3, GasModel::none>(const ModelSetup&);

}  // namespace scree
