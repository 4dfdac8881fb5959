#include "scree/assembly/newton_tangent.hpp"

#include <gtest/gtest.h>

namespace scree {
namespace {

constexpr int n = 3;
using Strain = StrainComponents<Dual<n>, n, n>;

/// Components x with weights as of two normal components and a shear component.
Strain strain(const std::array<double, n>& x) {
  Strain S;
  for (int k = 0; k < n; ++k) S.add(SparseDual<n, 1>(x[k], k, 1), k < 2 ? 1 : 2);
  return S;
}

/// d(S:S) that `directions` give at place 0.
std::array<double, n> slope(StressDirections& directions, const Strain& S, double floor) {
  directions.next();
  const Dual<n> S_S = directions.square(0, S, std::sqrt(S.square_value() + floor * floor));
  std::array<double, n> result;
  for (int k = 0; k < n; ++k) result[k] = S_S.derivative[k];
  return result;
}

TEST(StressDirections, BeginWithTheExactTangentOrAShareOfIt) {
  for (const double share : {1.0, 0.5}) {
    StressDirections directions;
    directions.resize(1, n);
    directions.restart(share);
    const Strain S = strain({3, -1, 2});
    const auto got = slope(directions, S, 0.1);
    for (int k = 0; k < n; ++k) EXPECT_NEAR(got[k], share * S.square().derivative[k], 1e-12);
  }
}

// At the solution S does not change any more, and gamma Pi = S.
TEST(StressDirections, AreExactAtTheSolution) {
  StressDirections directions;
  directions.resize(1, n);
  directions.restart(0.5);
  const Strain S = strain({3, -1, 2});
  slope(directions, strain({-1, 4, 1}), 0.1);
  slope(directions, S, 0.1);
  const auto got = slope(directions, S, 0.1);
  for (int k = 0; k < n; ++k) EXPECT_NEAR(got[k], S.square().derivative[k], 1e-12);
}

// A step that turns S around would leave |Pi| far above 1.
TEST(StressDirections, StayInTheUnitBall) {
  StressDirections directions;
  directions.resize(1, n);
  directions.restart(1);
  slope(directions, strain({1e-3, 0, 0}), 1e-3);
  const Strain S = strain({-5, 2, 7});
  const double gamma = std::sqrt(S.square_value() + 1e-6);
  const auto got = slope(directions, S, 1e-3);
  double norm = 0;
  for (int k = 0; k < n; ++k) norm += got[k] * got[k] / (S.weight[k] * 4 * gamma * gamma);
  EXPECT_NEAR(norm, 1, 1e-12);
}

TEST(StressDirections, LeaveWhatDoesNotMove) {
  StressDirections directions;
  directions.resize(1, n);
  directions.restart(1);
  for (const double slope_k : slope(directions, strain({0, 0, 0}), 0)) EXPECT_EQ(slope_k, 0);
}

}  // namespace
}  // namespace scree
