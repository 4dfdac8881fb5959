/// Remarks on numbers that a user hardly means. Cells smaller than a particle are none: grids of the paper have them.
#include <cmath>
#include <limits>

#include "scree/config/case_options.hpp"

namespace scree {
namespace {

constexpr double fewest_across = 5;  ///< particles across a box or opening: grains arch over less, a continuum does not
constexpr double dense = 0.5;        ///< solids fraction of a bed, whose particles carry each other

using Point = std::array<double, max_dim>;

/// The last region there that gives a solids fraction.
bool bed_at(const Case& scene, const Point& place) {
  bool bed = false;
  for (const InitialRegion& region : scene.initial) {
    bool there = region.gives_solids_fraction();
    for (int axis = 0; axis < scene.box.dim; ++axis)
      there = there && place[axis] >= region.lower[axis] && place[axis] <= region.upper[axis];
    if (there) bed = region.profile == InitialRegion::Profile::equilibrium || region.uniform_solids_fraction() >= dense;
  }
  return bed;
}

bool brings_particles(const Condition& condition) {
  return condition.kind.brings_solids() && condition.brought(SolidsContinuity::unknown) > 0;
}

bool has_particles(const Case& scene) {
  for (const InitialRegion& region : scene.initial) {
    if (region.has_own_solids_fraction() || region.uniform_solids_fraction() > 0) return true;
  }
  for (const Segment& segment : scene.segments)
    if (brings_particles(segment.condition)) return true;
  return false;
}

bool mirrored(const Case& scene, int axis, bool upper) {
  for (const Segment& segment : scene.segments)
    if (segment.axis == axis && segment.upper == upper && segment.condition.kind == BoundaryKind::symmetry) return true;
  return false;
}

/// Width of the part of a patch along an axis that lies in the box, with its mirror image [m]; infinite where the patch
/// ends only at sides that are no planes of symmetry, or goes round.
double width_along(const Case& scene, const Patch& patch, int axis) {
  const Box& box = scene.box;
  const bool to_lower = patch.lower[axis] <= box.lower(axis), to_upper = patch.upper[axis] >= box.upper(axis);
  if (to_lower && to_upper) return std::numeric_limits<double>::infinity();
  const double width = std::min(patch.upper[axis], box.upper(axis)) - std::max(patch.lower[axis], box.lower(axis));
  const bool twice = (to_lower && mirrored(scene, axis, false)) || (to_upper && mirrored(scene, axis, true));
  return twice ? 2 * width : width;
}

double narrowest(const Case& scene, const Patch& patch, int normal) {
  double width = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < scene.box.dim; ++axis)
    if (axis != normal) width = std::min(width, width_along(scene, patch, axis));
  return width;
}

std::string in_particles(const Case& scene, double length) {
  return number_text(length, 3) + " m, " + number_text(length / scene.kinetic.d, 3) + " particle diameters";
}

void add_box(const Case& scene, std::vector<std::string>& remarks) {
  for (int axis = 0; axis < scene.box.dim; ++axis) {
    const double width = scene.box.upper(axis) - scene.box.lower(axis);
    if (scene.box.periodic[axis] || width >= fewest_across * scene.kinetic.d) continue;
    remarks.push_back("particle_diameter = " + number_text(scene.kinetic.d) + " m is odd: the box along " +
                      axis_names[axis] + " is " + in_particles(scene, width));
  }
}

void add_opening(const Case& scene, const Patch& patch, int normal, const std::string& key,
                 std::vector<std::string>& remarks) {
  const double width = narrowest(scene, patch, normal);
  if (width < fewest_across * scene.kinetic.d)
    remarks.push_back(key + " is odd: it leaves a width of " + in_particles(scene, width) +
                      "; grains arch over less than about 5, which the equations do not know");
}

/// A place half a cell inside the box behind the middle of a segment.
Point behind(const Case& scene, const Segment& segment) {
  const Box& box = scene.box;
  Point place{};
  for (int axis = 0; axis < box.dim; ++axis) {
    const double lower = std::max(segment.patch.lower[axis], box.lower(axis));
    const double upper = std::min(segment.patch.upper[axis], box.upper(axis));
    place[axis] = 0.5 * (lower + upper);
  }
  const std::vector<double>& faces = box.faces[segment.axis];
  const std::size_t first = segment.upper ? faces.size() - 2 : 0;
  place[segment.axis] = 0.5 * (faces[first] + faces[first + 1]);
  return place;
}

/// `open` prescribes no stress: a bed on a part of a side keeps its pressure and stays.
void add_outlet(const Case& scene, const Segment& segment, std::vector<std::string>& remarks) {
  const bool whole = std::isinf(narrowest(scene, segment.patch, segment.axis));
  const bool carries = scene.friction.model != FrictionModel::none && scene.model.solids_moving;
  if (whole || !carries || !bed_at(scene, behind(scene, segment))) return;
  remarks.push_back("boundary_" + segment.condition.name +
                    "_kind = open is odd: a bed lies on this part of a side and may not pass it; put a plate with the "
                    "opening some cells inside and leave the whole side open");
}

}  // namespace

std::vector<std::string> odd_numbers(const Case& scene) {
  std::vector<std::string> remarks;
  if (!has_particles(scene)) return remarks;
  add_box(scene, remarks);
  for (const Plate& plate : scene.plates) {
    for (const Patch& opening : plate.openings)
      add_opening(scene, opening, plate.axis, "plate_" + plate.condition.name + "_openings", remarks);
  }
  for (const Segment& segment : scene.segments) {
    const Condition& condition = segment.condition;
    if (condition.kind.lets_solids_out() || brings_particles(condition))
      add_opening(scene, segment.patch, segment.axis, "boundary_" + condition.name + "_patch", remarks);
    if (condition.kind.lets_solids_out()) add_outlet(scene, segment, remarks);
  }
  return remarks;
}

}  // namespace scree
