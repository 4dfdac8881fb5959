/// What kernels know of the scene beside the unknowns: grid, conditions at faces, parameters.
#pragma once

#include "scree/boundary/barriers.hpp"
#include "scree/equations/parameters.hpp"

namespace scree {

struct Scene {
  const Lattice& lattice;
  const Barriers& barriers;
  const ModelParameters& model;
  const SolidsParameters& solids;
  double time = 0;  ///< for flows of gas that are given as functions of time [s]

  const Axis& axis(int a) const { return lattice.axes[static_cast<std::size_t>(a)]; }
  const GasParameters& gas() const { return solids.gas; }
};

/// Mean over the two cells about the lower `axis` face of I, weighted by their shares in its control volume.
template <class Number>
Number face_mean(const Scene& scene, int axis, const Index& I, const Number& below, const Number& above) {
  const double share = scene.axis(axis).lower_share(I[axis]);
  return share * below + (1 - share) * above;
}

/// Whether the box lies above the side that carries the lower `axis` face of I.
inline bool box_above(const Scene& scene, int axis, const Index& I) { return !scene.lattice.inside(I - unit(axis)); }

/// Whether the lower `axis` face of I is on a side of the box.
inline bool on_side(const Scene& scene, int axis, const Index& I) {
  return !scene.lattice.inside(I) || !scene.lattice.inside(I - unit(axis));
}

/// Whether plane I[axis] of faces is an end of the box, whatever the other coordinates.
inline bool on_side_of_axis(const Scene& scene, int axis, const Index& I) {
  return !scene.axis(axis).periodic() && (I[axis] == 0 || I[axis] == scene.axis(axis).cells());
}

/// Whether gas cannot pass the lower `axis` face of I.
inline bool closed_to_gas(const Scene& scene, int axis, const Index& I) {
  return scene.barriers.at(axis, I) && stops_gas(scene.barriers.condition(axis, I).kind);
}

/// Length of the control volume about the lower `axis` face of I: half a cell on a side of the box [m].
inline double control_length(const Scene& scene, int axis, const Index& I) {
  return (on_side(scene, axis, I) ? 0.5 : 1.0) * scene.axis(axis).distance(I[axis]);
}

/// Share of cell I in the control volume about its lower (side 0) or upper (side 1) `axis` face.
inline double share_of_cell(const Scene& scene, int axis, const Index& I, int side) {
  const Index face = I + side * unit(axis);
  if (on_side(scene, axis, face)) return 1;
  const double below = scene.axis(axis).lower_share(face[axis]);
  return side == 0 ? 1 - below : below;
}

}  // namespace scree
