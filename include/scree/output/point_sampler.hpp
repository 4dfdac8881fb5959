/// Values of fields at arbitrary points of the box, by (bi-, tri-)linear interpolation.
#pragma once

#include <petscdmda.h>

#include <array>
#include <vector>

#include "scree/grid/sampling.hpp"
#include "scree/grid/unknown.hpp"

namespace scree {

/// A point and a field to be taken there.
struct Sample {
  Point point;
  Field field;
};

/// Interpolates between the places where a field lives (cell centres, or faces along its axis). Between the outermost
/// of them and the side of the box the value is constant; points outside count as on the side; periodic axes wrap.
class PointSampler {
 public:
  /// Throws std::runtime_error when grid and dm do not belong together.
  PointSampler(const Box& box, DM dm, const std::vector<Sample>& samples);

  /// Collective. Values in SI, one a sample, on all ranks, the same bit by bit for any number of ranks.
  std::vector<double> values(Vec state) const;

 private:
  static constexpr int corners = 1 << max_dim;
  /// Weight of one node's value; offset < 0: the node lives on another rank (or counts nothing).
  struct Corner {
    PetscInt offset;
    double weight;
  };
  DM dm_;
  std::vector<std::array<Corner, corners>> stencils_;
};

}  // namespace scree
