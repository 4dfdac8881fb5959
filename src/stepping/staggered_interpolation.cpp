#include "scree/stepping/staggered_interpolation.hpp"

#include <algorithm>

#include "scree/grid/lattice.hpp"

namespace scree {

NodeGrid::NodeGrid(DM dm) {
  PetscInt d, all[max_dim], parts[max_dim], at[max_dim], size[max_dim];
  DMBoundaryType ends[max_dim];
  const PetscInt* ranges[max_dim];
  PetscCallAbort(PETSC_COMM_SELF, DMDAGetInfo(dm, &d, &all[0], &all[1], &all[2], &parts[0], &parts[1], &parts[2],
                                              nullptr, nullptr, &ends[0], &ends[1], &ends[2], nullptr));
  PetscCallAbort(PETSC_COMM_SELF, DMDAGetCorners(dm, &at[0], &at[1], &at[2], &size[0], &size[1], &size[2]));
  PetscCallAbort(PETSC_COMM_SELF, DMDAGetOwnershipRanges(dm, &ranges[0], &ranges[1], &ranges[2]));
  dim = static_cast<int>(d);
  for (int axis = 0; axis < max_dim; ++axis) {
    owned[axis] = {1};
    if (axis >= dim) continue;
    nodes[axis] = static_cast<int>(all[axis]);
    first[axis] = static_cast<int>(at[axis]);
    count[axis] = static_cast<int>(size[axis]);
    periodic[axis] = ends[axis] == DM_BOUNDARY_PERIODIC;
    PetscCallAbort(PETSC_COMM_SELF, get_faces(dm, axis, cells(axis), faces[axis]));
    owned[axis].assign(ranges[axis], ranges[axis] + parts[axis]);
  }
}

namespace {

constexpr int fewest_cells = 4;  ///< of an axis that is still coarsened

/// Nodes of the coarse axis on each part of it: those whose faces the part has.
std::vector<PetscInt> coarse_ranges(const NodeGrid& fine, int axis, const CoarseAxis& coarse) {
  std::vector<PetscInt> result;
  PetscInt end = 0;
  int node = 0;
  const int nodes = coarse.cells() + (fine.periodic[axis] ? 0 : 1);
  for (const PetscInt count : fine.owned[axis]) {
    end += count;
    const int begin = node;
    while (node < nodes && coarse.first(node) < end) ++node;
    result.push_back(node - begin);
  }
  return result;
}

/// The axis as it is where a rank would be left without a node, or where it has few cells already.
CoarseAxis coarsened(const NodeGrid& fine, int axis, double widest) {
  if (axis >= fine.dim) return {{0, 1}, 0};
  CoarseAxis wider(fine.faces[axis], widest);
  const auto ranges = coarse_ranges(fine, axis, wider);
  const bool possible = fine.cells(axis) >= fewest_cells && *std::min_element(ranges.begin(), ranges.end()) > 0;
  return possible ? wider : CoarseAxis(fine.faces[axis], 0);
}

}  // namespace

std::array<CoarseAxis, max_dim> coarsened(const NodeGrid& fine, double widest) {
  return {coarsened(fine, 0, widest), coarsened(fine, 1, widest), coarsened(fine, 2, widest)};
}

PetscErrorCode create_coarse_dm(DM fine_dm, const std::array<CoarseAxis, max_dim>& axes, PetscInt unknowns,
                                DM* coarse) {
  PetscFunctionBeginUser;
  const NodeGrid fine(fine_dm);
  std::array<std::vector<PetscInt>, max_dim> ranges;
  PetscInt nodes[max_dim] = {1, 1, 1}, parts[max_dim] = {1, 1, 1};
  DMBoundaryType ends[max_dim] = {DM_BOUNDARY_NONE, DM_BOUNDARY_NONE, DM_BOUNDARY_NONE};
  for (int axis = 0; axis < fine.dim; ++axis) {
    ranges[axis] = coarse_ranges(fine, axis, axes[axis]);
    parts[axis] = static_cast<PetscInt>(ranges[axis].size());
    if (fine.periodic[axis]) ends[axis] = DM_BOUNDARY_PERIODIC;
    nodes[axis] = axes[axis].cells() + (fine.periodic[axis] ? 0 : 1);
  }
  PetscCall(DMDACreate(PetscObjectComm(reinterpret_cast<PetscObject>(fine_dm)), coarse));
  PetscCall(DMSetDimension(*coarse, fine.dim));
  PetscCall(DMDASetSizes(*coarse, nodes[0], nodes[1], nodes[2]));
  PetscCall(DMDASetNumProcs(*coarse, parts[0], parts[1], parts[2]));
  PetscCall(DMDASetOwnershipRanges(*coarse, ranges[0].data(), fine.dim > 1 ? ranges[1].data() : nullptr,
                                   fine.dim > 2 ? ranges[2].data() : nullptr));
  PetscCall(DMDASetBoundaryType(*coarse, ends[0], ends[1], ends[2]));
  PetscCall(DMDASetDof(*coarse, unknowns));
  PetscCall(DMDASetStencilType(*coarse, DMDA_STENCIL_BOX));
  PetscCall(DMDASetStencilWidth(*coarse, 1));
  PetscCall(DMSetUp(*coarse));
  for (int axis = 0; axis < fine.dim; ++axis) PetscCall(set_faces(*coarse, axis, axes[axis].faces()));
  PetscFunctionReturn(0);
}

namespace {

/// Calls work(coarse node, weight) for the nodes from which unknown `face_axis` of node I has its value.
class Parents {
 public:
  explicit Parents(const std::array<CoarseAxis, max_dim>& axes) : axes_(axes) {}

