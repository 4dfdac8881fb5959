#include "scree/config/case.hpp"

#include <algorithm>

namespace scree {

bool InitialRegion::holds(const std::array<double, max_dim>& point, int dim) const {
  for (int axis = 0; axis < dim; ++axis)
    if (point[axis] < lower[axis] || point[axis] > upper[axis]) return false;
  return true;
}

const InitialRegion* Case::solids_region(const std::array<double, max_dim>& point) const {
  const InitialRegion* last = nullptr;
  for (const InitialRegion& region : initial)
    if (region.gives_solids_fraction() && region.holds(point, box.dim)) last = &region;
  return last;
}

bool Case::has_particles() const {
  return std::any_of(segments.begin(), segments.end(),
                     [](const Segment& s) { return brings_particles(s.condition); }) ||
         std::any_of(initial.begin(), initial.end(), [](const InitialRegion& region) {
           return region.has_own_solids_fraction() || region.uniform_solids_fraction() > 0;
         });
}

bool brings_particles(const Condition& condition) {
  return condition.kind.brings_solids() && condition.brought(SolidsContinuity::unknown) > 0;
}

}  // namespace scree
