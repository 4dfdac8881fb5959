#include "scree/closures/rheology/relaxed.hpp"

#include "scree/closures/solids_closures.hpp"

namespace scree {

const FrictionModel FrictionModel::relaxed(rheology<Relaxed>);

}  // namespace scree
