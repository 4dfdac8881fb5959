/// The box a scene lives in: extent, face positions per axis, periodicity.
#pragma once

#include <array>
#include <vector>

namespace scree {

constexpr int max_dim = 3;

/// A box of cells, described by the positions of the cell faces along each axis.
struct Box {
  int dim = 2;                                     ///< 1, 2 or 3
  std::array<std::vector<double>, max_dim> faces;  ///< ascending, cells(axis)+1 entries [m]; axes >= dim are empty
  std::array<bool, max_dim> periodic{false, false, false};

  int cells(int axis) const { return static_cast<int>(faces[axis].size()) - 1; }
  double lower(int axis) const { return faces[axis].front(); }
  double upper(int axis) const { return faces[axis].back(); }
};

}  // namespace scree