  template <class Work>
  void each(const Index& I, PetscInt face_axis, Work&& work) const {
    std::array<AxisWeights, max_dim> w;
    for (int axis = 0; axis < max_dim; ++axis) w[axis] = along(axis, I[axis], face_axis);
    for (int z = 0; z < w[2].count; ++z)
      for (int y = 0; y < w[1].count; ++y)
        for (int x = 0; x < w[0].count; ++x)
          work(Index{{w[0].place[x], w[1].place[y], w[2].place[z]}}, w[0].weight[x] * w[1].weight[y] * w[2].weight[z]);
  }

  /// The node of the coarse grid whose unknown is at the same place, a cell at that of the coarse cell it lies in;
  /// false where there is none.
  bool same_place(const Index& I, PetscInt face_axis, Index* node) const {
    for (int axis = 0; axis < max_dim; ++axis) {
      const AxisWeights w = along(axis, I[axis], face_axis);
      if (w.count == 2) return false;
      (*node)[axis] = w.place[0];
    }
    return true;
  }

 private:
  AxisWeights along(int axis, int i, PetscInt face_axis) const {
    return face_axis == axis ? axes_[axis].face(i) : axes_[axis].cell(i);
  }
  const std::array<CoarseAxis, max_dim>& axes_;
};

/// The unknowns of a DMDA's nodes, ghosts among them, by their local and global numbers.
class Numbers {
 public:
  explicit Numbers(DM dm, PetscInt unknowns) : unknowns_(unknowns) {
    PetscInt first[max_dim], count[max_dim];
    PetscCallAbort(PETSC_COMM_SELF,
                   DMDAGetGhostCorners(dm, &first[0], &first[1], &first[2], &count[0], &count[1], &count[2]));
    for (int axis = 0; axis < max_dim; ++axis) {
      first_[axis] = static_cast<int>(first[axis]);
      count_[axis] = static_cast<int>(count[axis]);
    }
    PetscCallAbort(PETSC_COMM_SELF, DMGetLocalToGlobalMapping(dm, &map_));
    PetscCallAbort(PETSC_COMM_SELF, ISLocalToGlobalMappingGetIndices(map_, &global_));
  }
  ~Numbers() { PetscCallAbort(PETSC_COMM_SELF, ISLocalToGlobalMappingRestoreIndices(map_, &global_)); }
  Numbers(const Numbers&) = delete;
  Numbers& operator=(const Numbers&) = delete;

  PetscInt local(const Index& I, PetscInt component) const {
    return (((I[2] - first_[2]) * count_[1] + (I[1] - first_[1])) * count_[0] + (I[0] - first_[0])) * unknowns_ +
           component;
  }
  PetscInt global(const Index& I, PetscInt component) const { return global_[local(I, component)]; }

