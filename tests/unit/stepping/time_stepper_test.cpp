#include "scree/stepping/time_stepper.hpp"

#include <gtest/gtest.h>

#include "direct_solver.hpp"

namespace scree::test {
namespace {

class TimeStepping : public DirectSolver {};

/// T1 of tests/VERIFICATION.md: a periodic box at rest cools as T = T0/(1 + A sqrt(T0) t/2)^2; nu 0.3, d 1 mm, T0 1
/// cm2/s2.
constexpr double haff_nu = 0.3, haff_T0 = 1e-4, haff_time = 0.1, haff_T = 0.4372736e-4;

/// T at the end, by `steps` steps.
double haff_cooling(TimeScheme scheme, int steps) {
  Box box = uniform_box(1, {8, 0, 0});
  box.periodic = {true, false, false};
  ProblemSetup setup = sample_setup(box, FrictionModel::none);
  setup.solids.temperature_floor = setup.model.temperature_floor = 1e-30;
  Evaluation problem(PETSC_COMM_WORLD, setup);
  StepControl control;
  control.scheme = scheme;
  control.step.adaptive = false;
  control.step.initial = haff_time / steps;
  TimeStepper stepper(problem.problem(), control);
  check(stepper.create(0));
  problem.put(problem.values([](const Field& f, const Index&) {
    return f.symbol == "nu" ? haff_nu : f.symbol == "T" ? haff_T0 : 0.0;
  }),
              stepper.state());
  StepReport report;
  for (int step = 0; step < steps; ++step) {
    check(stepper.step(haff_time, &report));
    EXPECT_FALSE(report.failed) << name_of(scheme) << ", step " << step << ": " << report.reason;
    if (report.failed) return 0;
  }
  EXPECT_NEAR(stepper.time(), haff_time, 1e-12) << name_of(scheme);
  const int T = problem.component("T");
  return problem.get(stepper.state())[problem.at(T, {{3, 0, 0}})] * problem.fields()[T].scale;
}

TEST_F(TimeStepping, SchemesHaveTheirOrders) {
  solve_exactly();
  // A = 10.2449841 sqrt(cm2/s2)/cm; the exact value to more digits than the table has.
  const double exact = haff_T0 / std::pow(1 + 10.2449841 * haff_time / 2, 2);
  ASSERT_NEAR(exact, haff_T, 1e-7 * haff_T) << "the formula against T(.1 s) of T1";
  for (const auto& [scheme, order] :
       {std::pair(TimeScheme::beuler, 1.0), {TimeScheme::bdf, 2.0}, {TimeScheme::arkimex, 2.0}}) {
    double error[3];
    for (int k = 0; k < 3; ++k) error[k] = std::abs(haff_cooling(scheme, 20 << k) / exact - 1);
    for (int k = 0; k < 2; ++k)
      EXPECT_NEAR(std::log2(error[k] / error[k + 1]), order, 0.15)
          << name_of(scheme) << ", " << (20 << k) << " to " << (40 << k) << " steps: relative errors " << error[k]
          << ", " << error[k + 1];
    EXPECT_LT(error[2], order == 1 ? 7e-3 : 5e-5) << name_of(scheme) << ", 80 steps";
  }
}

/// A settling column, solved to a loose tolerance: the volume of solids must not care.
TEST_F(TimeStepping, KeepsTheVolumeOfSolidsAtAnyTolerance) {
  check(PetscOptionsSetValue(nullptr, "-snes_rtol", "0.5"));
  check(PetscOptionsSetValue(nullptr, "-snes_atol", "1e3"));
  check(PetscOptionsSetValue(nullptr, "-ksp_type", "gmres"));
  check(PetscOptionsSetValue(nullptr, "-pc_type", "bjacobi"));
  check(PetscOptionsSetValue(nullptr, "-ksp_rtol", "0.3"));
  for (const TimeScheme scheme : {TimeScheme::beuler, TimeScheme::bdf}) {
    ProblemSetup setup = sample_setup(uniform_box(2, {6, 8, 0}), FrictionModel::critical_state);
    setup.model.gravity = {0, -9.81, 0};
    Evaluation problem(PETSC_COMM_WORLD, setup);
    StepControl control;
    control.scheme = scheme;
    control.step.adaptive = false;
    control.step.initial = 1e-3;
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
      ASSERT_FALSE(report.failed) << name_of(scheme) << ", step " << step << ": " << report.reason;
      EXPECT_NEAR(report.imbalance.solids, 0, 1e-14 * before) << name_of(scheme) << ", step " << step;
    }
    check(problem.problem().solids_volume(stepper.state(), &after));
    EXPECT_NEAR(after, before, 1e-13 * before) << name_of(scheme);
    const Values state = problem.get(stepper.state());
    EXPECT_LT(state[problem.at(2, {{2, 4, 0}})], 0) << name_of(scheme) << ": it falls";
  }
}

TEST_F(TimeStepping, StepsDoNotPassTheirLimitAndGrow) {
  Box box = uniform_box(1, {8, 0, 0});
  box.periodic = {true, false, false};
  Evaluation problem(PETSC_COMM_WORLD, sample_setup(box, FrictionModel::none));
  StepControl control;
  control.step.initial = 1e-4;
  control.step.most = 1e-2;
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
  EXPECT_GT(stepper.history().dt_next, control.step.initial);
}

// ---- policies, on the cooling box ----

class Policies : public DirectSolver {
 protected:
  struct Run {
    Run(const StepControl& control_, Box box = uniform_box(1, {8, 0, 0}))
        : problem(PETSC_COMM_WORLD, setup(std::move(box))), stepper(problem.problem(), control_) {
      check(stepper.create(0));
      problem.put(problem.values([](const Field& f, const Index&) {
        return f.symbol == "nu" ? haff_nu : f.symbol == "T" ? haff_T0 : 0.0;
      }),
                  stepper.state());
    }
    StepReport step(double limit = 1) {
      StepReport report;
      check(stepper.step(limit, &report));
      return report;
    }
    Evaluation problem;
    TimeStepper stepper;

