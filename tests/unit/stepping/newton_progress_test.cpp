#include "scree/stepping/newton_progress.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace scree::test {
namespace {

TEST(NewtonProgress, IsLostWhereTheBestIsLongAgoOrFarBelow) {
  ResidualNorms norms;
  for (const double norm : {1., 0.1, 0.9, 0.5, 0.4, 0.3}) {
    norms.push_back(norm);
    EXPECT_FALSE(is_lost(norms)) << norms.size() - 1 << " iterations";
  }
  ResidualNorms in_vain = norms, better = norms;
  in_vain.push_back(0.2);
  EXPECT_TRUE(is_lost(in_vain)) << "five iterations after the best";
  better.push_back(0.09);
  EXPECT_FALSE(is_lost(better));
  better.push_back(0.89);
  EXPECT_FALSE(is_lost(better)) << "less than ten times the best";
  better.back() = 0.91;
  EXPECT_TRUE(is_lost(better)) << "more than ten times the best";
}

TEST(NewtonProgress, IsGivenThreeIterationsWhateverTheyDo) {
  EXPECT_FALSE(is_lost({1e-9, 1, 1e3, 1e6}));
  EXPECT_TRUE(is_lost({1e-9, 1, 1e3, 1e6, 1e3}));
}

TEST(NewtonProgress, KeepsTheJacobianNearTheEndOfFastConvergence) {
  const double tolerance = 1e-3;
  EXPECT_TRUE(keeps_jacobian({1, 0.02}, tolerance));
  EXPECT_FALSE(keeps_jacobian({0.02}, tolerance)) << "the first is always made";
  EXPECT_FALSE(keeps_jacobian({0.19, 0.02}, tolerance)) << "slow";
  EXPECT_FALSE(keeps_jacobian({10, 0.04}, tolerance)) << "far from the tolerance";
  EXPECT_FALSE(keeps_jacobian({1, std::nan("")}, tolerance));
}

}  // namespace
}  // namespace scree::test
