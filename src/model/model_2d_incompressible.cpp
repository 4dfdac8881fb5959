/// The models in 2 dimensions, gas incompressible, compiled once.
#include "scree/model/assembled_model.hpp"

namespace scree {

template std::unique_ptr<Model> choose_model<2, GasModel::incompressible>(const ModelSetup&);

}  // namespace scree
