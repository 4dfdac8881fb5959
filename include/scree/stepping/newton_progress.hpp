/// What the residuals of Newton's iterations so far say of the next one. Not whether there is a way: near the rigid
/// limit they wander for twenty iterations, and then fall by hundreds in each.
#pragma once

#include <algorithm>
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

/// Relative tolerance of the next linear system, `asked` far from the solution: what it would leave beyond a share of
/// the residual at which Newton stops is work for nothing. It stays within `most` times what is asked: who asks for
/// exact solutions gets them. Below the tolerance Newton goes on for single cells, which a mean does not tell of.
inline double linear_tolerance(double asked, const ResidualNorms& norms, double tolerance) {
  constexpr double share = 0.3, most = 30;
  if (norms.empty() || !(norms.back() > tolerance)) return asked;
  return std::clamp(share * tolerance / norms.back(), asked, most * asked);
}

}  // namespace scree
