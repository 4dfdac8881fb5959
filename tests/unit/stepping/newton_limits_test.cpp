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

}  // namespace
}  // namespace scree::test