   private:
    static ProblemSetup setup(Box box) {
      box.periodic = {true, false, false};
      return sample_setup(box, FrictionModel::none);
    }
  };
  static StepControl fixed_steps(double dt) {
    StepControl control;
    control.step.initial = dt;
    control.step.adaptive = false;
    return control;
  }
  static double first_residual(SNES snes) {
    double* norms;
    check(SNESGetConvergenceHistory(snes, &norms, nullptr, nullptr));
    return norms[0];
  }
};

TEST_F(Policies, BeginOnTheLineOfTheLastStatesWhereThatIsNearer) {
  StepControl control = fixed_steps(1e-3);
  Run on_line(control);
  control.extrapolate = false;
  Run from_state(control);
  for (int step = 0; step < 3; ++step) {
    on_line.step();
    from_state.step();
    EXPECT_EQ(first_residual(on_line.stepper.newton()), first_residual(from_state.stepper.newton()))
        << "no line before three easy steps";
  }
  on_line.step();
  from_state.step();
  EXPECT_EQ(on_line.stepper.history().guess.choice, FirstGuess::line);
  EXPECT_EQ(from_state.stepper.history().guess.choice, FirstGuess::better);
  EXPECT_LT(first_residual(on_line.stepper.newton()), 0.2 * first_residual(from_state.stepper.newton()));
}

/// Counts the Jacobians that TS has made.
struct JacobianCount {
  TSIJacobian made = nullptr;
  void* context = nullptr;
  int count = 0;

