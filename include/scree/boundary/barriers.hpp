/// Which faces of the grid are not plain interior ones: sides of the box and internal plates, as a condition a face.
#pragma once

#include <cstdint>
#include <vector>

#include "scree/boundary/segment.hpp"
#include "scree/grid/lattice.hpp"

namespace scree {

/// Conditions of the faces that a rank sees.
class Barriers {
 public:
  /// State of the time windows at `time`. Every face of a side that is not periodic must be covered by a segment.
  Barriers(const Lattice& lattice, const std::vector<Segment>& segments, const std::vector<Plate>& plates, double time);

  /// Whether the lower `axis` face of I carries a condition.
  bool at(int axis, const Index& I) const { return face_[axis][lattice_->ghosted(I)] != 0; }
  /// Its condition; at(axis, I) must hold.
  const Condition& condition(int axis, const Index& I) const {
    return conditions_[face_[axis][lattice_->ghosted(I)] - 1];
  }
  /// Whether a side of the box, or a part of one, is open: the same on all ranks.
  bool some_open() const { return some_open_; }
  /// Whether it keeps the particles back.
  bool wall(int axis, const Index& I) const { return at(axis, I) && condition(axis, I).kind.stops_solids(); }
  /// Whether some face within the width of the ghost layer from I, in any direction, carries a condition.
  bool near(const Index& I) const { return near_[lattice_->ghosted(I)] != 0; }

 private:
  void mark_sides(const std::vector<Segment>& segments, double time);
  void mark_plates(const std::vector<Plate>& plates, double time);
  void mark_neighbourhood();

  const Lattice* lattice_;
  std::vector<Condition> conditions_;
  std::array<std::vector<std::uint8_t>, max_dim> face_;  ///< over ghosted nodes: 0 or 1 + position in conditions_
  std::vector<std::uint8_t> near_;
  bool some_open_ = false;
};

}  // namespace scree
