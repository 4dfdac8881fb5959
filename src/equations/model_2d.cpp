/// The models in 2 dimensions, compiled once.
#include "scree/equations/assembled_model.hpp"

namespace scree {

std::unique_ptr<Model> make_model_2d(const ModelSetup& setup) { return choose_model<2>(setup); }

}  // namespace scree
