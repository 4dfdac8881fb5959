/// How the grid is shared out: numbers only.
#pragma once

#include <array>
#include <optional>

#include "scree/grid/index.hpp"

namespace scree {

/// Along each axis: nodes of the grid, ranks that share them, whether it is periodic. 1 node beyond the last axis.
struct SharedGrid {
  std::array<int, max_dim> nodes{1, 1, 1};
  std::array<bool, max_dim> periodic{false, false, false};
  std::array<int, max_dim> given{0, 0, 0};  ///< ranks asked for by the user; 0: free
  int stencil_width = 1;                    ///< nodes that a rank needs at least along an axis that is shared
};

using RankSplit = std::array<int, max_dim>;

/// Ranks along each axis such that the stencils of each reach no farther than into its neighbours: PETSc's choice if
/// that works, otherwise what sends least. Nothing if no split of `ranks` works.
std::optional<RankSplit> split_over_ranks(const SharedGrid& grid, int ranks);

/// The greatest number up to `ranks` that works, 0 if none does.
int most_ranks(const SharedGrid& grid, int ranks);

}  // namespace scree
