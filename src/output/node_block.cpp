#include "scree/output/node_block.hpp"

#include <algorithm>
#include <stdexcept>
#include <type_traits>

#include "scree/output/errors.hpp"

namespace scree {

static_assert(std::is_same_v<PetscScalar, double>, "files hold real double precision numbers");

MPI_Comm communicator(DM dm) {
  MPI_Comm comm = MPI_COMM_NULL;
  check_petsc(PetscObjectGetComm(reinterpret_cast<PetscObject>(dm), &comm), "communicator of the grid");
  return comm;
}

Lattice checked_lattice(const Box& box, DM dm) {
  PetscInt dim = 0, width = 0, nodes[max_dim];
  check_petsc(DMDAGetInfo(dm, &dim, &nodes[0], &nodes[1], &nodes[2], nullptr, nullptr, nullptr, nullptr, &width,
                          nullptr, nullptr, nullptr, nullptr),
              "layout of the grid");
  if (dim != box.dim || width < 1) throw std::runtime_error("output: dimension or stencil width of the DMDA is wrong");
  Lattice grid(box, dm);
  for (int axis = 0; axis < box.dim; ++axis) {
    if (nodes[axis] != nodes_of(grid)[axis])
      throw std::runtime_error("output: nodes of the DMDA do not fit the cells of the box");
  }
  return grid;
}

int unknowns_of(DM dm) {
  PetscInt unknowns = 0;
  check_petsc(DMDAGetDof(dm, &unknowns), "layout of the grid");
  return static_cast<int>(unknowns);
}

Index nodes_of(const Lattice& grid) {
  Index nodes{{1, 1, 1}};
  for (int axis = 0; axis < grid.dim; ++axis)
    nodes[axis] = grid.axes[axis].cells() + (grid.axes[axis].periodic() ? 0 : 1);
  return nodes;
}

NodeBlock owned_block(const Lattice& grid) { return {grid.owned_first, grid.owned_count}; }

NodeBlock part_of(const Lattice& grid, const Index& shape) {
  const Index nodes = nodes_of(grid);
  NodeBlock part;
  for (int axis = 0; axis < max_dim; ++axis) {
    int end = grid.owned_first[axis] + grid.owned_count[axis];
    if (end == nodes[axis] || end > shape[axis]) end = shape[axis];
    part.first[axis] = std::min(grid.owned_first[axis], end);
    part.count[axis] = end - part.first[axis];
  }
  return part;
}

Slab slab_of(int dim, const Index& shape, const NodeBlock& block, int width) {
  Slab slab;
  const auto add = [&](int entries, int first, int count) {
    slab.shape.push_back(static_cast<hsize_t>(entries));
    slab.start.push_back(static_cast<hsize_t>(first));
    slab.count.push_back(static_cast<hsize_t>(count));
  };
  for (int axis = dim - 1; axis >= 0; --axis) add(shape[axis], block.first[axis], block.count[axis]);
  if (width > 0) add(width, 0, width);
  return slab;
}

}  // namespace scree
