/// How the nodes of a DMDA lie on the ranks, and their values with ghosts.
#pragma once

#include <petscdmda.h>

#include <array>
#include <string>
#include <vector>

#include "scree/grid/box.hpp"
#include "scree/output/hdf5_file.hpp"

namespace scree {

/// A block of nodes; axes beyond the dimension hold one node.
struct NodeBlock {
  std::array<int, max_dim> start{0, 0, 0}, count{1, 1, 1};

  size_t size() const { return static_cast<size_t>(count[0]) * count[1] * count[2]; }
  bool contains(const std::array<int, max_dim>& node) const;
  /// Position of a node in an array over the block, first axis fastest.
  size_t offset(const std::array<int, max_dim>& node) const;
};

/// Nodes of this rank and of all ranks.
struct NodeLayout {
  int dim = 1, dof = 1;
  std::array<int, max_dim> nodes{1, 1, 1};  ///< of the whole grid: cells + 1, or cells on a periodic axis
  NodeBlock owned, ghosted;

  /// This rank's part of an array with `shape` entries an axis, entry I being held where node I is; an entry beyond the
  /// nodes (upper face of a periodic axis) goes with the last one.
  NodeBlock part_of(const std::array<int, max_dim>& shape) const;
};

/// Layout of `dm`. Throws std::runtime_error if its dimension or node counts are not those that `box` asks for.
NodeLayout node_layout(const Box& box, DM dm);

/// `block` of an array with `shape`, as HDF5 wants it: slowest axis first; `width` > 0 adds an innermost index.
Slab slab_of(int dim, const std::array<int, max_dim>& shape, const NodeBlock& block, int width = 0);

/// Communicator of a PETSc object.
MPI_Comm communicator(DM dm);

/// Calls work(node) for all nodes of a block, first axis fastest.
template <class Work>
void for_each_node(const NodeBlock& block, Work work) {
  std::array<int, max_dim> node;
  for (node[2] = block.start[2]; node[2] < block.start[2] + block.count[2]; ++node[2]) {
    for (node[1] = block.start[1]; node[1] < block.start[1] + block.count[1]; ++node[1]) {
      for (node[0] = block.start[0]; node[0] < block.start[0] + block.count[0]; ++node[0]) work(node);
    }
  }
}

/// Stored values of a state on this rank's nodes and their neighbours. Construction is collective.
class GhostedState {
 public:
  GhostedState(DM dm, const NodeLayout& layout, Vec state);
  ~GhostedState();
  GhostedState(const GhostedState&) = delete;
  GhostedState& operator=(const GhostedState&) = delete;

  double operator()(const std::array<int, max_dim>& node, int component) const {
    return values_[layout_.ghosted.offset(node) * layout_.dof + component];
  }

 private:
  DM dm_;
  const NodeLayout& layout_;
  Vec local_ = nullptr;
  const PetscScalar* values_ = nullptr;
};

}  // namespace scree
