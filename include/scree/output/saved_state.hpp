/// The last state of a run on the grid that it had, for a run that starts from it on another one.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scree/grid/unknown.hpp"
#include "scree/output/node_block.hpp"

namespace scree {

struct SavedState {
  std::string file;            ///< the checkpoint that it comes from
  std::string remark;          ///< empty, or one line for the log: which newer file was damaged, and how
  double time = 0;             ///< [s]
  Box box;                     ///< of that run
  std::vector<Field> fields;   ///< dataset, component, face_axis, scale and unit; no unknown of ours
  int unknowns = 0;            ///< a node
  NodeBlock block;             ///< nodes whose values this rank holds
  std::vector<double> values;  ///< stored values of the block, interlaced

  const Field* find(const std::string& dataset, int face_axis) const;  ///< nullptr: that run has no such field
  /// The SI value of a field at a node of the block; along a periodic axis nodes beyond an end are those at the other.
  double value(const Field& field, Index node) const;
};

/// Nodes of a grid, an axis: cells + 1, or cells on a periodic axis.
Index nodes_of(const Box& box);

/// Collective. Reads the newest sound checkpoint of `source`: an output directory, its checkpoints/, or one file.
/// `wanted` says, on each rank, which nodes of the grid of that run it needs; what it throws has to come on all ranks
/// alike. The whole state is checked, whoever needs it. Throws std::runtime_error of one line on all ranks: none there,
/// not a checkpoint, another version, truncated, checksum, NaN.
SavedState read_state(MPI_Comm comm, const std::string& source, const std::function<NodeBlock(const Box&)>& wanted);

}  // namespace scree
