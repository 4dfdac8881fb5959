/// What kernels know of the scene beside the unknowns: grid, conditions at faces, parameters.
#pragma once

#include "scree/assembly/newton_tangent.hpp"
#include "scree/assembly/parameters.hpp"
#include "scree/boundary/barriers.hpp"
#include "scree/closures/voids.hpp"
#include "scree/grid/metrics.hpp"
#include "scree/math/through.hpp"

namespace scree {

struct Scene : Metrics {
  const Barriers& barriers;
  const ModelParameters& model;
  const SolidsParameters& solids;
  double time = 0;                               ///< for inlets that are given as functions of time [s]
  std::array<double, max_dim> gravity{0, 0, 0};  ///< as it is felt in the box, which may vibrate [m/s2]
  NewtonTangent* tangent = nullptr;              ///< of a Jacobian that is not the exact one
  double step = 0;  ///< that rates are differences over, x - step x_dot being x before it; 0: they are not [s]

  Scene(const Lattice& lattice_, const Barriers& barriers_, const ModelParameters& model_,
        const SolidsParameters& solids_)
      : Metrics{lattice_}, barriers(barriers_), model(model_), solids(solids_) {}

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

  // As in Barriers.
  bool barrier(int a, const Index& I) const { return near && barriers.at(a, I); }
  /// The condition at a face that is a barrier.
  const Condition& condition(int a, const Index& I) const { return barriers.condition(a, I); }
  const BoundaryKind& kind(int a, const Index& I) const { return barriers.condition(a, I).kind; }
  bool wall(int a, const Index& I) const { return near && barriers.wall(a, I); }
};

/// Bounds of the lower `axis` face of I.
inline FaceExtent face_extent(const Metrics& grid, int axis, const Index& I) {
  FaceExtent extent;
  for (int a = 0; a < grid.lattice.dim; ++a) {
    extent.lower[a] = grid.axis(a).face(I[a]);
    extent.upper[a] = grid.axis(a).face(a == axis ? I[a] : I[a] + 1);
  }
  return extent;
}

/// Component `component` of the velocity that the condition at the lower `axis` face of I prescribes to the particles
/// at the time of the scene [m/s].
inline double prescribed_velocity(const Scene& scene, int component, int axis, const Index& I) {
  return solids_velocity(scene.condition(axis, I), component, face_extent(scene, axis, I), scene.time);
}

/// nu at the lower `axis` face of I + at: the mean of its cells, on a side of the box that of the cell inside.
template <class L, class Q>
auto face_solids_fraction(const Scene& scene, const Index& I, const Q& q, int axis, const Index& at) {
  const Index below = at - unit(axis);
  const auto between = [&] { return face_mean(scene, axis, I + at, q(L::nu, below), q(L::nu, at)); };
  using Mean = decltype(between());
  return scene.on_side(axis, I + at) ? Mean(q(L::nu, box_above(scene, axis, I + at) ? at : below)) : between();
}

/// void_floor of the scene.
template <class Number>
auto added_in_voids(const Scene& scene, const Number& nu) {
  return through([&](const auto& x) { return void_floor(x, scene.model.solids_fraction_floor); }, nu);
}

/// Whether gas cannot pass the lower `axis` face of I.
inline bool closed_to_gas(const Scene& scene, int axis, const Index& I) {
  return scene.barrier(axis, I) && scene.kind(axis, I).stops_gas();
}

}  // namespace scree
