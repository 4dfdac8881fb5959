#include "scree/stepping/local_error.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../../support/sample_problem.hpp"

namespace scree::test {
namespace {

/// The norm of an error of one scale in the field `symbol` at every node of a box whose nodes hold nu.
double norm_of(Evaluation& problem, const std::string& symbol, double nu) {
  Vec state, error;
  double norm;
  check(DMCreateGlobalVector(problem.problem().dm(), &state));
  check(VecDuplicate(state, &error));
  problem.put(problem.values([&](const Field& f, const Index&) { return f.symbol == "nu" ? nu : 0.0; }), state);
  problem.put(problem.values([&](const Field& f, const Index&) { return f.symbol == symbol ? f.scale : 0.0; }), error);
  check(norm_of_error(problem.problem(), state, error, &norm));
  for (Vec* vector : {&state, &error}) check(VecDestroy(vector));
  return norm;
}

TEST(LocalError, CountsNuEverywhereAndTheRestWhereParticlesAre) {
  Evaluation problem(PETSC_COMM_WORLD, sample_setup(uniform_box(1, {8, 0, 0})));
  const double one = std::sqrt(1.0 / problem.unknowns());  // nu, v, T, chi
  for (const double nu : {0.5, 1e-3}) EXPECT_NEAR(norm_of(problem, "nu", nu), one, 1e-15) << nu;
  for (const char* symbol : {"v", "T", "chi"}) {
    EXPECT_NEAR(norm_of(problem, symbol, 0.5), one, 1e-15) << symbol;
    EXPECT_NEAR(norm_of(problem, symbol, 2.5e-3), 0.5 * one, 1e-15) << symbol;
    EXPECT_EQ(norm_of(problem, symbol, 0), 0) << symbol;
  }
}

TEST(LocalError, CountsTheGasOnlyWhereItAloneMoves) {
  for (const bool moving : {true, false}) {
    ProblemSetup setup = sample_setup(uniform_box(1, {8, 0, 0}), FrictionModel::relaxed, TemperatureModel::transport,
                                      AdvectionScheme::upwind, GasModel::incompressible);
    setup.model.solids_moving = moving;
    setup.scales.density = setup.solids.kinetic.rho_s;
    Evaluation problem(PETSC_COMM_WORLD, setup);
    EXPECT_EQ(norm_of(problem, "p_g", 0.5), 0);
    EXPECT_EQ(norm_of(problem, "u", 0.5) > 0, !moving);
  }
}

}  // namespace
}  // namespace scree::test
