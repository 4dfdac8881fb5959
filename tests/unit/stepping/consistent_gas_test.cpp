/// p_g and u made consistent with particles that stand still: the balance of volume, and the drop of pressure by drag.
#include "scree/stepping/consistent_gas.hpp"

#include "../../jacobian/scenes.hpp"
#include "direct_solver.hpp"

namespace scree::test {
namespace {

class ConsistentGas : public DirectSolver {
 protected:
  /// A state after make_gas_consistent.
  static Values made_consistent(Evaluation& problem, const Values& state, double time = 0) {
    StepControl control;
    control.step.initial = 1e-4;
    Vec x;
    check(DMCreateGlobalVector(problem.problem().dm(), &x));
    problem.put(state, x);
    bool done = false;
    check(make_gas_consistent(problem.problem(), control, solver(), time, x, &done));
    EXPECT_TRUE(done);
    Values result = problem.get(x);
    check(VecDestroy(&x));
    return result;
  }
  /// Greatest row of (2) [1/s].
  static double imbalance(Evaluation& problem, const Values& state) {
    const Values residual = problem.residual(state, problem.zeros());
    double greatest = 0;
    for (int i = problem.component("p_g"); i < problem.size(); i += problem.unknowns())
      greatest = std::max(greatest, std::abs(residual[i]));
    return greatest / problem.problem().setup().scales.time;
  }
};

/// Gas from below through a bed that begins without any.
TEST_F(ConsistentGas, DropsItsPressureByDragInAFixedBed) {
  solve_exactly("gas_start_");
  for (int dim = 1; dim <= 2; ++dim)
    for (const auto gas : {GasModel::darcy, GasModel::incompressible}) {
      SCOPED_TRACE(std::to_string(dim) + "d, gas model " + std::to_string(static_cast<int>(gas)));
      const double U = 0.4, nu = 0.55, outside = 12;
      std::array<int, max_dim> cells{6, 6, 0};
      cells[dim - 1] = 12;
      ProblemSetup setup = sample_setup(graded_box(dim, cells), FrictionModel::critical_state,
                                        TemperatureModel::transport, AdvectionScheme::upwind, gas);
      setup.model.darcy_solids_fraction = 0;
      setup.model.gravity[dim - 1] = -9.81;
      const int axis = dim - 1;
      Condition inlet = condition(BoundaryKind::gas_inlet), opening = condition(BoundaryKind::open);
      inlet.gas_velocity = U;
      opening.gas_pressure = outside;
      setup.segments.push_back(side(axis, false, inlet));
      setup.segments.push_back(side(axis, true, opening));
      Evaluation problem(PETSC_COMM_WORLD, setup);
      const Lattice& grid = problem.lattice();
      const Values state = problem.values([&](const Field& f, const Index& I) {
        if (!grid.inside(I)) return 0.0;
        return f.symbol == "nu" ? nu : f.symbol == "T" ? 1e-4 : 0.0;
      });
      const Values result = made_consistent(problem, state);
      EXPECT_LT(imbalance(problem, result), 1e-11 * U / grid.axes[axis].width(0));
      const double u = U / (1 - nu);
      const double gradient = drag_coefficient(nu, u * u, setup.solids.kinetic.d, setup.solids.gas) * u / (1 - nu);
      for_each_node(Index{}, problem.nodes(), [&](const Index& I) {
        for (const Field& f : problem.fields()) {
          const int i = problem.at(f.component, I);
          const double value = f.scale * result[i];
          const double height = setup.box.upper(axis) - grid.axes[axis].centre(I[axis]);
          if (f.symbol == "p_g" && grid.inside(I)) {
            EXPECT_NEAR(value, outside + gradient * height, 1e-8 * gradient * setup.box.upper(axis))
                << column_name(f) << " (" << I[0] << ", " << I[1] << ')';
          } else if (f.symbol == "u" && f.face_axis == axis && grid.is_face(axis, I)) {
            EXPECT_NEAR(value, u, 1e-10 * u) << column_name(f) << " (" << I[0] << ", " << I[1] << ')';
          } else if (f.symbol != "u" && f.symbol != "p_g") {
            EXPECT_EQ(result[i], state[i]) << column_name(f) << " stands still";
          }
        }
      });
    }
}

/// Particles that move through a varying bed push gas about: out of an open side, or in circles.
TEST_F(ConsistentGas, MakesRoomForMovingParticles) {
  solve_exactly("gas_start_");
  for (const auto gas : {GasModel::darcy, GasModel::incompressible})
    for (const bool open : {false, true}) {
      ProblemSetup setup =
          sample_setup({2, FrictionModel::relaxed, TemperatureModel::transport, AdvectionScheme::van_albada, gas});
      if (open) setup.segments.push_back(side(1, true, condition(BoundaryKind::open)));
      Evaluation problem(PETSC_COMM_WORLD, setup);
      const Values state = problem.values([&](const Field& f, const Index& I) {
        if (f.symbol == "p_g" || f.symbol == "u") return 0.0;
        const bool side_face = f.face_axis >= 0 && (I[f.face_axis] == 0 || !problem.lattice().inside(I));
        return side_face || !problem.lattice().inside(I) ? 0.0 : random_value(f, I, Regime::dense, 6);
      });
      SCOPED_TRACE("gas model " + std::to_string(static_cast<int>(gas)) + (open ? ", open" : ", closed"));
      const double before = imbalance(problem, state);
      const Values result = made_consistent(problem, state);
      EXPECT_LT(imbalance(problem, result), 1e-10 * before);
      for (int i = 0; i < problem.size(); ++i)
        if (const Field& f = problem.fields()[i % problem.unknowns()]; f.symbol != "u" && f.symbol != "p_g") {
          EXPECT_EQ(result[i], state[i]) << column_name(f);
        }
    }
}

/// The flow of an inlet at the time asked for.
TEST_F(ConsistentGas, TakesInletsAtTheTimeGiven) {
  solve_exactly("gas_start_");
  for (const auto gas : {GasModel::darcy, GasModel::incompressible}) {
    ProblemSetup setup = sample_setup(uniform_box(1, {8, 0, 0}), FrictionModel::none, TemperatureModel::constant,
                                      AdvectionScheme::upwind, gas);
    Condition inlet = condition(BoundaryKind::gas_inlet);
    inlet.gas_velocity = 0.2;
    inlet.gas_variation.history = {{1, 2, 3}, {1, 3, 3}};
    inlet.from = 1.5;
    setup.segments = {side(0, false, condition(BoundaryKind::symmetry)), side(0, false, inlet),
                      side(0, true, condition(BoundaryKind::open))};
    Evaluation problem(PETSC_COMM_WORLD, setup, 2.0);
    const Values state =
        problem.values([&](const Field& f, const Index& I) { return f.symbol == "nu" && I[0] < 8 ? 0.5 : 0.0; });
    const Values result = made_consistent(problem, state, 2.0);
    EXPECT_NEAR(problem.outflow(result, Phase::gas), 0, 1e-10);
    EXPECT_LT(imbalance(problem, result), 1e-9);
    Vec x;
    double up = 0;
    check(DMCreateGlobalVector(problem.problem().dm(), &x));
    problem.put(result, x);
    check(problem.problem().plane_flux(2.0, x, Phase::gas, 0, 8e-3, Patch(), &up));
    check(VecDestroy(&x));
    EXPECT_NEAR(up, 0.6, 1e-9) << "gas model " << static_cast<int>(gas);
  }
}

TEST_F(ConsistentGas, DoesNothingWithoutGas) {
  Evaluation problem(PETSC_COMM_WORLD,
                     sample_setup({1, FrictionModel::relaxed, TemperatureModel::transport, AdvectionScheme::upwind}));
  const Values state =
      problem.values([](const Field& f, const Index& I) { return random_value(f, I, Regime::dense, 7); });
  EXPECT_EQ(made_consistent(problem, state), state);
}

/// The options of the run's own solver are not those of this step.
TEST_F(ConsistentGas, IsNotReachedByOptionsOfTheRun) {
  solve_exactly("gas_start_");
  for (const auto& [name, value] :
       {std::pair("-snes_max_it", "1"), {"-snes_atol", "1e-300"}, {"-snes_rtol", "1e-300"}, {"-ts_type", "bdf"}})
    check(PetscOptionsSetValue(nullptr, name, value));
  ProblemSetup setup = sample_setup(
      {2, FrictionModel::relaxed, TemperatureModel::transport, AdvectionScheme::upwind, GasModel::incompressible});
  Evaluation problem(PETSC_COMM_WORLD, setup);
  const Values state = problem.values([&](const Field& f, const Index& I) {
    return f.symbol == "nu" && problem.lattice().inside(I) ? 0.5 : f.symbol == "T" ? 1e-4 : 0.0;
  });
  made_consistent(problem, state);  // expects that it works
}

}  // namespace
}  // namespace scree::test
