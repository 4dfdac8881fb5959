#include "scree/closures/rheology/none.hpp"

#include "scree/closures/solids_closures.hpp"

namespace scree {

const FrictionModel FrictionModel::none(rheology<NoFriction>);

}  // namespace scree
