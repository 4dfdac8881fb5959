/// Samples of the sides of the box in space and time: one point for each combination of segments that can hold.
#pragma once

#include <array>
#include <set>
#include <string>
#include <vector>

#include "scree/boundary/segment.hpp"
#include "scree/grid/box.hpp"

namespace scree {

/// "x_lower" and so on.
std::string side_name(int axis, bool upper);

/// The middles between the distinct values of `cuts` that lie in (lower, upper).
std::vector<double> middles(std::set<double> cuts, double lower, double upper);

/// The segments of a side in the order of the list.
std::vector<Segment> segments_of_side(const std::vector<Segment>& segments, int axis, bool upper);

/// Sample points of a side [m]: one in each rectangle that the edges of its segments cut out; 0 along `normal`.
std::vector<std::array<double, max_dim>> side_samples(const Box& box, int normal, const std::vector<Segment>& segments);

/// The segment of those of a side that holds at a point and time: the last one there; null if there is none.
const Segment* holding(const std::vector<Segment>& segments, const std::array<double, max_dim>& point, int dim,
                       double time);

}  // namespace scree
