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
  double time = 0;                               ///< for flows of gas that are given as functions of time [s]
  std::array<double, max_dim> gravity{0, 0, 0};  ///< as it is felt in the box, which may vibrate [m/s2]
  /// False where the kernels of an anchor meet no barrier: the questions below are then answered without a look.
  bool near = true;

  const Axis& axis(int a) const { return lattice.axes[static_cast<std::size_t>(a)]; }
  const GasParameters& gas() const { return solids.gas; }
  /// The scene as it is at time `t` [s].
  Scene at(double t) const {
    Scene result = *this;
    result.time = t;
    const double omega = 2 * pi * model.vibration_frequency;
    for (int a = 0; a < max_dim; ++a)
      result.gravity[a] = model.gravity[a] + omega * omega * std::sin(omega * t) * model.vibration_amplitude[a];
    return result;
  }

  // As in Barriers and Lattice.
  bool barrier(int a, const Index& I) const { return near && barriers.at(a, I); }
  bool wall(int a, const Index& I) const { return near && barriers.wall(a, I); }
  bool inside(const Index& I) const { return !near || lattice.inside(I); }
  bool is_face(int a, const Index& I) const { return !near || lattice.is_face(a, I); }
  bool on_side(int a, const Index& I) const { return near && lattice.on_side(a, I); }
  double control_length(int a, const Index& I) const {
    return near ? lattice.control_length(a, I) : axis(a).distance(I[a]);
  }
};

/// Mean over the two cells about the lower `axis` face of I, weighted by their shares in its control volume.
template <class Number>
Number face_mean(const Scene& scene, int axis, const Index& I, const Number& below, const Number& above) {
  const double share = scene.axis(axis).lower_share(I[axis]);
  return share * below + (1 - share) * above;
}

/// Whether the box lies above the side that carries the lower `axis` face of I.
inline bool box_above(const Scene& scene, int axis, const Index& I) { return !scene.inside(I - unit(axis)); }

/// nu at the lower `axis` face of I + at: the mean of its cells, on a side of the box that of the cell inside.
template <class L, class Q>
auto face_solids_fraction(const Scene& scene, const Index& I, const Q& q, int axis, const Index& at) {
  const Index below = at - unit(axis);
  if (scene.on_side(axis, I + at)) return q(L::nu, box_above(scene, axis, I + at) ? at : below);
  return face_mean(scene, axis, I + at, q(L::nu, below), q(L::nu, at));
}

/// Whether plane I[axis] of faces is an end of the box, whatever the other coordinates.
inline bool on_side_of_axis(const Scene& scene, int axis, const Index& I) {
  return !scene.axis(axis).periodic() && (I[axis] == 0 || I[axis] == scene.axis(axis).cells());
}

/// Whether gas cannot pass the lower `axis` face of I.
inline bool closed_to_gas(const Scene& scene, int axis, const Index& I) {
  return scene.barrier(axis, I) && stops_gas(scene.barriers.condition(axis, I).kind);
}

/// Share of cell I in the control volume about its lower (side 0) or upper (side 1) `axis` face.
inline double share_of_cell(const Scene& scene, int axis, const Index& I, int side) {
  const Index face = I + side * unit(axis);
  if (scene.on_side(axis, face)) return 1;
  const double below = scene.axis(axis).lower_share(face[axis]);
  return side == 0 ? 1 - below : below;
}

}  // namespace scree
