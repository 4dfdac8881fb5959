/// From the grid of one box to that of another: means of cells over what they share, velocities between faces. Axis by
/// axis, with limited slopes inside the cells that are taken from, so that what was smooth stays so.
#pragma once

#include <functional>
#include <vector>

#include "scree/grid/index.hpp"

namespace scree {

/// What one cell or face of the other grid gives to a cell or face, along an axis.
struct TransferPart {
  int at = 0;         ///< cell or face of the other grid
  double weight = 1;  ///< its share; all of a cell or face add up to 1
  double offset = 0;  ///< from the centre of that cell to the middle of what is shared [m]
};

/// What the cells with these faces give to a cell from `lower` to `upper`, which lies within them [m]: overlaps.
std::vector<TransferPart> cell_parts(const std::vector<double>& faces, double lower, double upper);
/// What these faces give to one at `position` between the first and the last: linear interpolation.
std::vector<TransferPart> face_parts(const std::vector<double>& faces, double position);

/// Takes values from the grid of `from`. Values are asked for by the nodes of that grid: a cell with its lower faces;
/// beyond a periodic end they are those at the other one.
class Transfer {
 public:
  using Values = std::function<double(const Index&)>;
  using Parts = std::array<std::vector<TransferPart>, max_dim>;

  explicit Transfer(const Box& from) : from_(from) {}

  /// Parts of a cell, or with face_axis >= 0 of a face of that axis, given by its bounds; those along face_axis are the
  /// same.
  Parts parts(const std::array<double, max_dim>& lower, const std::array<double, max_dim>& upper, int face_axis) const;
  /// Mean over the parts. For cells and without `weight` it is conservative: cells that share out a cell of `from` have
  /// together what that has. Bounded by the values about. With `weight` >= 0, a value of the same places, parts count
  /// by it too.
  double mean(const Parts& parts, int face_axis, const Values& values, const Values& weight = {}) const;

 private:
  double value_in(const Index& cell, const Index& choice, const Parts& parts, int face_axis,
                  const Values& values) const;
  bool has(int axis, int cell) const { return from_.periodic[axis] || (cell >= 0 && cell < from_.cells(axis)); }
  double distance(int axis, int cell) const;  ///< from the centre of the cell before to that of `cell` [m]

  const Box& from_;
};

}  // namespace scree
