#include "scree/boundary/segment.hpp"

#include <algorithm>

namespace scree {

double Ramp::value(double x) const {
  if (at.empty()) return 1;
  const auto after = std::upper_bound(at.begin(), at.end(), x) - at.begin();
  if (after == 0) return factor.front();
  if (after == static_cast<std::ptrdiff_t>(at.size())) return factor.back();
  const double share = (x - at[after - 1]) / (at[after] - at[after - 1]);
  return factor[after - 1] + share * (factor[after] - factor[after - 1]);
}

double gas_inflow(const Condition& condition, const std::array<double, max_dim>& place, double time) {
  return condition.gas_velocity * condition.gas_profile.value(place[condition.gas_profile_axis]) *
         condition.gas_history.value(time);
}

}  // namespace scree
