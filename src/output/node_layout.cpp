#include "scree/output/node_layout.hpp"

#include <stdexcept>
#include <type_traits>

#include "scree/output/errors.hpp"

namespace scree {

static_assert(std::is_same_v<PetscScalar, double>, "files hold real double precision numbers");

bool NodeBlock::contains(const std::array<int, max_dim>& node) const {
  for (int axis = 0; axis < max_dim; ++axis) {
    if (node[axis] < start[axis] || node[axis] >= start[axis] + count[axis]) return false;
  }
  return true;
}

size_t NodeBlock::offset(const std::array<int, max_dim>& node) const {
  const size_t row = static_cast<size_t>(node[2] - start[2]) * count[1] + (node[1] - start[1]);
  return row * count[0] + (node[0] - start[0]);
}

NodeBlock NodeLayout::part_of(const std::array<int, max_dim>& shape) const {
  NodeBlock part;
  for (int axis = 0; axis < max_dim; ++axis) {
    int end = owned.start[axis] + owned.count[axis];
    if (end == nodes[axis] || end > shape[axis]) end = shape[axis];
    part.start[axis] = std::min(owned.start[axis], end);
    part.count[axis] = end - part.start[axis];
  }
  return part;
}

MPI_Comm communicator(DM dm) {
  MPI_Comm comm = MPI_COMM_NULL;
  check_petsc(PetscObjectGetComm(reinterpret_cast<PetscObject>(dm), &comm), "communicator of the grid");
  return comm;
}

NodeLayout node_layout(const Box& box, DM dm) {
  PetscInt dim = 0, dof = 0, width = 0;
  std::array<PetscInt, max_dim> nodes{}, start{}, count{}, ghost_start{}, ghost_count{};
  check_petsc(DMDAGetInfo(dm, &dim, &nodes[0], &nodes[1], &nodes[2], nullptr, nullptr, nullptr, &dof, &width, nullptr,
                          nullptr, nullptr, nullptr),
              "layout of the grid");
  check_petsc(DMDAGetCorners(dm, &start[0], &start[1], &start[2], &count[0], &count[1], &count[2]),
              "layout of the grid");
  check_petsc(DMDAGetGhostCorners(dm, &ghost_start[0], &ghost_start[1], &ghost_start[2], &ghost_count[0],
                                  &ghost_count[1], &ghost_count[2]),
              "layout of the grid");
  if (dim != box.dim || width < 1) throw std::runtime_error("output: dimension or stencil width of the DMDA is wrong");
  NodeLayout layout;
  layout.dim = static_cast<int>(dim);
  layout.dof = static_cast<int>(dof);
  for (int axis = 0; axis < dim; ++axis) {
    if (nodes[axis] != box.cells(axis) + (box.periodic[axis] ? 0 : 1)) {
      throw std::runtime_error("output: nodes of the DMDA do not fit the cells of the box");
    }
    layout.nodes[axis] = static_cast<int>(nodes[axis]);
    layout.owned.start[axis] = static_cast<int>(start[axis]);
    layout.owned.count[axis] = static_cast<int>(count[axis]);
    layout.ghosted.start[axis] = static_cast<int>(ghost_start[axis]);
    layout.ghosted.count[axis] = static_cast<int>(ghost_count[axis]);
  }
  return layout;
}

Slab slab_of(int dim, const std::array<int, max_dim>& shape, const NodeBlock& block, int width) {
  Slab slab;
  for (int axis = dim - 1; axis >= 0; --axis) {
    slab.shape.push_back(shape[axis]);
    slab.start.push_back(block.start[axis]);
    slab.count.push_back(block.count[axis]);
  }
  if (width > 0) {
    slab.shape.push_back(width);
    slab.start.push_back(0);
    slab.count.push_back(width);
  }
  return slab;
}

GhostedState::GhostedState(DM dm, const NodeLayout& layout, Vec state) : dm_(dm), layout_(layout) {
  check_petsc(DMGetLocalVector(dm, &local_), "ghost values");
  check_petsc(DMGlobalToLocal(dm, state, INSERT_VALUES, local_), "ghost values");
  check_petsc(VecGetArrayRead(local_, &values_), "ghost values");
}

GhostedState::~GhostedState() {
  if (values_) (void)VecRestoreArrayRead(local_, &values_);
  if (local_) (void)DMRestoreLocalVector(dm_, &local_);
}

}  // namespace scree