  void attach(TS ts, Mat matrix) {
    check(TSGetIJacobian(ts, nullptr, nullptr, &made, &context));
    check(TSSetIJacobian(ts, matrix, matrix, make, this));
  }
  static PetscErrorCode make(TS ts, PetscReal t, Vec state, Vec rate, PetscReal shift, Mat A, Mat P, void* self) {
    PetscFunctionBeginUser;
    auto& counts = *static_cast<JacobianCount*>(self);
    double before, after;  // the entries differ as the states do
    PetscCall(MatNorm(P, NORM_FROBENIUS, &before));
    PetscCall(counts.made(ts, t, state, rate, shift, A, P, counts.context));
    PetscCall(MatNorm(P, NORM_FROBENIUS, &after));
    counts.count += after != before;
    PetscFunctionReturn(0);
  }
};

TEST_F(Policies, KeepTheJacobianForTheLastIterations) {
  // Whether an iterate lies near enough to where Newton's method stops depends on the tolerance: for some it does.
  int kept = 0;
  for (double accuracy = 1e-1; accuracy > 1e-8; accuracy /= 3) {
    StepControl control = fixed_steps(0.5);
    control.accuracy = accuracy;
    Run run(control);
    JacobianCount jacobians;
    jacobians.attach(run.stepper.ts(), run.problem.problem().matrix());
    const StepReport report = run.step();
    ASSERT_FALSE(report.failed) << report.reason;
    EXPECT_GT(jacobians.count, 0);
    EXPECT_LE(jacobians.count, report.newton);
    kept += report.newton - jacobians.count;
  }
  EXPECT_GT(kept, 0);
}

TEST_F(Policies, KeepThePreconditionerForAStepUnlessItIsTheWholeSolver) {
  for (const bool alone : {true, false}) {
    check(PetscOptionsSetValue(nullptr, "-ksp_type", alone ? "preonly" : "gmres"));
    Run run(fixed_steps(1e-3));
    ASSERT_FALSE(run.step().failed);
    PetscInt lag;
    check(SNESGetLagPreconditioner(run.stepper.newton(), &lag));
    EXPECT_EQ(lag, alone ? 1 : -1);
  }
}

TEST_F(Policies, RejectStepsWhoseErrorIsTooLarge) {
  for (const TimeScheme scheme : {TimeScheme::beuler, TimeScheme::bdf, TimeScheme::arkimex}) {
    StepControl control;
    control.scheme = scheme;
    control.step.initial = 1e-4;
    control.accuracy = 1e-5;
    Run run(control);
    for (int step = 0; step < 3; ++step) ASSERT_FALSE(run.step().failed);
    run.stepper.history().dt_next = 0.1;
    const double before = run.stepper.time();
    const StepReport report = run.step();
    ASSERT_FALSE(report.failed) << name_of(scheme) << ": " << report.reason;
    EXPECT_GT(report.rejected_error, 0) << name_of(scheme);
    EXPECT_LE(report.error, 1) << name_of(scheme);
    EXPECT_LT(report.dt, 0.1) << name_of(scheme);
    EXPECT_NEAR(run.stepper.time(), before + report.dt, 1e-15) << name_of(scheme);
    EXPECT_LE(run.stepper.history().dt_next, report.dt) << name_of(scheme) << ": no growth";
    EXPECT_EQ(run.stepper.history().guess.choice, FirstGuess::better) << name_of(scheme);
  }
}

TEST_F(Policies, CountIterationsByStage) {
  check(PetscOptionsSetValue(nullptr, "-snes_atol", "1e-13"));
  StepControl control;
  control.scheme = TimeScheme::arkimex;
  control.step.initial = 0.02;  // no past to estimate an error from yet
  Run run(control);
  ASSERT_FALSE(run.step().failed);
  const StepReport report = run.step();
  ASSERT_FALSE(report.failed) << report.reason;
  EXPECT_GT(report.newton, StepOutcome::easy_newton);
  EXPECT_LE(report.newton, 2 * StepOutcome::easy_newton);
  EXPECT_NEAR(run.stepper.history().dt_next / report.dt, StepController::growth, 1e-12) << "an easy step";
}

TEST_F(Policies, CutStepsThatTheSolverFails) {
  check(PetscOptionsSetValue(nullptr, "-snes_max_it", "2"));
  StepControl control;
  control.step.initial = 0.1;
  control.accuracy = 1e-4;
  Run run(control);
  const StepReport report = run.step();
  ASSERT_FALSE(report.failed) << report.reason;
  EXPECT_GT(report.rejected_solver, 0);
  EXPECT_EQ(report.reason, "DIVERGED_MAX_IT");
  EXPECT_NEAR(report.dt, 0.1 * std::pow(StepController::reduction, report.rejected_solver), 1e-12);
  EXPECT_EQ(run.stepper.history().newton.calm, 0);
  EXPECT_EQ(run.stepper.history().guess.easy_steps, 0);
}

TEST_F(Policies, LeaveTheStateAsItWasWhereNoStepWorks) {
  check(PetscOptionsSetValue(nullptr, "-snes_max_it", "1"));
  check(PetscOptionsSetValue(nullptr, "-snes_atol", "1e-300"));
  StepControl control;
  control.step.initial = 1e-3;
  control.step.least = 1e-4;
  Run run(control);
  const Values before = run.problem.get(run.stepper.state());
  const StepReport report = run.step();
  EXPECT_TRUE(report.failed);
  EXPECT_EQ(report.reason, "DIVERGED_MAX_IT");
  EXPECT_EQ(run.problem.get(run.stepper.state()), before);
  EXPECT_EQ(run.stepper.time(), 0);
}

TEST_F(Policies, BeginSmallAndWithoutAPastAfterAnEvent) {
  for (const TimeScheme scheme : {TimeScheme::beuler, TimeScheme::bdf, TimeScheme::arkimex}) {
    StepControl control;
    control.scheme = scheme;
    control.step.initial = 1e-4;
    Run run(control);
    for (int step = 0; step < 5; ++step) ASSERT_FALSE(run.step().failed);
    const double time = run.stepper.time();
    ASSERT_GT(run.stepper.history().dt_next, 1e-4);
    check(run.problem.problem().update_conditions(time));
    check(run.stepper.restart_after_event());
    EXPECT_EQ(run.stepper.time(), time);
    const StepReport report = run.step();
    ASSERT_FALSE(report.failed) << name_of(scheme) << ": " << report.reason;
    EXPECT_NEAR(report.dt, 1e-4, 1e-15) << name_of(scheme);
    EXPECT_EQ(report.error, 0) << name_of(scheme) << ": no states to estimate it from";
  }
}

/// Options with another prefix are none of its own.
TEST_F(Policies, KeepToTheirPrefix) {
  check(PetscOptionsSetValue(nullptr, "-snes_max_it", "7"));
  check(PetscOptionsSetValue(nullptr, "-inner_snes_max_it", "9"));
  Run run(fixed_steps(1e-3));
  TimeStepper inner(run.problem.problem(), fixed_steps(1e-3), "inner_");
  check(inner.create(0, solver()));
  PetscInt most[2];
  check(SNESGetTolerances(run.stepper.newton(), nullptr, nullptr, nullptr, &most[0], nullptr));
  check(SNESGetTolerances(inner.newton(), nullptr, nullptr, nullptr, &most[1], nullptr));
  EXPECT_EQ(most[0], 7);
  EXPECT_EQ(most[1], 9);
}

}  // namespace
}  // namespace scree::test
