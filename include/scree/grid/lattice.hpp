/// The part of the grid that a rank sees: metrics per axis and the numbering of owned and ghosted nodes.
#pragma once

#include <petscdmda.h>

#include <vector>

#include "scree/grid/index.hpp"

namespace scree {

/// Cells beyond each end for which metrics exist, and the widest stencil that a DMDA of this project has.
constexpr int halo = 3;

/// Metrics of one axis. Beyond a closed end they continue by mirroring, beyond a periodic one by wrapping.
class Axis {
 public:
  Axis() = default;
  Axis(const std::vector<double>& faces, bool periodic);

  int cells() const { return cells_; }
  bool periodic() const { return periodic_; }
  double width(int i) const { return width_[i + halo]; }        ///< of cell i [m]
  double distance(int i) const { return distance_[i + halo]; }  ///< of the centres of cells i-1 and i, about face i [m]
  double face(int i) const { return face_[i + halo]; }          ///< position of face i, the lower one of cell i [m]
  double centre(int i) const { return face(i) + 0.5 * width(i); }
  /// Share of cell i-1 in the control volume about face i; the share of cell i is the rest [-].
  double lower_share(int i) const { return lower_share_[i + halo]; }

 private:
  int cells_ = 1;
  bool periodic_ = false;
  std::vector<double> width_, distance_, face_, lower_share_;
};

/// Nodes of a rank. A node is a cell with its lower faces; an axis that is not periodic has one node more than cells,
/// whose lower face is the upper side of the box and whose cell is padding.
class Lattice {
 public:
  /// `dm` as made by create_dm.
  Lattice(const Box& box, DM dm);

  int dim;
  std::array<Axis, max_dim> axes;
  Index owned_first, owned_count;      ///< nodes of this rank
  Index ghosted_first, ghosted_count;  ///< with those of its neighbours and beyond the box

  /// Position of a node among the ghosted ones / among the owned ones.
  int ghosted(const Index& I) const {
    return ((I[2] - ghosted_first[2]) * ghosted_count[1] + (I[1] - ghosted_first[1])) * ghosted_count[0] +
           (I[0] - ghosted_first[0]);
  }
  /// ghosted(I + offset) - ghosted(I).
  int ghosted_stride(const Index& offset) const {
    return (offset[2] * ghosted_count[1] + offset[1]) * ghosted_count[0] + offset[0];
  }
  int owned(const Index& I) const {
    return ((I[2] - owned_first[2]) * owned_count[1] + (I[1] - owned_first[1])) * owned_count[0] +
           (I[0] - owned_first[0]);
  }
  int ghosted_size() const { return ghosted_count[0] * ghosted_count[1] * ghosted_count[2]; }
  int owned_size() const { return owned_count[0] * owned_count[1] * owned_count[2]; }
  bool is_owned(const Index& I) const;
  bool is_ghosted(const Index& I) const;
  /// Whether cell I lies in the box (periodic axes have no outside).
  bool inside(const Index& I) const {
    for (int axis = 0; axis < dim; ++axis)
      if (!axes[axis].periodic() && (I[axis] < 0 || I[axis] >= axes[axis].cells())) return false;
    return true;
  }
  /// Whether the lower `axis` face of I belongs to the box, sides included.
  bool is_face(int axis, const Index& I) const { return inside(I) || inside(I - unit(axis)); }
  /// Whether the lower `axis` face of I is on a side of the box: one of its two cells is outside.
  bool on_side(int axis, const Index& I) const { return !inside(I) || !inside(I - unit(axis)); }
  double volume(const Index& I) const;               ///< of cell I [m^dim]
  double face_area(int axis, const Index& I) const;  ///< of the lower `axis` face of I [m^(dim-1)]
  /// Length of the control volume about the lower `axis` face of I: half a cell on a side of the box [m].
  double control_length(int axis, const Index& I) const;
};

/// Calls work(I) for all I with first <= I < first + count, axis 0 fastest.
template <class Work>
void for_each_node(const Index& first, const Index& count, Work&& work) {
  for (int k = first[2]; k < first[2] + count[2]; ++k)
    for (int j = first[1]; j < first[1] + count[1]; ++j)
      for (int i = first[0]; i < first[0] + count[0]; ++i) work(Index{{i, j, k}});
}

/// Calls work(offset) for the offsets, zero among them, of all nodes that the ghost layer lets a node see.
template <class Work>
void for_each_offset(const Lattice& grid, Work&& work) {
  Index first, count{{1, 1, 1}};
  for (int axis = 0; axis < grid.dim; ++axis) {
    first[axis] = grid.ghosted_first[0] - grid.owned_first[0];
    count[axis] = 1 - 2 * first[axis];
  }
  for_each_node(first, count, work);
}

/// A DMDA for `unknowns` unknowns a node, `stencil_width` <= halo. The caller destroys it. Throws std::runtime_error on
/// all ranks where the grid is too small for so many.
PetscErrorCode create_dm(MPI_Comm comm, const Box& box, int unknowns, int stencil_width, DM* dm);

/// Lets a DMDA know the faces of an axis, ascending, one more than cells [m]. create_dm does.
PetscErrorCode set_faces(DM dm, int axis, const std::vector<double>& faces);
/// The faces that a DMDA knows; those of cells of width 1 where it knows none.
PetscErrorCode get_faces(DM dm, int axis, int cells, std::vector<double>& faces);

}  // namespace scree
