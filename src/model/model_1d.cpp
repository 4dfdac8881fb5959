/// The models in 1 dimension, compiled once.
#include "scree/model/assembled_model.hpp"

namespace scree {

template std::unique_ptr<Model> choose_model<1, GasModel::none>(const ModelSetup&);
template std::unique_ptr<Model> choose_model<1, GasModel::darcy>(const ModelSetup&);
template std::unique_ptr<Model> choose_model<1, GasModel::incompressible>(const ModelSetup&);

}  // namespace scree
