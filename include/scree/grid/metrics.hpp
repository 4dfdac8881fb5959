/// Lengths, areas and volumes about cells, faces and edges, and the operators made of them: the one place from which
/// balances take the geometry of the grid. No kernel divides by a width.
#pragma once

#include "scree/grid/advection.hpp"
#include "scree/grid/lattice.hpp"

namespace scree {

/// The two ends of a volume along an axis.
enum class End { lower, upper };

inline End end_of(int side) { return side == 0 ? End::lower : End::upper; }

/// The geometry of a rank's part of the grid. Axes are plane, with scale factors h = 1: the volume over the area of
/// either end is a width. Curvilinear axes would put their areas and volumes here, and kernels stay as they are.
struct Metrics {
  const Lattice& lattice;
  /// False where nothing lies within the width of the ghost layer that carries a condition: the questions below are
  /// then answered without a look.
  bool near = true;

  const Axis& axis(int a) const { return lattice.axes[static_cast<std::size_t>(a)]; }
  bool inside(const Index& I) const { return !near || lattice.inside(I); }
  bool is_face(int a, const Index& I) const { return !near || lattice.is_face(a, I); }
  bool on_side(int a, const Index& I) const { return near && lattice.on_side(a, I); }

  /// Volume of cell I over the area of its lower or upper `a` face [m].
  double volume_over_area(int a, const Index& I, End) const { return axis(a).width(I[a]); }
  /// The same of the control volume about the lower `a` face of I and the area at one of its ends; on a side of the box
  /// it is half a cell [m].
  double control_volume_over_area(int a, const Index& I, End) const { return control_length(a, I); }
  /// Extent along `a`: of cell I, and of the control volume about its lower `a` face [m].
  double cell_length(int a, const Index& I) const { return axis(a).width(I[a]); }
  double control_length(int a, const Index& I) const {
    return near ? lattice.control_length(a, I) : axis(a).distance(I[a]);
  }
  /// From the centre of cell I to one of its `a` faces [m].
  double distance_to_face(int a, const Index& I) const { return 0.5 * cell_length(a, I); }
  /// Between the centres of the two cells about the lower `a` face of I [m].
  double centre_distance(int a, const Index& I) const { return axis(a).distance(I[a]); }
  /// Share of the cell below in the control volume about the lower `a` face of I, wherever the box ends.
  double lower_share(int a, const Index& I) const { return axis(a).lower_share(I[a]); }
};

// ---- differences [1/m] ----

/// d/d axis at the lower `axis` face of I, of a quantity at the centres of the cells below and above.
template <class A, class B>
auto difference_at_face(const Metrics& grid, int axis, const Index& I, const A& below, const B& above) {
  return (above - below) / grid.centre_distance(axis, I);
}

/// d/d axis in cell I, of a quantity at its lower and upper `axis` faces.
template <class A, class B>
auto difference_in_cell(const Metrics& grid, int axis, const Index& I, const A& lower, const B& upper) {
  return (upper - lower) / grid.cell_length(axis, I);
}

/// d/d axis from the centre of cell I to one of its `axis` faces, or back [1/m].
template <class A, class B>
auto difference_to_face(const Metrics& grid, int axis, const Index& I, const A& from, const B& to) {
  return (to - from) / grid.distance_to_face(axis, I);
}

/// d/d axis at the lower `axis` face of I, on a side of the box, from the centre of the cell before it to the side.
template <class A, class B>
auto difference_to_side(const Metrics& grid, int axis, const Index& I, const A& lower, const B& upper) {
  return (upper - lower) / grid.control_length(axis, I);
}

// ---- divergences [1/m]: what a flux through one end takes out of a volume, per volume; the other end with minus ----

/// Through an `axis` face of cell I; for a control volume of another axis, which is as long as cell I along this one.
template <class Number>
Number out_of_cell(const Metrics& grid, int axis, const Index& I, End end, const Number& flux) {
  return flux / grid.volume_over_area(axis, I, end);
}

/// Out of the control volume about the lower `axis` face of I, through one of its ends along the same axis.
template <class Number>
Number out_of_control_volume(const Metrics& grid, int axis, const Index& I, End end, const Number& flux) {
  return flux / grid.control_volume_over_area(axis, I, end);
}

// ---- means ----

/// Over the two cells about the lower `axis` face of I, weighted by their shares in its control volume.
template <class A, class B>
auto face_mean(const Metrics& grid, int axis, const Index& I, const A& below, const B& above) {
  const double share = grid.lower_share(axis, I);
  return share * below + (1 - share) * above;
}

/// Share of cell I in the control volume about its lower (side 0) or upper (side 1) `axis` face.
inline double share_of_cell(const Metrics& grid, int axis, const Index& I, int side) {
  const Index face = I + side * unit(axis);
  if (grid.on_side(axis, face)) return 1;
  const double below = grid.lower_share(axis, face);
  return side == 0 ? 1 - below : below;
}

/// Whether the box lies above the side that carries the lower `axis` face of I.
inline bool box_above(const Metrics& grid, int axis, const Index& I) { return !grid.inside(I - unit(axis)); }

/// Whether plane I[axis] of faces is an end of the box, whatever the other coordinates.
inline bool on_side_of_axis(const Metrics& grid, int axis, const Index& I) {
  return !grid.axis(axis).periodic() && (I[axis] == 0 || I[axis] == grid.axis(axis).cells());
}

// ---- distances for upwinding ----

/// Of cell-centred values carried through the lower `axis` face of I.
inline AdvectionMetrics cell_metrics(const Metrics& grid, int a, const Index& I) {
  const Axis& axis = grid.axis(a);
  const int i = I[a];
  return {axis.distance(i - 1), axis.distance(i), axis.distance(i + 1), 0.5 * axis.width(i - 1), 0.5 * axis.width(i)};
}

/// Of velocities along `axis` carried through the centre of cell I. What is mirrored at a barrier on its lower or upper
/// face lies a width of this cell beyond it.
inline AdvectionMetrics face_metrics(const Metrics& grid, int axis, const Index& I, bool lower_barrier,
                                     bool upper_barrier) {
  const Axis& x = grid.axis(axis);
  const int i = I[axis];
  return {x.width(lower_barrier ? i : i - 1), x.width(i), x.width(upper_barrier ? i : i + 1), 0.5 * x.width(i),
          0.5 * x.width(i)};
}

}  // namespace scree
