#include "scree/closures/rheology/critical_state.hpp"

#include "scree/closures/solids_closures.hpp"

namespace scree {

const FrictionModel FrictionModel::critical_state(rheology<CriticalState>);

}  // namespace scree
