#include "scree/stepping/corrections.hpp"

#include <gtest/gtest.h>

#include "../../support/sample_problem.hpp"

namespace scree::test {
namespace {

/// After the correction the rates of nu and the fluxes balance, however bad the state was.
TEST(Corrections, OfContinuityBalanceVolumeAndOutflow) {
  ProblemSetup setup = sample_setup(graded_box(2, {6, 4, 0}), FrictionModel::critical_state);
  setup.segments[2] = side(1, false, condition(BoundaryKind::open));
  Evaluation problem(PETSC_COMM_WORLD, setup);
  const auto random = [&](int seed) {
    return problem.values([&](const Field& f, const Index& I) { return random_value(f, I, Regime::dense, seed); });
  };
  const double shift = 40;
  const Values state = random(1), rate = random(2);
  const Values residual = problem.residual(state, rate);
  const double expected = -problem.outflow(state);  // of the rate of the volume of solids
  Vec x, x_dot, f;
  check(DMCreateGlobalVector(problem.problem().dm(), &x));
  for (Vec* vector : {&x_dot, &f}) check(VecDuplicate(x, vector));
  problem.put(rate, x_dot);
  problem.put(state, x);
  problem.put(residual, f);
  double before, after, change = 0;
  VolumeImbalance imbalance;
  check(problem.problem().solids_volume(x, &before));
  check(correct(problem.problem(), {0, shift, x_dot}, f, x, &imbalance));
  check(problem.problem().solids_volume(x, &after));
  for_each_node(Index{}, problem.nodes(), [&](const Index& I) {
    if (problem.lattice().inside(I)) change += problem.lattice().volume(I) * rate[problem.at(0, I)];
  });
  change += shift * (after - before);  // nu enters its rate times the shift
  EXPECT_NEAR(change, expected, 1e-12 * std::abs(expected)) << "rate of change of the volume against -outflow";
  EXPECT_NEAR(imbalance.solids, 0, 1e-12 * std::abs(expected));
  for (Vec* vector : {&x, &x_dot, &f}) check(VecDestroy(vector));
}

}  // namespace
}  // namespace scree::test
