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

  const Axis& axis(int a) const { return lattice.axes[static_cast<std::size_t>(a)]; }
};

/// Mean over the two cells about the lower `axis` face of I, weighted by their shares in its control volume.
template <class Number>
Number face_mean(const Scene& scene, int axis, const Index& I, const Number& below, const Number& above) {
  const double share = scene.axis(axis).lower_share(I[axis]);
  return share * below + (1 - share) * above;
}

}  // namespace scree
