#include "scree/closures/radial_distribution.hpp"

#include "scree/closures/radial_distribution/carnahan_starling.hpp"
#include "scree/closures/radial_distribution/lun_savage.hpp"
#include "scree/closures/radial_distribution/ma_ahmadi.hpp"

namespace scree {

const RadialDistribution* default_radial_distribution() { return &radial_distribution_entry<LunSavage>; }

Variants<RadialDistribution>& radial_distributions() {
  static Variants<RadialDistribution> all{&radial_distribution_entry<LunSavage>,
                                          &radial_distribution_entry<CarnahanStarling>,
                                          &radial_distribution_entry<MaAhmadi>};
  return all;
}

}  // namespace scree
