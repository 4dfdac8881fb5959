/// Remarks on numbers that a user hardly means. Cells smaller than a particle are none: grids of the paper have them.
#include <cmath>
#include <limits>

#include "scree/config/case_options.hpp"

namespace scree {
namespace {

constexpr double fewest_across = 5;  ///< particles across a box or opening: grains arch over less, a continuum does not

bool mirrored(const Case& the_case, int axis, bool upper) {
  for (const Segment& segment : the_case.segments)
    if (segment.axis == axis && segment.upper == upper && segment.condition.kind == BoundaryKind::symmetry) return true;
  return false;
}

/// Width of the part of a patch along an axis that lies in the box, with its mirror image [m]; infinite where the patch
/// ends only at sides that are no planes of symmetry, or goes round.
double width_along(const Case& the_case, const Patch& patch, int axis) {
  const Box& box = the_case.box;
  const bool to_lower = patch.lower[axis] <= box.lower(axis), to_upper = patch.upper[axis] >= box.upper(axis);
  if (to_lower && to_upper) return std::numeric_limits<double>::infinity();
  const double width = std::min(patch.upper[axis], box.upper(axis)) - std::max(patch.lower[axis], box.lower(axis));
  const bool twice = (to_lower && mirrored(the_case, axis, false)) || (to_upper && mirrored(the_case, axis, true));
  return twice ? 2 * width : width;
}

double narrowest(const Case& the_case, const Patch& patch, int normal) {
  double width = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < the_case.box.dim; ++axis)
    if (axis != normal) width = std::min(width, width_along(the_case, patch, axis));
  return width;
}

std::string in_particles(const Case& the_case, double length) {
  return number_text(length, 3) + " m, " + number_text(length / the_case.kinetic.d, 3) + " particle diameters";
}

/// The gravity of the earth against the last axis of the box, as an option.
std::string downwards(int dim) {
  std::string text;
  for (int axis = 1; axis < dim; ++axis) text += "0, ";
  return text + "-9.81";
}

void add_box(const Case& the_case, std::vector<std::string>& remarks) {
  for (int axis = 0; axis < the_case.box.dim; ++axis) {
    const double width = the_case.box.upper(axis) - the_case.box.lower(axis);
    if (the_case.box.periodic[axis] || width >= fewest_across * the_case.kinetic.d) continue;
    remarks.push_back("particle_diameter = " + number_text(the_case.kinetic.d) + " m is odd: the box along " +
                      axis_names[axis] + " is " + in_particles(the_case, width));
  }
}

void add_opening(const Case& the_case, const Patch& patch, int normal, const std::string& key,
                 std::vector<std::string>& remarks) {
  const double width = narrowest(the_case, patch, normal);
  if (width < fewest_across * the_case.kinetic.d)
    remarks.push_back(key + " is odd: it leaves a width of " + in_particles(the_case, width) +
                      "; grains arch over less than about 5, which the equations do not know");
}

}  // namespace

std::vector<std::string> odd_numbers(const Case& the_case, const CaseInput& input) {
  std::vector<std::string> remarks;
  if (!the_case.has_particles()) return remarks;
  if (input.find("gravity") == nullptr)
    remarks.push_back("gravity is not given: it is 0; \"gravity: " + downwards(the_case.box.dim) +
                      "\" is that of the earth");
  add_box(the_case, remarks);
  for (const Plate& plate : the_case.plates) {
    for (const Patch& opening : plate.openings)
      add_opening(the_case, opening, plate.axis, "plate_" + plate.condition.name + "_openings", remarks);
  }
  for (const Segment& segment : the_case.segments) {
    const Condition& condition = segment.condition;
    if (condition.kind.lets_solids_out() || brings_particles(condition))
      add_opening(the_case, segment.patch, segment.axis, "boundary_" + condition.name + "_patch", remarks);
  }
  return remarks;
}

}  // namespace scree
