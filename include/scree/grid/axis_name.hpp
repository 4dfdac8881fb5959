/// The letters of the axes.
#pragma once

#include <string>

#include "scree/grid/box.hpp"

namespace scree {

constexpr const char* axis_names[max_dim] = {"x", "y", "z"};

/// "x", "y" or "z".
inline std::string axis_name(int axis) { return axis_names[axis]; }

}  // namespace scree
