#include "scree/closures/effective_restitution.hpp"

#include "scree/closures/effective_restitution/chialvo_sundaresan.hpp"
#include "scree/closures/effective_restitution/jenkins_zhang.hpp"

namespace scree {

const EffectiveRestitution* default_effective_restitution() { return &effective_restitution_entry<ChialvoSundaresan>; }

Variants<EffectiveRestitution>& effective_restitutions() {
  static Variants<EffectiveRestitution> all{&effective_restitution_entry<ChialvoSundaresan>,
                                            &effective_restitution_entry<JenkinsZhang>};
  return all;
}

}  // namespace scree
