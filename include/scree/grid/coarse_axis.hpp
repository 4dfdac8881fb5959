/// An axis with fewer and wider cells, and where places of the finer one have their values from.
#pragma once

#include <array>
#include <vector>

namespace scree {

/// Up to two places of an axis, with the share of each.
struct AxisWeights {
  int count = 1;
  std::array<int, 2> place{};
  std::array<double, 2> weight{{1, 0}};
};

/// Cells of an axis made wider: two neighbours become one where both together are not wider than a bound. A graded axis
/// is thus coarsened where it is fine, so that cells of several axes with one bound become less flat.
class CoarseAxis {
 public:
  /// faces: ascending, one more than cells [m]. widest: the bound [m]; 0 leaves the axis as it is.
  CoarseAxis(const std::vector<double>& faces, double widest);

  int cells() const { return static_cast<int>(first_.size()) - 1; }
  const std::vector<double>& faces() const { return faces_; }  ///< of the wider cells [m]
  /// The finer cell with which cell i begins; of i = cells() the end of the axis.
  int first(int i) const { return first_[static_cast<std::size_t>(i)]; }

  /// Of finer cell i: the wider cell it lies in; of the one past the end, padding, the padding.
  AxisWeights cell(int i) const { return {1, {within_[static_cast<std::size_t>(i)], 0}, {1, 0}}; }
  /// Of finer face i: the line between the faces of the wider cells.
  AxisWeights face(int i) const;

 private:
  std::vector<int> first_, within_;
  std::vector<double> finer_, faces_;
};

}  // namespace scree
