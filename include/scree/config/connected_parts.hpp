/// The parts of the box that plates and sides close off from each other.
#pragma once

#include <array>
#include <vector>

#include "scree/boundary/segment.hpp"
#include "scree/grid/box.hpp"

namespace scree {

/// A rectangle of a side that no edge of a segment, plate or opening cuts, and the part that it bounds.
struct SideFace {
  int axis = 0;
  bool upper = false;
  std::array<double, max_dim> centre{};  ///< [m]
  double area = 1;                       ///< product of its widths: m2 in three dimensions, m in two, 1 in one
  int part = 0;
};

/// A cuboid that no such edge cuts, and the part that it belongs to.
struct Block {
  std::array<double, max_dim> centre{};  ///< [m]
  double volume = 1;                     ///< product of its widths
  int part = 0;
};

/// The box cut by the planes of all edges into blocks; blocks without a plate between them belong together. All edges
/// lie on grid planes, so that the parts are those of the grid, at the cost of a few blocks.
class ConnectedParts {
 public:
  /// `more` are boxes lower, upper whose faces cut too.
  ConnectedParts(const Box& box, const std::vector<Segment>& segments, const std::vector<Plate>& plates,
                 const std::vector<Patch>& more = {});

  const std::vector<Block>& blocks() const { return blocks_; }
  /// Of the sides that are not periodic.
  const std::vector<SideFace>& side_faces() const { return side_faces_; }
  int count() const { return count_; }

 private:
  using Place = std::array<int, max_dim>;

  int number(const Place& place) const;
  void make_blocks();
  void join(const std::vector<Plate>& plates);
  void number_parts();
  void make_side_faces();
  int root(int block);

  const Box& box_;
  std::array<std::vector<double>, max_dim> planes_;
  std::vector<Place> places_;
  std::vector<Block> blocks_;
  std::vector<int> parents_;
  std::vector<SideFace> side_faces_;
  int count_ = 0;
};

}  // namespace scree
