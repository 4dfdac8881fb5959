/// What the residuals of Newton's iterations so far say of the next one.
#pragma once

#include <vector>

namespace scree {

/// Norms of the residual, that of the first guess first.
using ResidualNorms = std::vector<double>;

/// Whether Newton's method will not come to an end: few of those that wander get there within the iterations that PETSc
/// allows, and a shorter step costs less than these.
inline bool is_lost(const ResidualNorms& norms) {
  constexpr std::size_t always_allowed = 3, most_in_vain = 5;  // iterations; those that leave the best what it is
  constexpr double most_growth = 10;
  if (norms.size() <= always_allowed + 1) return false;
  std::size_t best = 0;
  for (std::size_t k = 1; k < norms.size(); ++k)
    if (norms[k] < norms[best]) best = k;
  return norms.size() - 1 - best >= most_in_vain || norms.back() > most_growth * norms[best];
}

/// Whether the Jacobian and its factors serve for one more iteration: where the last one has reduced the residual to a
/// small share, and it is near the tolerance at which Newton stops, they converge about as fast as new ones.
inline bool keeps_jacobian(const ResidualNorms& norms, double tolerance) {
  constexpr double reduction = 0.1, distance = 30;
  if (norms.size() < 2) return false;
  return norms.back() < reduction * norms[norms.size() - 2] && norms.back() < distance * tolerance;
}

}  // namespace scree
