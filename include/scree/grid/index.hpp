/// Integer coordinates of cells and their lower faces, and offsets between them, in one to three dimensions.
///
///        +-----------+-----------+
///        |           |           |      Cell I = (i, j). Its lower x face, at (I, axis 0), is the left one; its lower
///        |  I - e_x  >     I     >      y face is the bottom one. The upper x face of I is the lower one of I + e_x.
///        |           |           |      Edge I of the axes (a, b) is where the lower a face and the lower b face of
///        +-----^-----+-----^-----+      cell I meet.
///              edge I^
#pragma once

#include <array>

#include "scree/grid/box.hpp"

namespace scree {

/// Cell coordinates, or an offset between cells; entries of axes >= dim are zero.
struct Index {
  std::array<int, max_dim> at{0, 0, 0};

  constexpr int operator[](int axis) const { return at[static_cast<std::size_t>(axis)]; }
  constexpr int& operator[](int axis) { return at[static_cast<std::size_t>(axis)]; }
  friend constexpr Index operator+(Index a, const Index& b) {
    for (int axis = 0; axis < max_dim; ++axis) a[axis] += b[axis];
    return a;
  }
  friend constexpr Index operator-(Index a, const Index& b) {
    for (int axis = 0; axis < max_dim; ++axis) a[axis] -= b[axis];
    return a;
  }
  friend constexpr Index operator*(int factor, Index a) {
    for (int axis = 0; axis < max_dim; ++axis) a[axis] *= factor;
    return a;
  }
  friend constexpr bool operator==(const Index& a, const Index& b) {
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
  }
};

/// e_axis.
constexpr Index unit(int axis) {
  Index e;
  e[axis] = 1;
  return e;
}

}  // namespace scree
