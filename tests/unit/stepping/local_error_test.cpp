#include "scree/stepping/local_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "../../support/sample_problem.hpp"

namespace scree::test {
namespace {

/// Which nodes of a box.
using Where = std::function<bool(const Index&)>;
bool everywhere(const Index&) { return true; }

/// The norm of an error of one scale in the field `symbol` at the nodes `wrong`, in a state with `nu` at each node and
/// nothing else.
double norm_of(Evaluation& problem, const std::string& symbol, const std::function<double(const Index&)>& nu,
               const Where& wrong = everywhere) {
  Vec state, error;
  double norm;
  const auto state_of = [&](const Field& f, const Index& I) { return f.symbol == "nu" ? nu(I) : 0.0; };
  const auto error_of = [&](const Field& f, const Index& I) { return f.symbol == symbol && wrong(I) ? f.scale : 0.0; };
  check(DMCreateGlobalVector(problem.problem().dm(), &state));
  check(VecDuplicate(state, &error));
  problem.put(problem.values(state_of), state);
  problem.put(problem.values(error_of), error);
  check(norm_of_error(problem.problem(), state, error, &norm));
  for (Vec* vector : {&state, &error}) check(VecDestroy(vector));
  return norm;
}
double norm_of(Evaluation& problem, const std::string& symbol, double nu, const Where& wrong = everywhere) {
  return norm_of(
      problem, symbol, [nu](const Index&) { return nu; }, wrong);
}

/// Of an error of one scale in one of the unknowns in a share of the volume: rms^2 = share, L4^2 = sqrt(share).
double expected(double share, double size, double floor, int unknowns) {
  return std::sqrt((share + 0.25 * std::sqrt(share)) / (size * size + floor * floor) / unknowns);
}

TEST(LocalError, CountsNuEverywhereAndTheRestWhereParticlesAre) {
  Evaluation problem(PETSC_COMM_WORLD, sample_setup(uniform_box(1, {8, 0, 0})));
  const int unknowns = problem.unknowns();  // nu, v, T, chi
  EXPECT_NEAR(norm_of(problem, "nu", 0.5), expected(1, 0.5, 0.1, unknowns), 1e-14);
  for (const char* symbol : {"v", "T", "chi"}) {
    const double floor = symbol == std::string("T") ? 0.01 : 0.1;
    EXPECT_NEAR(norm_of(problem, symbol, 0.5), expected(1, 0, floor, unknowns), 1e-12) << symbol;
    EXPECT_EQ(norm_of(problem, symbol, 0.0), 0) << symbol;
  }
}

/// Half of the cells hold a fifth of what counts as full.
TEST(LocalError, CountsLessWhereParticlesAreFew) {
  Evaluation problem(PETSC_COMM_WORLD, sample_setup(uniform_box(1, {8, 0, 0})));
  const auto few = [](const Index& I) { return I[0] < 4; };
  const auto nu = [&](const Index& I) { return few(I) ? 2e-3 : 0.5; };
  EXPECT_NEAR(norm_of(problem, "T", nu, few), expected(0.2 / 1.2, 0, 0.01, problem.unknowns()), 1e-12);
}

TEST(LocalError, IsThatOfTheBedHoweverMuchEmptySpaceIsOverIt) {
  const auto nu = [](const Index& I) { return I[1] < 4 ? 0.5 : 0.0; };
  const auto corner = [](const Index& I) { return I[0] == 0 && I[1] == 0; };
  for (const int rows : {8, 32}) {
    Evaluation problem(PETSC_COMM_WORLD, sample_setup(uniform_box(2, {6, rows, 0})));
    EXPECT_NEAR(norm_of(problem, "T", nu, corner), expected(1.0 / 24, 0, 0.01, 4), 1e-12) << rows;
  }
}

TEST(LocalError, WeightsCellsByTheirVolume) {
  Box box = uniform_box(1, {8, 0, 0});
  box.faces[0] = {0, 1, 1.25, 1.5, 1.75, 2, 3, 3.5, 4};
  Evaluation problem(PETSC_COMM_WORLD, sample_setup(box));
  const auto cell = [](int i) { return [i](const Index& I) { return I[0] == i; }; };
  EXPECT_NEAR(norm_of(problem, "T", 0.5, cell(0)), expected(1.0 / 4, 0, 0.01, 4), 1e-12);
  EXPECT_NEAR(norm_of(problem, "T", 0.5, cell(1)), expected(1.0 / 16, 0, 0.01, 4), 1e-12);
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
