/// How the nodes of a grid lie in the arrays of files.
#pragma once

#include "scree/grid/lattice.hpp"
#include "scree/output/hdf5_file.hpp"

namespace scree {

/// A block of nodes; axes beyond the dimension hold one node.
struct NodeBlock {
  Index first, count{{1, 1, 1}};

  std::size_t size() const { return static_cast<std::size_t>(count[0]) * count[1] * count[2]; }
};

/// The grid of `dm`. Throws std::runtime_error if its dimension, stencil width or node counts are not those that `box`
/// asks for.
Lattice checked_lattice(const Box& box, DM dm);

/// Unknowns a node of `dm`.
int unknowns_of(DM dm);

/// Nodes an axis of the whole grid: cells + 1, or cells on a periodic axis.
Index nodes_of(const Lattice& grid);

/// The nodes of this rank.
NodeBlock owned_block(const Lattice& grid);

/// This rank's part of an array with `shape` entries an axis, entry I being held where node I is; an entry beyond the
/// nodes (upper face of a periodic axis) goes with the last one.
NodeBlock part_of(const Lattice& grid, const Index& shape);

/// `block` of an array with `shape`, as HDF5 wants it: slowest axis first; `width` > 0 adds an innermost index.
Slab slab_of(int dim, const Index& shape, const NodeBlock& block, int width = 0);

/// Communicator of a grid.
MPI_Comm communicator(DM dm);

}  // namespace scree
