/// What the residuals of Newton's iterations so far say of the next one. Not whether there is a way: near the rigid
/// limit they wander for twenty iterations, and then fall by hundreds in each.
#pragma once

#include <vector>

namespace scree {

/// Norms of the residual, that of the first guess first.
using ResidualNorms = std::vector<double>;

/// Whether the Jacobian and its factors serve for one more iteration: where the last one has reduced the residual to a
/// small share, and it is near the tolerance at which Newton stops, they converge about as fast as new ones.
inline bool keeps_jacobian(const ResidualNorms& norms, double tolerance) {
  constexpr double reduction = 0.1, distance = 30;
  if (norms.size() < 2) return false;
  return norms.back() < reduction * norms[norms.size() - 2] && norms.back() < distance * tolerance;
}

}  // namespace scree
