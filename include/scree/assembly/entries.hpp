/// Where the entries of a Jacobian go.
#pragma once

#include <cstdint>
#include <vector>

namespace scree {

/// One number for each entry that the sweep over the kernels produces, in its order.
/// place >= 0: position among the entries of the diagonal block; place <= -2: -2 - position in the off-diagonal block;
/// -1: outside of the grid, dropped.
using EntryPlaces = std::vector<std::int32_t>;

/// Receives (local row, ghosted column unknown) of each Jacobian entry, in the order of the sweep. The column counts
/// node * unknowns + component over ghosted nodes.
class EntrySink {
 public:
  virtual ~EntrySink() = default;
  virtual void entry(int row, int ghosted_column) = 0;
};

}  // namespace scree
