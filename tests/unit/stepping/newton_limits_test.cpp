#include "scree/stepping/newton_limits.hpp"

#include <gtest/gtest.h>

#include "../../support/sample_problem.hpp"

namespace scree::test {
namespace {

struct Step {
  const char* name;
  std::string symbol;
  double from, target, expected;
};

TEST(NewtonLimits, HoldBackEachUnknownAtItsBoundAndNothingElse) {
  const ProblemSetup setup = sample_setup(uniform_box(1, {8, 0, 0}));
  Evaluation problem(PETSC_COMM_WORLD, setup);
  const NewtonLimits limits(problem.problem());
  const double tip = maximum_chi(setup.solids.friction);
  const Step rows[] = {
      {"nu below the limit", "nu", 0.6, 0.63, 0.63},
      {"nu beyond nu_max", "nu", 0.6, 0.8, 0.6 + 0.7 * 0.05},
      {"nu within the last 30 %", "nu", 0.6, 0.64, 0.635},
      {"nu below zero", "nu", 0.1, -0.2, 0.0},
      {"nu to zero", "nu", 0.1, 0.0, 0.0},
      {"T falls", "T", 1.0, 0.02, 0.02},
      {"T falls too far", "T", 1.0, 1e-3, 0.01},
      {"T below zero", "T", 1.0, -5.0, 0.01},
      {"T rises", "T", 1.0, 1e6, 1e6},
      {"chi beyond the tip", "chi", 1.0, 2.0, tip},
      {"chi falls too far", "chi", 1.0, -1.0, 0.1},
      {"chi within", "chi", 1.0, 0.5, 0.5},
      {"velocity reverses", "v", 1.0, -1e3, -1e3},
  };
  Vec from, target;
  check(DMCreateGlobalVector(problem.problem().dm(), &from));
  check(VecDuplicate(from, &target));
  const auto values = [&](const Step& row, double value) {
    Values result = problem.values([&](const Field& f, const Index&) { return f.symbol == "nu" ? 0.5 : f.scale; });
    result[problem.at(problem.component(row.symbol), {{5, 0, 0}})] = value;  // stored units
    return result;
  };
  for (const Step& row : rows) {
    problem.put(values(row, row.from), from);
    problem.put(values(row, row.target), target);
    std::vector<PetscInt> held;
    check(limits.apply(from, target, false, &held));
    long mine = static_cast<long>(held.size()), all = 0;
    MPI_Allreduce(&mine, &all, 1, MPI_LONG, MPI_SUM, PETSC_COMM_WORLD);
    const Values result = problem.get(target), expected = values(row, row.expected);
    for (std::size_t i = 0; i < result.size(); ++i)
      EXPECT_NEAR(result[i], expected[i], 1e-15) << row.name << ", row " << i;
    EXPECT_EQ(all, row.target == row.expected ? 0 : 1) << row.name << ": number of unknowns held back";
  }
  check(VecDestroy(&from));
  check(VecDestroy(&target));
}

/// T of cell 5, stored, after a step of Newton's method there that wants `T_wanted` from 1e-6, beside a cell whose chi
/// is held back. The cell shears fast, as in the air beside a jet, and holds few particles: production alone would heat
/// it without end.
double T_after_step(double T_wanted) {
  Evaluation problem(PETSC_COMM_WORLD, sample_setup(uniform_box(1, {8, 0, 0})));
  NewtonLimits limits(problem.problem());
  Stage stage;
  stage.shift = 1 / 4e-3;
  SNES snes;
  SNESLineSearch search;
  Vec state, step;
  PetscBool changed;
  check(SNESCreate(PETSC_COMM_WORLD, &snes));
  check(DMCreateGlobalVector(problem.problem().dm(), &state));
  check(VecDuplicate(state, &step));
  check(limits.attach(snes, &stage));
  check(SNESGetLineSearch(snes, &search));

  const int T = problem.at(problem.component("T"), {{5, 0, 0}}),
            chi = problem.at(problem.component("chi"), {{2, 0, 0}});
  Values x = problem.values([&](const Field& f, const Index& I) {
    if (f.symbol == "nu") return I[0] == 5 ? 2e-4 : 0.5;
    if (f.symbol == "v") return I[0] > 5 ? 20 * f.scale : 0.0;
    return f.scale;
  });
  x[T] = 1e-6;
  Values dx = problem.zeros();  // Newton's method goes to x - dx
  dx[T] = x[T] - T_wanted;
  dx[chi] = 5;
  problem.put(x, state);
  problem.put(dx, step);
  check(SNESLineSearchPreCheck(search, state, step, &changed));
  const double result = x[T] - problem.get(step)[T];
  check(VecDestroy(&state));
  check(VecDestroy(&step));
  check(SNESDestroy(&snes));
  return result;
}

TEST(NewtonLimits, RaiseTheTemperatureWhereItIsHeldAndNowhereElse) {
  EXPECT_GT(T_after_step(-1), 1e-3);
  EXPECT_NEAR(T_after_step(9e-7), 9e-7, 1e-12);
}

}  // namespace
}  // namespace scree::test
