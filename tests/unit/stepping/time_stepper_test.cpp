#include "scree/stepping/time_stepper.hpp"

#include <gtest/gtest.h>

#include "direct_solver.hpp"

namespace scree::test {
namespace {

class TimeStepping : public DirectSolver {};

/// T1 of verification.md: a periodic box at rest cools as T = T0/(1 + A sqrt(T0) t/2)^2; nu .3, d 1 mm, T0 1 cm2/s2.
constexpr double haff_nu = 0.3, haff_T0 = 1e-4, haff_time = 0.1, haff_T = 0.4372736e-4;

/// T at the end, by `steps` steps.
double haff_cooling(const std::string& scheme, int steps) {
  Box box = uniform_box(1, {8, 0, 0});
  box.periodic = {true, false, false};
  ProblemSetup setup = sample_setup(box, FrictionModel::none);
  setup.solids.temperature_floor = setup.model.temperature_floor = 1e-30;
  Evaluation problem(PETSC_COMM_WORLD, setup);
  StepControl control;
  control.scheme = scheme;
  control.adaptive = false;
  control.step_initial = haff_time / steps;
  TimeStepper stepper(problem.problem(), control);
  check(stepper.create(0));
  problem.put(problem.values([](const Field& f, const Index&) {
    return f.symbol == "nu" ? haff_nu : f.symbol == "T" ? haff_T0 : 0.0;
  }),
              stepper.state());
  StepReport report;
  for (int step = 0; step < steps; ++step) {
    check(stepper.step(haff_time, &report));
    EXPECT_FALSE(report.failed) << scheme << ", step " << step << ": " << report.reason;
    if (report.failed) return 0;
  }
  EXPECT_NEAR(stepper.time(), haff_time, 1e-12) << scheme;
  const int T = problem.component("T");
  return problem.get(stepper.state())[problem.at(T, {{3, 0, 0}})] * problem.fields()[T].scale;
}

TEST_F(TimeStepping, SchemesHaveTheirOrders) {
  solve_exactly();
  // A = 10.2449841 sqrt(cm2/s2)/cm; the exact value to more digits than the table has.
  const double exact = haff_T0 / std::pow(1 + 10.2449841 * haff_time / 2, 2);
  ASSERT_NEAR(exact, haff_T, 1e-7 * haff_T) << "the formula against T(.1 s) of T1";
  for (const auto& [scheme, order] : {std::pair("beuler", 1.0), std::pair("bdf", 2.0), std::pair("arkimex", 2.0)}) {
    double error[3];
    for (int k = 0; k < 3; ++k) error[k] = std::abs(haff_cooling(scheme, 20 << k) / exact - 1);
    for (int k = 0; k < 2; ++k)
      EXPECT_NEAR(std::log2(error[k] / error[k + 1]), order, 0.15)
          << scheme << ", " << (20 << k) << " to " << (40 << k) << " steps: relative errors " << error[k] << ", "
          << error[k + 1];
    EXPECT_LT(error[2], order == 1 ? 7e-3 : 5e-5) << scheme << ", 80 steps";
  }
}

/// A settling column, solved to a loose tolerance: the volume of solids must not care.
TEST_F(TimeStepping, KeepsTheVolumeOfSolidsAtAnyTolerance) {
  check(PetscOptionsSetValue(nullptr, "-snes_rtol", "0.5"));
  check(PetscOptionsSetValue(nullptr, "-snes_atol", "1e3"));
  check(PetscOptionsSetValue(nullptr, "-ksp_type", "gmres"));
  check(PetscOptionsSetValue(nullptr, "-pc_type", "bjacobi"));
  check(PetscOptionsSetValue(nullptr, "-ksp_rtol", "0.3"));
  for (const std::string scheme : {"beuler", "bdf"}) {
    ProblemSetup setup = sample_setup(uniform_box(2, {6, 8, 0}), FrictionModel::critical_state);
    setup.model.gravity = {0, -9.81, 0};
    Evaluation problem(PETSC_COMM_WORLD, setup);
    StepControl control;
    control.scheme = scheme;
    control.adaptive = false;
    control.step_initial = 1e-3;
    TimeStepper stepper(problem.problem(), control);
    check(stepper.create(0));
    problem.put(problem.values([&](const Field& f, const Index& I) {
      if (!problem.lattice().inside(I)) return 0.0;
      return f.symbol == "nu" ? 0.4 - 0.02 * I[1] + 0.01 * I[0] : f.symbol == "T" ? 1e-4 : 0.0;
    }),
                stepper.state());
    double before, after;
    check(problem.problem().solids_volume(stepper.state(), &before));
    StepReport report;
    for (int step = 0; step < 5; ++step) {
      check(stepper.step(1, &report));
      ASSERT_FALSE(report.failed) << scheme << ", step " << step << ": " << report.reason;
      EXPECT_NEAR(report.imbalance.solids, 0, 1e-14 * before) << scheme << ", step " << step;
    }
    check(problem.problem().solids_volume(stepper.state(), &after));
    EXPECT_NEAR(after, before, 1e-13 * before) << scheme;
    const Values state = problem.get(stepper.state());
    EXPECT_LT(state[problem.at(2, {{2, 4, 0}})], 0) << scheme << ": it falls";
  }
}

TEST_F(TimeStepping, StepsDoNotPassTheirLimitAndGrow) {
  Box box = uniform_box(1, {8, 0, 0});
  box.periodic = {true, false, false};
  Evaluation problem(PETSC_COMM_WORLD, sample_setup(box, FrictionModel::none));
  StepControl control;
  control.step_initial = 1e-4;
  control.step_max = 1e-2;
  TimeStepper stepper(problem.problem(), control);
  check(stepper.create(0));
  problem.put(problem.values([](const Field& f, const Index&) {
    return f.symbol == "nu" ? haff_nu : f.symbol == "T" ? haff_T0 : 0.0;
  }),
              stepper.state());
  StepReport report;
  double last = 0;
  int steps = 0;
  for (; stepper.time() < 5e-3 && steps < 100; ++steps) {
    check(stepper.step(5e-3, &report));
    ASSERT_FALSE(report.failed) << report.reason;
    EXPECT_NEAR(report.time - last, report.dt, 1e-12);
    EXPECT_LE(report.time, 5e-3 * (1 + 1e-12));
    last = report.time;
  }
  EXPECT_NEAR(stepper.time(), 5e-3, 1e-12);
  EXPECT_LT(steps, 25) << "50 of the first size";
  EXPECT_GT(stepper.history().dt_next, control.step_initial);
}

}  // namespace
}  // namespace scree::test
