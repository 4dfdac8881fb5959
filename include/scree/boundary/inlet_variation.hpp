/// How the velocity that an inlet prescribes varies over its patch and in time.
#pragma once

#include <array>
#include <vector>

#include "scree/grid/box.hpp"

namespace scree {

/// A factor that is piecewise linear in a coordinate or in time and constant beyond its ends; 1 if it has no points.
struct Ramp {
  std::vector<double> at;      ///< ascending [m or s]
  std::vector<double> factor;  ///< as many [-]

  double value(double x) const;
};

/// Where a face lies: its bounds along the axes in its plane [m].
struct FaceExtent {
  std::array<double, max_dim> lower{}, upper{};

  double centre(int axis) const { return 0.5 * (lower[axis] + upper[axis]); }
};

/// Shapes over a patch, s = -1 ... 1 across it along each axis; all have mean 1: uniform; parabolic, 3/2 (1 - s^2);
/// power, (1 + 1/n) (1 - |s|)^(1/n), as in turbulent pipes.
enum class InletShape { uniform, parabolic, power };

/// A factor on a velocity: shape times profile times history times start.
struct InletVariation {
  InletShape shape = InletShape::uniform;
  double exponent = 7;                           ///< n of the power law
  std::array<double, max_dim> lower{}, upper{};  ///< of the patch in the box; equal where the shape does not vary [m]
  int axis = 0;                                  ///< along the side, of the coordinates of `profile`
  Ramp profile;                                  ///< by coordinate along that axis
  Ramp history;                                  ///< by time
  double begin = 0;                              ///< when the start begins [s]
  double rise_time = 0;                          ///< it rises smoothly from 0 to 1 in that time, x^2 (3 - 2x) [s]

  /// Mean of the factor over a face: exact for shapes, so that faces bring the mean over the patch together; the
  /// profile is taken at the centre.
  double value(const FaceExtent& face, double time) const;
  /// The part that depends on time alone.
  double in_time(double time) const;
};

}  // namespace scree
