#include "scree/output/point_sampler.hpp"

#include <algorithm>
#include <cmath>

#include "scree/output/errors.hpp"
#include "scree/output/node_block.hpp"

namespace scree {

namespace {

/// Two nodes of an axis and the weight of the second.
struct Bracket {
  int node[2] = {0, 0};
  double weight = 0;
};

/// Where values sit along an axis: faces 0..N (N-1 on a periodic axis), or centres 0..N-1.
std::vector<double> places(const Box& box, int axis, bool at_faces) {
  const std::vector<double>& faces = box.faces[axis];
  if (at_faces) return {faces.begin(), box.periodic[axis] ? faces.end() - 1 : faces.end()};
  std::vector<double> centres;
  for (size_t i = 0; i + 1 < faces.size(); ++i) centres.push_back(0.5 * (faces[i] + faces[i + 1]));
  return centres;
}

Bracket bracket(const Box& box, int axis, bool at_faces, double x) {
  const std::vector<double> at = places(box, axis, at_faces);
  const int last = static_cast<int>(at.size()) - 1;
  const double period = box.periodic[axis] ? box.upper(axis) - box.lower(axis) : 0;
  if (period > 0) x -= period * std::floor((x - box.lower(axis)) / period);
  Bracket result;
  const int above = static_cast<int>(std::upper_bound(at.begin(), at.end(), x) - at.begin());
  if (above > 0 && above <= last) {
    result.node[0] = above - 1;
    result.node[1] = above;
    result.weight = (x - at[above - 1]) / (at[above] - at[above - 1]);
  } else if (period > 0) {  // between the last place and the first of the next period
    result.node[0] = last;
    result.node[1] = 0;
    const double gap = at[0] + period - at[last];
    result.weight = (above == 0 ? x + period - at[last] : x - at[last]) / gap;
  } else {
    result.node[0] = result.node[1] = above == 0 ? 0 : last;
  }
  return result;
}

}  // namespace

PointSampler::PointSampler(const Box& box, DM dm, const std::vector<Sample>& samples) : dm_(dm) {
  const Lattice grid = checked_lattice(box, dm);
  const int unknowns = unknowns_of(dm);
  for (const Sample& sample : samples) {
    std::array<Bracket, max_dim> along;
    for (int axis = 0; axis < box.dim; ++axis) {
      along[axis] = bracket(box, axis, sample.field.face_axis == axis, sample.point[axis]);
    }
    std::array<Corner, corners> stencil;
    for (int corner = 0; corner < corners; ++corner) {
      Index node;
      double weight = sample.field.scale;
      for (int axis = 0; axis < max_dim; ++axis) {
        const int side = corner >> axis & 1;
        node[axis] = along[axis].node[side];
        weight *= side ? along[axis].weight : 1 - along[axis].weight;
      }
      const bool mine = weight != 0 && grid.is_owned(node);
      const PetscInt offset = static_cast<PetscInt>(grid.owned(node)) * unknowns + sample.field.component;
      stencil[corner] = {mine ? offset : -1, weight};
    }
    stencils_.push_back(stencil);
  }
}

std::vector<double> PointSampler::values(Vec state) const {
  const PetscScalar* stored = nullptr;
  check_petsc(VecGetArrayRead(state, &stored), "values at points");
  std::vector<double> at_corners;
  for (const auto& stencil : stencils_) {
    for (const Corner& corner : stencil) at_corners.push_back(corner.offset < 0 ? 0 : stored[corner.offset]);
  }
  check_petsc(VecRestoreArrayRead(state, &stored), "values at points");
  // Each corner has one owner, so this sum is exact, and the one below has a fixed order.
  const int count = static_cast<int>(at_corners.size());
  MPI_Allreduce(MPI_IN_PLACE, at_corners.data(), count, MPI_DOUBLE, MPI_SUM, communicator(dm_));
  std::vector<double> values(stencils_.size(), 0.0);
  for (size_t sample = 0; sample < values.size(); ++sample) {
    for (int corner = 0; corner < corners; ++corner) {
      const double weight = stencils_[sample][corner].weight;
      if (weight != 0) values[sample] += weight * at_corners[sample * corners + corner];
    }
  }
  return values;
}

}  // namespace scree
