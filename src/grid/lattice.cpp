#include "scree/grid/lattice.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>

#include "scree/grid/rank_split.hpp"

namespace scree {

Axis::Axis(const std::vector<double>& faces, bool periodic)
    : cells_(static_cast<int>(faces.size()) - 1), periodic_(periodic) {
  const int entries = cells_ + 2 * halo + 1;
  width_.resize(entries);
  distance_.resize(entries);
  face_.resize(entries);
  lower_share_.resize(entries);
  const auto width_of = [&](int i) {
    while (i < 0 || i >= cells_) {
      if (periodic)
        i += i < 0 ? cells_ : -cells_;
      else
        i = i < 0 ? -1 - i : 2 * cells_ - 1 - i;
    }
    return faces[i + 1] - faces[i];
  };
  for (int i = -halo; i <= cells_ + halo; ++i) {
    const double below = width_of(i - 1), here = width_of(i);
    width_[i + halo] = here;
    distance_[i + halo] = 0.5 * (below + here);
    lower_share_[i + halo] = below / (below + here);
  }
  for (int i = 0; i <= cells_; ++i) face_[i + halo] = faces[i];
  for (int i = -1; i >= -halo; --i) face_[i + halo] = face_[i + 1 + halo] - width_[i + halo];
  for (int i = cells_ + 1; i <= cells_ + halo; ++i) face_[i + halo] = face_[i - 1 + halo] + width_[i - 1 + halo];
}

Lattice::Lattice(const Box& box, DM dm) : dim(box.dim) {
  for (int axis = 0; axis < max_dim; ++axis)
    axes[axis] = axis < dim ? Axis(box.faces[axis], box.periodic[axis]) : Axis({0.0, 1.0}, false);
  DMDAGetCorners(dm, &owned_first[0], &owned_first[1], &owned_first[2], &owned_count[0], &owned_count[1],
                 &owned_count[2]);
  DMDAGetGhostCorners(dm, &ghosted_first[0], &ghosted_first[1], &ghosted_first[2], &ghosted_count[0], &ghosted_count[1],
                      &ghosted_count[2]);
}

bool Lattice::is_owned(const Index& I) const {
  for (int axis = 0; axis < max_dim; ++axis)
    if (I[axis] < owned_first[axis] || I[axis] >= owned_first[axis] + owned_count[axis]) return false;
  return true;
}

bool Lattice::is_ghosted(const Index& I) const {
  for (int axis = 0; axis < max_dim; ++axis)
    if (I[axis] < ghosted_first[axis] || I[axis] >= ghosted_first[axis] + ghosted_count[axis]) return false;
  return true;
}

double Lattice::volume(const Index& I) const {
  double volume = 1;
  for (int axis = 0; axis < dim; ++axis) volume *= axes[axis].width(I[axis]);
  return volume;
}

double Lattice::face_area(int axis, const Index& I) const {
  double area = 1;
  for (int a = 0; a < dim; ++a)
    if (a != axis) area *= axes[a].width(I[a]);
  return area;
}

double Lattice::control_length(int axis, const Index& I) const {
  return (on_side(axis, I) ? 0.5 : 1.0) * axes[axis].distance(I[axis]);
}

namespace {

[[noreturn]] void refuse_ranks(const Box& box, const SharedGrid& grid, int ranks) {
  std::string cells;
  for (int axis = 0; axis < box.dim; ++axis) cells += (axis > 0 ? " x " : "") + std::to_string(box.cells(axis));
  const std::string width = std::to_string(grid.stencil_width);
  const int most = most_ranks(grid, ranks);
  if (most == 0)
    throw std::runtime_error("a grid of " + cells + " cells: expected at least " + width + " along a periodic axis");
  throw std::runtime_error("a grid of " + cells + " cells on " + std::to_string(ranks) + " ranks: expected at most " +
                           std::to_string(most) + ", each with " + width +
                           " nodes or more along an axis that is shared");
}

/// What of `dm` decides how it can be split over ranks.
PetscErrorCode shared_grid(const Box& box, int stencil_width, DM dm, SharedGrid& grid) {
  PetscFunctionBeginUser;
  PetscInt nodes[max_dim], given[max_dim];
  PetscCall(DMDAGetInfo(dm, nullptr, &nodes[0], &nodes[1], &nodes[2], &given[0], &given[1], &given[2], nullptr, nullptr,
                        nullptr, nullptr, nullptr, nullptr));
  grid.stencil_width = stencil_width;
  for (int axis = 0; axis < box.dim; ++axis) {
    grid.nodes[axis] = static_cast<int>(nodes[axis]);
    grid.periodic[axis] = box.periodic[axis];
    grid.given[axis] = std::max(0, static_cast<int>(given[axis]));
  }
  PetscFunctionReturn(0);
}

/// A DMDA with its options, not yet set up.
PetscErrorCode begin_dm(MPI_Comm comm, const Box& box, int unknowns, int stencil_width, DM* dm) {
  PetscFunctionBeginUser;
  DMBoundaryType ends[max_dim];
  PetscInt nodes[max_dim] = {1, 1, 1};
  for (int axis = 0; axis < max_dim; ++axis) {
    const bool periodic = axis < box.dim && box.periodic[axis];
    ends[axis] = periodic ? DM_BOUNDARY_PERIODIC : DM_BOUNDARY_GHOSTED;
    if (axis < box.dim) nodes[axis] = box.cells(axis) + (periodic ? 0 : 1);
  }
  if (box.dim == 1)
    PetscCall(DMDACreate1d(comm, ends[0], nodes[0], unknowns, stencil_width, nullptr, dm));
  else if (box.dim == 2)
    PetscCall(DMDACreate2d(comm, ends[0], ends[1], DMDA_STENCIL_BOX, nodes[0], nodes[1], PETSC_DECIDE, PETSC_DECIDE,
                           unknowns, stencil_width, nullptr, nullptr, dm));
  else
    PetscCall(DMDACreate3d(comm, ends[0], ends[1], ends[2], DMDA_STENCIL_BOX, nodes[0], nodes[1], nodes[2],
                           PETSC_DECIDE, PETSC_DECIDE, PETSC_DECIDE, unknowns, stencil_width, nullptr, nullptr, nullptr,
                           dm));
  PetscCall(DMSetFromOptions(*dm));
  PetscFunctionReturn(0);
}

}  // namespace

/// The DMDA is split over the ranks in a way that works. PETSc would find out for each rank alone whether its part is
/// wide enough: some would end, the others wait for them. No PetscFunctionBegin: PETSc's stack would keep what an
/// exception leaves.
PetscErrorCode create_dm(MPI_Comm comm, const Box& box, int unknowns, int stencil_width, DM* dm) {
  SharedGrid grid;
  int ranks;
  PetscCallMPI(MPI_Comm_size(comm, &ranks));
  PetscCall(begin_dm(comm, box, unknowns, stencil_width, dm));
  PetscCall(shared_grid(box, stencil_width, *dm, grid));
  const auto split = split_over_ranks(grid, ranks);
  if (!split) {
    PetscCall(DMDestroy(dm));
    refuse_ranks(box, grid, ranks);
  }
  if (box.dim > 1) PetscCall(DMDASetNumProcs(*dm, (*split)[0], (*split)[1], (*split)[2]));
  PetscCall(DMSetUp(*dm));
  for (int axis = 0; axis < box.dim; ++axis) PetscCall(set_faces(*dm, axis, box.faces[axis]));
  return 0;
}

static std::string faces_key(int axis) { return "scree_faces_" + std::to_string(axis); }

PetscErrorCode set_faces(DM dm, int axis, const std::vector<double>& faces) {
  PetscFunctionBeginUser;
  Vec positions;
  PetscScalar* entries;
  PetscCall(VecCreateSeq(PETSC_COMM_SELF, static_cast<PetscInt>(faces.size()), &positions));
  PetscCall(VecGetArrayWrite(positions, &entries));
  std::copy(faces.begin(), faces.end(), entries);
  PetscCall(VecRestoreArrayWrite(positions, &entries));
  PetscCall(PetscObjectCompose(reinterpret_cast<PetscObject>(dm), faces_key(axis).c_str(),
                               reinterpret_cast<PetscObject>(positions)));
  PetscCall(VecDestroy(&positions));
  PetscFunctionReturn(0);
}

PetscErrorCode get_faces(DM dm, int axis, int cells, std::vector<double>& faces) {
  PetscFunctionBeginUser;
  Vec positions;
  const PetscScalar* entries;
  PetscCall(PetscObjectQuery(reinterpret_cast<PetscObject>(dm), faces_key(axis).c_str(),
                             reinterpret_cast<PetscObject*>(&positions)));
  faces.resize(static_cast<std::size_t>(cells) + 1);
  std::iota(faces.begin(), faces.end(), 0.0);
  if (!positions) PetscFunctionReturn(0);
  PetscCall(VecGetArrayRead(positions, &entries));
  std::copy(entries, entries + cells + 1, faces.begin());
  PetscCall(VecRestoreArrayRead(positions, &entries));
  PetscFunctionReturn(0);
}

}  // namespace scree
