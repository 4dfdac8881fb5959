#include "scree/grid/rank_split.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace scree {

namespace {

bool works(const SharedGrid& grid, const RankSplit& split) {
  for (int axis = 0; axis < max_dim; ++axis) {
    if (grid.given[axis] > 0 && grid.given[axis] != split[axis]) return false;
    const bool meets_neighbours = split[axis] > 1 || grid.periodic[axis];
    if (meets_neighbours && grid.nodes[axis] / split[axis] < grid.stencil_width) return false;
  }
  return true;
}

/// The greatest divisor of `number` up to `wanted`, 1 at least.
int divisor_near(int number, double wanted) {
  int divisor = std::max(1, static_cast<int>(std::lround(wanted)));
  while (number % divisor != 0) --divisor;
  return divisor;
}

/// As in DMSetUp_DA_2D and _3D of PETSc, the latter for grids with a third axis.
RankSplit petsc_split(const SharedGrid& grid, int ranks) {
  const double x = grid.nodes[0], y = grid.nodes[1], z = grid.nodes[2];
  if (grid.nodes[1] == 1) return {ranks, 1, 1};
  const bool third = grid.nodes[2] > 1;
  const int along_y = third ? divisor_near(ranks, std::cbrt(y * y * ranks / (z * x))) : 1, rest = ranks / along_y;
  const double other = third ? z : y;
  int first = divisor_near(rest, std::sqrt(x * rest / other)), last = rest / first;
  if (x > other && first < last) std::swap(first, last);
  return third ? RankSplit{first, along_y, last} : RankSplit{first, last, 1};
}

}  // namespace

std::optional<RankSplit> split_over_ranks(const SharedGrid& grid, int ranks) {
  if (const RankSplit split = petsc_split(grid, ranks); works(grid, split)) return split;
  std::optional<RankSplit> best;
  double least = 0;
  for (int i = 1; i <= ranks; ++i)
    for (int j = 1; i * j <= ranks; ++j) {
      const RankSplit split{i, j, ranks / (i * j)};
      if (ranks % (i * j) != 0 || !works(grid, split)) continue;
      double sent = 0;  // the faces between ranks, over the nodes of the grid
      for (int axis = 0; axis < max_dim; ++axis) sent += static_cast<double>(split[axis]) / grid.nodes[axis];
      if (!best || sent < least) {
        best = split;
        least = sent;
      }
    }
  return best;
}

int most_ranks(const SharedGrid& grid, int ranks) {
  while (ranks > 0 && !split_over_ranks(grid, ranks)) --ranks;
  return ranks;
}

}  // namespace scree
