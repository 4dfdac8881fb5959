#include "scree/closures/rheology/instantaneous.hpp"

#include "scree/closures/solids_closures.hpp"

namespace scree {

const FrictionModel FrictionModel::instantaneous(rheology<Instantaneous>);

}  // namespace scree