 private:
  PetscInt unknowns_;
  Index first_, count_;
  ISLocalToGlobalMapping map_ = nullptr;
  const PetscInt* global_ = nullptr;
};

/// How many unknowns at the place of a coarse one are free: a vector of `coarse`.
PetscErrorCode count_free(const NodeGrid& fine, const Parents& parents, const Numbers& numbers,
                          const std::vector<PetscInt>& face_axis, const std::vector<char>& fixed, Vec free) {
  PetscFunctionBeginUser;
  const auto unknowns = static_cast<PetscInt>(face_axis.size());
  std::size_t row = 0;
  PetscErrorCode failed = 0;
  for_each_node(fine.first, fine.count, [&](const Index& I) {
    for (PetscInt c = 0; c < unknowns; ++c, ++row) {
      Index node;
      if (fixed[row] || !parents.same_place(I, face_axis[static_cast<std::size_t>(c)], &node)) continue;
      failed = failed ? failed : VecSetValue(free, numbers.global(node, c), 1, ADD_VALUES);
    }
  });
  PetscCall(failed);
  PetscCall(VecAssemblyBegin(free));
  PetscCall(VecAssemblyEnd(free));
  PetscFunctionReturn(0);
}

}  // namespace

PetscErrorCode create_interpolation(DM fine_dm, DM coarse_dm, const std::array<CoarseAxis, max_dim>& axes,
                                    const std::vector<PetscInt>& face_axis, std::vector<char>& fixed,
                                    Mat* interpolation) {
  PetscFunctionBeginUser;
  const NodeGrid fine(fine_dm);
  const Parents parents(axes);
  const auto unknowns = static_cast<PetscInt>(face_axis.size());
  const Numbers numbers(coarse_dm, unknowns);
  const PetscScalar* free;
  Vec free_here, free_ghosted;
  PetscInt columns, first_row;
  PetscCall(DMCreateGlobalVector(coarse_dm, &free_here));
  PetscCall(DMCreateLocalVector(coarse_dm, &free_ghosted));
  PetscCall(count_free(fine, parents, numbers, face_axis, fixed, free_here));
  PetscCall(DMGlobalToLocal(coarse_dm, free_here, INSERT_VALUES, free_ghosted));
  PetscCall(VecGetLocalSize(free_here, &columns));
  PetscCall(MatCreateAIJ(PetscObjectComm(reinterpret_cast<PetscObject>(fine_dm)), static_cast<PetscInt>(fixed.size()),
                         columns, PETSC_DETERMINE, PETSC_DETERMINE, 2, nullptr, 2, nullptr, interpolation));
  PetscCall(MatGetOwnershipRange(*interpolation, &first_row, nullptr));
  PetscCall(VecGetArrayRead(free_ghosted, &free));
  std::size_t row = 0;
  PetscErrorCode failed = 0;
  for_each_node(fine.first, fine.count, [&](const Index& I) {
    for (PetscInt c = 0; c < unknowns; ++c, ++row) {
      const PetscInt axis = face_axis[static_cast<std::size_t>(c)];
      const auto add = [&](const Index& node, double weight) {
        if (!failed)
          failed = MatSetValue(*interpolation, first_row + static_cast<PetscInt>(row), numbers.global(node, c), weight,
                               INSERT_VALUES);
      };
      if (Index node; !fixed[row])
        parents.each(I, axis, [&](const Index& from, double weight) {
          if (free[numbers.local(from, c)] > 0) add(from, weight);
        });
      else if (parents.same_place(I, axis, &node) && free[numbers.local(node, c)] == 0)
        add(node, 1);  // so that the row of the coarse unknown fixes it as well
    }
  });
  PetscCall(failed);
  PetscCall(MatAssemblyBegin(*interpolation, MAT_FINAL_ASSEMBLY));
  PetscCall(MatAssemblyEnd(*interpolation, MAT_FINAL_ASSEMBLY));
  PetscCall(VecRestoreArrayRead(free_ghosted, &free));
  PetscCall(VecGetArrayRead(free_here, &free));
  fixed.assign(static_cast<std::size_t>(columns), 0);
  for (PetscInt k = 0; k < columns; ++k) fixed[static_cast<std::size_t>(k)] = free[k] == 0;
  PetscCall(VecRestoreArrayRead(free_here, &free));
  PetscCall(VecDestroy(&free_here));
  PetscCall(VecDestroy(&free_ghosted));
  PetscFunctionReturn(0);
}

}  // namespace scree
