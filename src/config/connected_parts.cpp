#include "scree/config/connected_parts.hpp"

#include <map>
#include <set>

namespace scree {
namespace {

bool inside(const Patch& patch, const std::array<double, max_dim>& point, int normal, int dim) {
  for (int axis = 0; axis < dim; ++axis) {
    if (axis != normal && !(point[axis] > patch.lower[axis] && point[axis] < patch.upper[axis])) return false;
  }
  return true;
}

bool closes(const Plate& plate, const std::array<double, max_dim>& point, int dim) {
  if (!inside(plate.span, point, plate.axis, dim)) return false;
  for (const Patch& opening : plate.openings)
    if (inside(opening, point, plate.axis, dim)) return false;
  return true;
}

/// The edges of a patch along all axes but its normal (-1: all).
void add_edges(const Patch& patch, int normal, const Box& box, std::array<std::set<double>, max_dim>& cuts) {
  for (int axis = 0; axis < box.dim; ++axis) {
    if (axis == normal) continue;
    for (const double edge : {patch.lower[axis], patch.upper[axis]})
      if (edge > box.lower(axis) && edge < box.upper(axis)) cuts[axis].insert(edge);
  }
}

}  // namespace

ConnectedParts::ConnectedParts(const Box& box, const std::vector<Segment>& segments, const std::vector<Plate>& plates,
                               const std::vector<Patch>& more)
    : box_(box) {
  std::array<std::set<double>, max_dim> cuts;
  for (int axis = 0; axis < box.dim; ++axis) cuts[axis] = {box.lower(axis), box.upper(axis)};
  for (const Segment& segment : segments) add_edges(segment.patch, segment.axis, box, cuts);
  for (const Patch& patch : more) add_edges(patch, -1, box, cuts);
  for (const Plate& plate : plates) {
    cuts[plate.axis].insert(plate.position);
    add_edges(plate.span, plate.axis, box, cuts);
    for (const Patch& opening : plate.openings) add_edges(opening, plate.axis, box, cuts);
  }
  for (int axis = 0; axis < box.dim; ++axis) planes_[axis].assign(cuts[axis].begin(), cuts[axis].end());
  make_blocks();
  join(plates);
  number_parts();
  make_side_faces();
}

int ConnectedParts::number(const Place& place) const {
  int number = 0;
  for (int axis = box_.dim - 1; axis >= 0; --axis)
    number = number * (static_cast<int>(planes_[axis].size()) - 1) + place[axis];
  return number;
}

void ConnectedParts::make_blocks() {
  places_ = {Place{}};
  for (int axis = box_.dim - 1; axis >= 0; --axis) {  // the first axis runs fastest, as in number()
    std::vector<Place> finer;
    for (Place place : places_) {
      for (place[axis] = 0; place[axis] + 1 < static_cast<int>(planes_[axis].size()); ++place[axis])
        finer.push_back(place);
    }
    places_ = finer;
  }
  for (const Place& place : places_) {
    Block block;
    for (int axis = 0; axis < box_.dim; ++axis) {
      const double lower = planes_[axis][place[axis]], upper = planes_[axis][place[axis] + 1];
      block.centre[axis] = 0.5 * (lower + upper);
      block.volume *= upper - lower;
    }
    blocks_.push_back(block);
    parents_.push_back(static_cast<int>(parents_.size()));
  }
}

void ConnectedParts::join(const std::vector<Plate>& plates) {
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    for (int axis = 0; axis < box_.dim; ++axis) {
      Place next = places_[b];
      const bool last = ++next[axis] + 1 == static_cast<int>(planes_[axis].size());
      if (last && !box_.periodic[axis]) continue;
      if (last) next[axis] = 0;
      const double face = planes_[axis][places_[b][axis] + 1];
      bool closed = false;
      for (const Plate& plate : plates)
        closed = closed || (plate.axis == axis && plate.position == face && closes(plate, blocks_[b].centre, box_.dim));
      if (!closed) parents_[root(static_cast<int>(b))] = root(number(next));
    }
  }
}

int ConnectedParts::root(int block) {
  while (parents_[block] != block) block = parents_[block] = parents_[parents_[block]];
  return block;
}

void ConnectedParts::number_parts() {
  std::map<int, int> numbers;
  for (std::size_t b = 0; b < blocks_.size(); ++b)
    blocks_[b].part = numbers.insert({root(static_cast<int>(b)), static_cast<int>(numbers.size())}).first->second;
  count_ = static_cast<int>(numbers.size());
}

void ConnectedParts::make_side_faces() {
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    for (int axis = 0; axis < box_.dim; ++axis) {
      for (const bool upper : {false, true}) {
        const int end = upper ? static_cast<int>(planes_[axis].size()) - 2 : 0;
        if (box_.periodic[axis] || places_[b][axis] != end) continue;
        const double width = planes_[axis][end + 1] - planes_[axis][end];
        SideFace face{axis, upper, blocks_[b].centre, blocks_[b].volume / width, blocks_[b].part};
        face.centre[axis] = upper ? box_.upper(axis) : box_.lower(axis);
        side_faces_.push_back(face);
      }
    }
  }
}

}  // namespace scree
