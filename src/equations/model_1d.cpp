/// The models in 1 dimension, compiled once.
#include "scree/equations/assembled_model.hpp"

namespace scree {

std::unique_ptr<Model> make_model_1d(const ModelSetup& setup) { return choose_model<1>(setup); }

}  // namespace scree
