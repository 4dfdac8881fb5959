#include "scree/config/side_samples.hpp"

#include <algorithm>
#include <iterator>

#include "scree/config/case_options.hpp"

namespace scree {
namespace {

bool holds_at(const Segment& segment, const std::array<double, max_dim>& point, int dim, double time) {
  if (time < segment.condition.from || time > segment.condition.until) return false;
  for (int axis = 0; axis < dim; ++axis) {
    if (axis == segment.axis) continue;
    if (point[axis] < segment.patch.lower[axis] || point[axis] > segment.patch.upper[axis]) return false;
  }
  return true;
}

}  // namespace

std::string side_name(int axis, bool upper) { return std::string(axis_names[axis]) + (upper ? "_upper" : "_lower"); }

std::vector<double> middles(std::set<double> cuts, double lower, double upper) {
  cuts.insert({lower, upper});
  std::vector<double> points;
  for (auto cut = cuts.lower_bound(lower); *cut < upper; ++cut) points.push_back(0.5 * (*cut + *std::next(cut)));
  return points;
}

std::vector<Segment> segments_of_side(const std::vector<Segment>& segments, int axis, bool upper) {
  std::vector<Segment> side;
  std::copy_if(segments.begin(), segments.end(), std::back_inserter(side),
               [&](const Segment& s) { return s.axis == axis && s.upper == upper; });
  return side;
}

std::vector<std::array<double, max_dim>> side_samples(const Box& box, int normal,
                                                      const std::vector<Segment>& segments) {
  std::vector<std::array<double, max_dim>> points{{}};
  for (int axis = 0; axis < box.dim; ++axis) {
    if (axis == normal) continue;
    std::set<double> cuts;
    for (const Segment& segment : segments) cuts.insert({segment.patch.lower[axis], segment.patch.upper[axis]});
    std::vector<std::array<double, max_dim>> refined;
    for (const double coordinate : middles(cuts, box.lower(axis), box.upper(axis))) {
      for (auto point : points) {
        point[axis] = coordinate;
        refined.push_back(point);
      }
    }
    points = refined;
  }
  return points;
}

const Segment* holding(const std::vector<Segment>& segments, const std::array<double, max_dim>& point, int dim,
                       double time) {
  const auto last =
      std::find_if(segments.rbegin(), segments.rend(), [&](const Segment& s) { return holds_at(s, point, dim, time); });
  return last == segments.rend() ? nullptr : &*last;
}

}  // namespace scree
