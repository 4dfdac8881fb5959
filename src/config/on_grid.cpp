#include <cmath>

#include "scree/config/case_options.hpp"

namespace scree {
namespace {

/// `value`, moved onto the nearest grid plane of `axis`; infinite values (the whole side) stay.
double on_plane(const Box& box, int axis, double value, const std::string& key) {
  constexpr double tolerance = 1e-6;  // of the cell size
  if (!std::isfinite(value)) return value;
  const std::vector<double>& faces = box.faces[axis];
  const auto nearest = std::min_element(faces.begin(), faces.end(),
                                        [&](double a, double b) { return std::abs(a - value) < std::abs(b - value); });
  const double below = nearest == faces.begin() ? nearest[1] - nearest[0] : nearest[0] - nearest[-1];
  const double above = nearest + 1 == faces.end() ? below : nearest[1] - nearest[0];
  if (std::abs(*nearest - value) <= tolerance * std::min(below, above)) return *nearest;
  throw InputError(key, number_text(value) + " m",
                   std::string("a grid plane of axis ") + axis_names[axis] + "; the nearest is at " +
                       number_text(*nearest, 9) + " m (cells there are " + number_text(std::min(below, above), 9) +
                       " m)");
}

/// Along all axes but `normal` and `free` (-1: none), on which its edges may lie anywhere.
void put_patch(const Box& box, int normal, Patch& patch, const std::string& key, int free = -1) {
  for (int axis = 0; axis < box.dim; ++axis) {
    if (axis == normal) continue;
    if (axis != free) {
      patch.lower[axis] = on_plane(box, axis, patch.lower[axis], key);
      patch.upper[axis] = on_plane(box, axis, patch.upper[axis], key);
    }
    if (!(patch.lower[axis] < patch.upper[axis]))
      throw InputError(key, number_text(patch.lower[axis]) + ", " + number_text(patch.upper[axis]),
                       std::string("lower below upper along axis ") + axis_names[axis]);
  }
}

/// Where and when the inlet is.
void put_variation(const Box& box, const Segment& segment, InletVariation& variation) {
  variation.begin = std::isfinite(segment.condition.from) ? segment.condition.from : 0;
  for (int axis = 0; axis < box.dim; ++axis) {
    if (axis == segment.axis) continue;
    variation.lower[axis] = std::max(segment.patch.lower[axis], box.lower(axis));
    variation.upper[axis] = std::min(segment.patch.upper[axis], box.upper(axis));
  }
}

/// A region that another run fills takes whole cells, so that they hold all of what is theirs.
void put_region(const Box& box, InitialRegion& region) {
  for (int axis = 0; axis < box.dim && !region.run.empty(); ++axis) {
    for (double* edge : {&region.lower[axis], &region.upper[axis]})
      if (*edge > box.lower(axis) && *edge < box.upper(axis))
        *edge = on_plane(box, axis, *edge, "initial_" + region.name + "_box");
  }
}

}  // namespace

void put_on_grid(Case& the_case) {
  const Box& box = the_case.box;
  for (InitialRegion& region : the_case.initial) put_region(box, region);
  for (Segment& segment : the_case.segments) {
    put_patch(box, segment.axis, segment.patch, "boundary_" + segment.condition.name + "_patch");
    for (InletVariation* variation : {&segment.condition.variation, &segment.condition.gas_variation})
      put_variation(box, segment, *variation);
  }
  for (Plate& plate : the_case.plates) {
    const std::string key = "plate_" + plate.condition.name + "_";
    plate.position = on_plane(box, plate.axis, plate.position, key + "position");
    const int free = plate.slides() ? plate.slide_axis : -1;
    put_patch(box, plate.axis, plate.span, key + "span", free);
    for (Patch& opening : plate.openings) put_patch(box, plate.axis, opening, key + "openings", free);
  }
  for (FluxPlane& flux : the_case.flux_planes) {
    flux.position = on_plane(box, flux.axis, flux.position, "flux_" + flux.name + "_position");
    put_patch(box, flux.axis, flux.patch, "flux_" + flux.name + "_patch");
  }
}

}  // namespace scree
