#include "scree/closures/correlation_length.hpp"

#include "scree/closures/correlation_length/berzi_vescovi.hpp"
#include "scree/closures/correlation_length/jenkins.hpp"

namespace scree {

Variants<CorrelationLength>& correlation_lengths() {
  static Variants<CorrelationLength> all{&correlation_length_entry<JenkinsLength>,
                                         &correlation_length_entry<BerziVescovi>};
  return all;
}

}  // namespace scree
