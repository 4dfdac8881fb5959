/// The models in 3 dimensions, compiled once.
#include "scree/equations/assembled_model.hpp"

namespace scree {

std::unique_ptr<Model> make_model_3d(const ModelSetup& setup) { return choose_model<3>(setup); }

}  // namespace scree
