/// Where a user wants to see fields: named points and named lines.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "scree/grid/box.hpp"

namespace scree {

using Point = std::array<double, max_dim>;

/// A named point at which monitor.csv reports fields. `fields` are names of datasets ("velocity": all its components)
/// or of one component ("velocity_x"); empty: all.
struct Probe {
  std::string name;
  Point point{};
  std::vector<std::string> fields;
};

/// A named segment, sampled at the cell centres along the axis that it crosses most of. `fields` as for Probe.
struct Line {
  std::string name;
  Point from{}, to{};
  std::vector<std::string> fields;
};

}  // namespace scree
