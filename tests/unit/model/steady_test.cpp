/// States whose residual is known by hand: uniform flow, a column at rest, gas through a bed, uniform shear; and which
/// way forces act.
#include <gtest/gtest.h>

#include <memory>

#include "../../jacobian/scenes.hpp"
#include "scree/closures/stress.hpp"

namespace scree::test {
namespace {

double largest(const Values& residual, const Evaluation& problem, int component) {
  double result = 0;
  for (int i = component; i < problem.size(); i += problem.unknowns())
    result = std::max(result, std::abs(residual[static_cast<std::size_t>(i)]));
  return result;
}

// ---- uniform flow ----

constexpr double free_stream_pressure = 40;  // of gas [Pa]

/// Whether the lower `axis` face of I is on a side that is open as a whole.
bool on_open_side(const ProblemSetup& setup, const Lattice& grid, int axis, const Index& I) {
  if (!grid.is_face(axis, I) || !grid.on_side(axis, I)) return false;
  for (const Segment& segment : setup.segments)
    if (segment.axis == axis && segment.upper != grid.inside(I)) return segment.condition.kind == BoundaryKind::open;
  return false;
}

/// Every row is zero but that of T, which cools by collisions and by the gas between the particles, and that of v on
/// open sides, where the stream pushes into the void.
void expect_free_stream(const ProblemSetup& setup, const std::array<double, max_dim>& wind, double nu, double T) {
  Evaluation problem(PETSC_COMM_WORLD, setup);
  const Values state = problem.values([&](const Field& f, const Index& I) {
    if (f.symbol == "nu") return problem.lattice().inside(I) ? nu : 0.0;
    if (f.symbol == "T") return problem.lattice().inside(I) ? T : 0.0;
    if (f.symbol == "chi") return problem.lattice().inside(I) ? 1.0 : 0.0;
    if (f.symbol == "p_g") return problem.lattice().inside(I) ? free_stream_pressure : 0.0;
    return problem.lattice().is_face(f.face_axis, I) ? wind[f.face_axis] : 0.0;
  });
  const Values residual = problem.residual(state, problem.zeros());
  const KineticParameters& k = setup.solids.kinetic;
  const double V = setup.scales.velocity;
  double loss = dissipation(nu, T, sqrt_temperature(T, setup.solids.temperature_floor), k);
  if (setup.solids.gas.model != GasModel::none) loss += 3 * drag_coefficient(nu, 0.0, k.d, setup.solids.gas) * T;
  const double cooling = loss * setup.scales.time / (k.rho_s * V * V);
  const double push =
      solids_stress(SolidsPoint<double>{nu, T, 1, 0, 0}, setup.solids)[0] * setup.scales.time / (k.rho_s * V);
  const double pressure = largest(residual, problem, 0) + 1;  // rows of v: pressures of 1e4 times rho_s g dx cancel
  for_each_node(Index{}, problem.nodes(), [&](const Index& I) {
    for (const Field& f : problem.fields()) {
      const bool cell = problem.lattice().inside(I);
      double expected = f.symbol == "T" && cell ? cooling : 0;
      if (f.symbol == "v" &&
          on_open_side(setup, problem.lattice(), f.face_axis, I))  // nothing outside holds back what pushes out
        expected = (cell ? 1 : -1) * push / problem.lattice().control_length(f.face_axis, I);
      EXPECT_NEAR(residual[problem.at(f.component, I)], expected, 1e-10 * pressure + 1e-12 * cooling)
          << column_name(f) << " (" << I[0] << ", " << I[1] << ", " << I[2] << ')';
    }
  });
}

TEST(UniformFlow, StaysAsItIsOnGradedCells) {
  for (int dim = 1; dim <= 3; ++dim)
    for (const auto advection : {AdvectionScheme::upwind, AdvectionScheme::van_albada})
      for (const double sign : {1.0, -1.0}) {
        const Combination c{dim, FrictionModel::relaxed, TemperatureModel::transport, advection};
        const std::array<double, max_dim> wind{0.05 * sign, -0.03 * sign, 0.02 * sign};
        ProblemSetup setup = sample_setup(c);
        setup.model.solids_fraction_floor = 0;
        setup.segments.clear();
        Condition inlet = condition(BoundaryKind::inlet, wind);
        inlet.bring(SolidsContinuity::unknown, 0.56);
        inlet.bring(GranularEnergy::unknown, 1e-4);
        // Out of the box by an open side along x, by an inlet that takes away along the other axes.
        for (int axis = 0; axis < dim; ++axis)
          for (const bool upper : {false, true}) {
            const bool downstream = upper == (wind[axis] > 0);
            setup.segments.push_back(side(axis, upper, downstream ? condition(BoundaryKind::open) : inlet));
          }
        SCOPED_TRACE(name_of(c) + (sign > 0 ? ", along" : ", against") + " x, from inlet to open side");
        expect_free_stream(setup, wind, 0.56, 1e-4);

        setup.box.periodic = {true, true, true};
        setup.segments.clear();
        SCOPED_TRACE("periodic");
        expect_free_stream(setup, wind, 0.56, 1e-4);
      }
}

TEST(UniformFlow, SlidesAlongMovingWalls) {
  for (const auto kind :
       {BoundaryKind::wall_johnson_jackson, BoundaryKind::wall_no_slip, BoundaryKind::wall_free_slip}) {
    ProblemSetup setup =
        sample_setup({2, FrictionModel::critical_state, TemperatureModel::constant, AdvectionScheme::van_albada});
    setup.model.solids_fraction_floor = 0;
    setup.box.periodic = {true, false, false};
    setup.segments = all_sides(setup.box, condition(kind, {0.05, 0, 0}));
    SCOPED_TRACE("walls of kind " + std::string(kind.name));
    expect_free_stream(setup, {0.05, 0, 0}, 0.58, 1e-4);
  }
}

/// The gas goes with the particles: no slip, no drag. An inlet blows straight in, so that the wind is along one axis.
TEST(UniformFlow, OfBothPhasesStaysAsItIs) {
  for (int dim = 1; dim <= 3; ++dim)
    for (const auto gas : {GasModel::darcy, GasModel::incompressible})
      for (const auto advection : {AdvectionScheme::upwind, AdvectionScheme::van_albada})
        for (const double speed : {0.05, -0.05}) {
          const Combination c{dim, FrictionModel::relaxed, TemperatureModel::transport, advection, gas};
          ProblemSetup setup = sample_setup(c);
          setup.model.solids_fraction_floor = 0;
          setup.model.gas_viscous_stress = true;
          for (int axis = 0; axis < dim; ++axis) {
            std::array<double, max_dim> wind{0, 0, 0};
            wind[axis] = speed;
            Condition inlet = condition(BoundaryKind::inlet, wind), opening = condition(BoundaryKind::open);
            inlet.bring(SolidsContinuity::unknown, 0.56);
            inlet.bring(GranularEnergy::unknown, 1e-4);
            inlet.gas_velocity = 0.05 * (1 - 0.56);
            opening.gas_pressure = free_stream_pressure;
            setup.segments = all_sides(setup.box, condition(BoundaryKind::symmetry));
            for (Segment& segment : setup.segments)
              if (segment.axis == axis) segment.condition = segment.upper == (speed > 0) ? opening : inlet;
            SCOPED_TRACE(name_of(c) + ", along " + (speed > 0 ? '+' : '-') + "xyz"[axis]);
            expect_free_stream(setup, wind, 0.56, 1e-4);
          }
          setup.box.periodic = {true, true, true};
          setup.segments.clear();
          SCOPED_TRACE(name_of(c) + ", periodic");
          expect_free_stream(setup, {speed, -0.6 * speed, 0.4 * speed}, 0.56, 1e-4);
        }
}

TEST(UniformFlow, OfGasSlidesAlongMovingWalls) {
  for (const auto gas : {GasModel::darcy, GasModel::incompressible}) {
    ProblemSetup setup =
        sample_setup({2, FrictionModel::critical_state, TemperatureModel::constant, AdvectionScheme::van_albada, gas});
    setup.model.solids_fraction_floor = 0;
    setup.model.gas_viscous_stress = true;
    setup.box.periodic = {true, false, false};
    setup.segments = all_sides(setup.box, sticky(condition(BoundaryKind::wall_no_slip, {0.05, 0, 0})));
    SCOPED_TRACE("gas model " + std::to_string(static_cast<int>(gas)));
    expect_free_stream(setup, {0.05, 0, 0}, 0.58, 1e-4);
  }
}

// ---- column at rest ----

/// sigma of particles at rest at the given T [Pa].
double pressure_at_rest(double nu, double T, const SolidsParameters& p) {
  return solids_stress(SolidsPoint<double>{nu, T, 1.0, 0.0, 0.0}, p)[0];
}

void expect_column_at_rest(int axis, FrictionModel friction, GasModel gas) {
  const int dim = std::max(2, axis + 1);
  std::array<int, max_dim> cells{3, 3, 3};
  cells[axis] = 12;
  ProblemSetup setup =
      sample_setup(graded_box(dim, cells, 1e-3), friction, TemperatureModel::constant, AdvectionScheme::upwind, gas);
  const double g = 9.81, T = setup.solids.temperature_value;
  const double density = setup.solids.kinetic.rho_s - (gas == GasModel::none ? 0 : setup.solids.gas.rho_g);
  setup.model.gravity[axis] = -g;
  Evaluation problem(PETSC_COMM_WORLD, setup);
  const Axis& z = problem.lattice().axes[axis];
  std::vector<double> nu(12, 0.53);  // the top cell; below, the pressure of each balances the weight above
  for (int i = 10; i >= 0; --i) {
    const double above = nu[static_cast<std::size_t>(i + 1)], share = z.lower_share(i + 1);
    double low = above, high = 0.6499;
    for (int step = 0; step < 200; ++step) {
      const double middle = 0.5 * (low + high);
      const double weight = density * g * (share * middle + (1 - share) * above) * z.distance(i + 1);
      const bool heavy = pressure_at_rest(above, T, setup.solids) + weight > pressure_at_rest(middle, T, setup.solids);
      (heavy ? low : high) = middle;
    }
    nu[static_cast<std::size_t>(i)] = low;
  }
  EXPECT_GT(nu[0], nu[11] + 0.01) << "denser below";
  const Values state = problem.values([&](const Field& f, const Index& I) {
    if (!problem.lattice().inside(I)) return 0.0;
    return f.symbol == "nu" ? nu[static_cast<std::size_t>(I[axis])] : f.symbol == "chi" ? 1.0 : 0.0;
  });
  const Values residual = problem.residual(state, problem.zeros());
  for (const Field& f : problem.fields())
    EXPECT_LT(largest(residual, problem, f.component), 1e-9)
        << column_name(f) << ", in units of rho_s g; rounding of nu in a stiff p_c";
}

/// In gas less what that weighs: p_g is over the pressure of gas at rest.
TEST(ColumnAtRest, CarriesItsWeightExactly) {
  for (int axis = 0; axis < 3; ++axis)
    for (const auto friction : {FrictionModel::critical_state, FrictionModel::relaxed, FrictionModel::instantaneous})
      for (const auto gas : {GasModel::none, GasModel::darcy, GasModel::incompressible}) {
        SCOPED_TRACE("gravity along " + std::string(1, "xyz"[axis]) + ", friction model " +
                     std::string(friction->name) + ", gas model " + std::to_string(static_cast<int>(gas)));
        expect_column_at_rest(axis, friction, gas);
      }
}

TEST(ColumnAtRest, UniformColumnIsPulledDown) {
  for (const auto gas : {GasModel::none, GasModel::darcy, GasModel::incompressible}) {
    ProblemSetup setup = sample_setup(uniform_box(2, {4, 6, 0}), FrictionModel::critical_state,
                                      TemperatureModel::constant, AdvectionScheme::upwind, gas);
    setup.model.gravity = {0, -9.81, 0};
    Evaluation problem(PETSC_COMM_WORLD, setup);
    const Values state = problem.values([](const Field& f, const Index&) { return f.symbol == "nu" ? 0.57 : 0.0; });
    const Values residual = problem.residual(state, problem.zeros());
    const double buoyancy = gas == GasModel::none ? 0 : setup.solids.gas.rho_g / setup.solids.kinetic.rho_s;
    const double weight = 0.57 * (1 - buoyancy) * 9.81 * setup.scales.time / setup.scales.velocity;
    SCOPED_TRACE("gas model " + std::to_string(static_cast<int>(gas)));
    EXPECT_NEAR(residual[problem.at(2, {{1, 3, 0}})], weight, 1e-9) << "F = nu (dv/dt - g), g downwards";
    EXPECT_NEAR(residual[problem.at(1, {{2, 3, 0}})], 0, 1e-9);
    for (const Field& f : problem.fields())
      if (f.symbol == "u" || f.symbol == "p_g") {
        EXPECT_EQ(largest(residual, problem, f.component), 0) << "still gas: " << column_name(f);
      }
  }
}

/// Without gravity nothing happens to uniform phases at rest, dense, dilute or absent.
TEST(UniformRest, InGasIsSteady) {
  for (int dim = 1; dim <= 3; ++dim)
    for (const auto gas : {GasModel::darcy, GasModel::incompressible})
      for (const double nu : {0.0, 0.01, 0.57}) {
        ProblemSetup setup = sample_setup(
            {dim, FrictionModel::critical_state, TemperatureModel::algebraic, AdvectionScheme::van_albada, gas});
        setup.model.gas_viscous_stress = true;
        Evaluation problem(PETSC_COMM_WORLD, setup);
        const Values residual = problem.residual(problem.values([&](const Field& f, const Index& I) {
          if (!problem.lattice().inside(I)) return 0.0;
          return f.symbol == "nu" ? nu : f.symbol == "p_g" ? -20.0 : 0.0;
        }),
                                                 problem.zeros());
        for (const Field& f : problem.fields())
          EXPECT_LT(largest(residual, problem, f.component), 1e-10)
              << dim << "d, gas model " << static_cast<int>(gas) << ", nu " << nu << ": " << column_name(f);
      }
}

// ---- gas through a bed ----

/// A uniform bed through which gas flows along an axis at superficial velocity U, and the residual of that state.
struct Percolation {
  Percolation(ProblemSetup bed, int axis, double nu, double U, double gradient) : setup(std::move(bed)) {
    setup.model.solids_fraction_floor = setup.model.darcy_solids_fraction = 0;
    setup.model.gas_viscous_stress = true;
    Condition inlet = condition(BoundaryKind::gas_inlet), opening = condition(BoundaryKind::open);
    inlet.gas_velocity = std::abs(U);
    opening.gas_pressure = 0.01 * std::abs(gradient);
    setup.segments = all_sides(setup.box, condition(BoundaryKind::symmetry));
    for (Segment& segment : setup.segments)
      if (segment.axis == axis) segment.condition = segment.upper == (U > 0) ? opening : inlet;
    problem = std::make_unique<Evaluation>(PETSC_COMM_WORLD, setup);
    const Axis& z = problem->lattice().axes[axis];
    const double end = z.face(U > 0 ? z.cells() : 0);
    state = problem->values([&](const Field& f, const Index& I) {
      const bool inside = problem->lattice().inside(I);
      if (f.symbol == "u" && f.face_axis == axis) return problem->lattice().is_face(axis, I) ? U / (1 - nu) : 0.0;
      if (f.symbol == "p_g") return inside ? opening.gas_pressure + gradient * (z.centre(I[axis]) - end) : 0.0;
      return f.symbol == "nu" && inside ? nu : 0.0;
    });
    residual = problem->residual(state, problem->zeros());
  }
  double beta(double nu, double slip) const {
    return drag_coefficient(nu, slip * slip, setup.solids.kinetic.d, setup.solids.gas);
  }
  ProblemSetup setup;
  std::unique_ptr<Evaluation> problem;
  Values state, residual;
};

/// (1-nu) grad p = -beta u at Re of 1e-2, 30 and 2000: towards the open side, and up to it.
TEST(Percolation, FixedBedHasThePressureGradientOfDrag) {
  for (int dim = 1; dim <= 3; ++dim)
    for (int axis = 0; axis < dim; ++axis)
      for (const auto gas : {GasModel::darcy, GasModel::incompressible})
        for (const double nu : {0.1, 0.6})
          for (const double U : {1.5e-4, 0.4, -0.4, 30.0}) {
            ProblemSetup setup = sample_setup(
                {dim, FrictionModel::critical_state, TemperatureModel::constant, AdvectionScheme::van_albada, gas});
            setup.model.solids_moving = false;
            setup.model.gravity = {1, -9.81, 2};
            const double u = U / (1 - nu);
            const double gradient =
                -drag_coefficient(nu, u * u, setup.solids.kinetic.d, setup.solids.gas) * u / (1 - nu);
            const Percolation bed(setup, axis, nu, U, gradient);
            SCOPED_TRACE(std::to_string(dim) + "d along " + "xyz"[axis] + ", gas model " +
                         std::to_string(static_cast<int>(gas)) + ", nu " + std::to_string(nu) + ", U " +
                         std::to_string(U));
            const double t = setup.scales.time, width = 2e-3;
            for (const Field& f : bed.problem->fields()) {
              const double size = f.symbol == "u"
                                      ? std::abs(gradient) * t / (setup.scales.density * setup.scales.velocity)
                                  : f.symbol == "p_g" ? std::abs(U) / width * t
                                                      : 1;
              EXPECT_LT(largest(bed.residual, *bed.problem, f.component), 2e-11 * size) << column_name(f);
            }
            const double outflow = bed.problem->outflow(bed.state, Phase::gas);
            EXPECT_NEAR(outflow, 0, 1e-11 * std::abs(U)) << "what comes in goes out";
          }
}

/// Where the pressure gradient carries the weight of the bed in gas the particles float, without contact.
TEST(Percolation, BedFloatsWhereGasCarriesItsWeight) {
  for (int dim = 1; dim <= 3; ++dim)
    for (const auto gas : {GasModel::darcy, GasModel::incompressible}) {
      const int axis = dim - 1;
      const double nu = 0.5, g = 9.81;
      ProblemSetup setup =
          sample_setup({dim, FrictionModel::none, TemperatureModel::constant, AdvectionScheme::upwind, gas});
      setup.model.gravity[axis] = -g;
      setup.solids.temperature_value = 0;  // at the open side nothing outside holds back a pressure of collisions
      const KineticParameters& k = setup.solids.kinetic;
      const double weight = nu * (k.rho_s - setup.solids.gas.rho_g) * g;
      const double slip2 = darcy_slip_squared(nu, weight * weight, 0.0, k.d, setup.solids.gas);
      const double U = (1 - nu) * std::sqrt(slip2);
      const Percolation bed(setup, axis, nu, U, -weight);
      ASSERT_NEAR(bed.beta(nu, std::sqrt(slip2)) * std::sqrt(slip2) / (1 - nu), weight, 1e-10 * weight);
      for (const Field& f : bed.problem->fields()) {
        const double density = f.symbol == "u" ? setup.scales.density : k.rho_s;
        const double size = f.symbol == "p_g" ? U / 2e-3 * setup.scales.time
                                              : weight * setup.scales.time / (density * setup.scales.velocity);
        EXPECT_LT(largest(bed.residual, *bed.problem, f.component), 2e-10 * size)
            << dim << "d, gas model " << static_cast<int>(gas) << ": " << column_name(f);
      }
    }
}

// ---- uniform shear ----

struct Matched {  // T7 of tests/VERIFICATION.md, cgs there
  double nu = 0.3, T = 1e-4, d = 1e-3, e_w = 0.91, gdot = 8.632049, slip = 0.889454e-2, specularity = 0.325927;
};

/// Couette flow between walls across `axis` whose slip and heat balance fit: every row is zero on any grid.
TEST(UniformShear, MatchedCouetteFlowIsSteady) {
  for (int dim = 2; dim <= 3; ++dim)
    for (int axis = 0; axis < dim; ++axis)
      for (const auto advection : {AdvectionScheme::upwind, AdvectionScheme::van_albada}) {
        const Matched m;
        const int along = (axis + 1) % dim;
        std::array<int, max_dim> cells{3, 3, 3};
        cells[axis] = 5;
        if (dim == 2) cells[0] = std::max(cells[0], 6);
        if (dim == 3) cells[0] = 6;
        Box box = uniform_box(dim, cells, 1e-3);
        for (int a = 0; a < dim; ++a) box.periodic[a] = a != axis;
        box.faces[axis] = graded_faces(cells[axis], 1e-3, 1.2);
        ProblemSetup setup = sample_setup(box, FrictionModel::critical_state, TemperatureModel::transport, advection);
        setup.solids.kinetic.d = setup.solids.friction.d = m.d;
        setup.model.solids_fraction_floor = 0;
        setup.segments.clear();
        for (const bool up : {false, true}) {
          Condition wall = condition(BoundaryKind::wall_johnson_jackson);
          wall.wall.specularity = m.specularity;
          wall.wall.e_w = m.e_w;
          wall.velocity[along] = m.gdot * (up ? box.upper(axis) : box.lower(axis)) + (up ? m.slip : -m.slip);
          setup.segments.push_back(side(axis, up, wall));
        }
        Evaluation problem(PETSC_COMM_WORLD, setup);
        const Values state = problem.values([&](const Field& f, const Index& I) {
          if (!problem.lattice().inside(I)) return 0.0;
          if (f.symbol == "nu") return m.nu;
          if (f.symbol == "T") return m.T;
          return f.face_axis == along ? m.gdot * problem.lattice().axes[axis].centre(I[axis]) : 0.0;
        });
        const Values residual = problem.residual(state, problem.zeros());
        SCOPED_TRACE(std::to_string(dim) + "d, walls across " + "xyz"[axis]);
        // Size of the terms: stress over a cell, and collisional loss.
        const double momentum = shear_viscosity(m.nu, std::sqrt(m.T), setup.solids.kinetic) * m.gdot / 1e-3 *
                                setup.scales.time / (setup.solids.kinetic.rho_s * setup.scales.velocity);
        const double energy = dissipation(m.nu, m.T, std::sqrt(m.T), setup.solids.kinetic) * setup.scales.time /
                              (setup.solids.kinetic.rho_s * std::pow(setup.scales.velocity, 2));
        for (const Field& f : problem.fields())
          EXPECT_LT(largest(residual, problem, f.component), 2e-6 * (f.symbol == "T" ? energy : momentum))
              << column_name(f) << "; T7 is given with 6 digits";
      }
}

/// The row of one unknown raised above uniform surroundings; the residual of what resists is positive.
double row_of_raised(const ProblemSetup& setup, const std::string& symbol, int component, const Index& at,
                     double raise) {
  Evaluation problem(PETSC_COMM_SELF, setup);
  const auto residual = [&](double more) {
    return problem.residual(problem.values([&](const Field& f, const Index& I) {
      if (!problem.lattice().inside(I)) return 0.0;
      const double uniform = f.symbol == "nu" ? 0.57 : f.symbol == "T" ? 1e-4 : f.symbol == "chi" ? 1.0 : 0.0;
      return uniform + (f.component == component && I == at ? more : 0.0);
    }),
                            problem.zeros());
  };
  const int row = problem.at(symbol.empty() ? component : problem.component(symbol), at);
  return residual(raise)[row] - residual(0)[row];
}

TEST(Signs, ViscosityWallsAndConductionActAgainstDifferences) {
  for (const auto friction : {FrictionModel::none, FrictionModel::critical_state, FrictionModel::relaxed}) {
    ProblemSetup setup = sample_setup(uniform_box(3, {4, 4, 4}), friction);
    setup.solids.kinetic.e_p = 1;
    setup.model.solids_fraction_floor = 0;
    SCOPED_TRACE("friction model " + std::string(friction->name));
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_GT(row_of_raised(setup, "", 1 + axis, {{2, 2, 2}}, 1e-3), 0) << "viscosity on v_"
                                                                          << "xyz"[axis];
    EXPECT_GT(row_of_raised(setup, "T", 4, {{2, 2, 2}}, 1e-6), 0) << "conduction";
  }
}

/// Compression in one dimension: sigma_xx = p - (eta mu_b + 4/3 mu_s) dv/dx, S_xx being two thirds of dv/dx.
TEST(Signs, NormalStressResistsCompression) {
  for (int dim = 1; dim <= 3; ++dim)
    for (int axis = 0; axis < dim; ++axis) {
      std::array<int, max_dim> cells{5, 5, 5};
      ProblemSetup setup = sample_setup(uniform_box(dim, cells), FrictionModel::none, TemperatureModel::constant);
      setup.segments = all_sides(setup.box, condition(BoundaryKind::symmetry));
      setup.model.solids_fraction_floor = 0;
      Evaluation problem(PETSC_COMM_SELF, setup);
      const double nu = 0.57, raise = 1e-7, width = 2e-3;
      const Values residual = problem.residual(problem.values([&](const Field& f, const Index& I) {
        if (!problem.lattice().inside(I)) return 0.0;
        return f.symbol == "nu" ? nu : f.face_axis == axis && I[axis] == 2 ? raise : 0.0;
      }),
                                               problem.zeros());
      const KineticParameters& k = setup.solids.kinetic;
      const double sqrt_T = std::sqrt(setup.solids.temperature_value);
      const double mu = bulk_viscosity(nu, sqrt_T, k) + 4.0 / 3 * shear_viscosity(nu, sqrt_T, k);
      const double scale = setup.scales.time / (k.rho_s * setup.scales.velocity);
      const double expected = 2 * mu * raise / (width * width) * scale;
      Index middle{{2, dim > 1 ? 2 : 0, dim > 2 ? 2 : 0}};
      EXPECT_NEAR(residual[problem.at(1 + axis, middle)], expected, 1e-4 * expected)
          << dim << "d, axis " << axis << ": a plane moving alone; advection of 1e-7 m/s is below the tolerance";
    }
}

/// The root of an increasing function in [0, most], by halving.
template <class Function>
double root_of(Function&& f, double most) {
  double low = 0, high = most;
  for (int k = 0; k < 200; ++k) (f(0.5 * (low + high)) > 0 ? high : low) = 0.5 * (low + high);
  return 0.5 * (low + high);
}

/// The share of a wall in the balance of a tangential velocity in the cell beside it: (25) and (26) with the slip and
/// the granular temperature at which shear and conduction across half the cell bring what the wall takes.
TEST(Signs, WallLawsActOnTheCellBeside) {
  for (int across = 0; across < 2; ++across)
    for (const bool upper : {false, true})
      for (const double wall_velocity : {0.0, 0.08}) {
        const int along = 1 - across;
        const double nu = 0.57, T = 1e-4, v = 0.03, slip = v - wall_velocity;
        ProblemSetup setup = sample_setup(uniform_box(2, {6, 6, 0}), FrictionModel::critical_state);
        setup.box.periodic[along] = true;
        setup.box.faces[across] = graded_faces(6, 1e-3, 1.1);
        std::array<double, max_dim> velocity{0, 0, 0};
        velocity[along] = wall_velocity;
        setup.segments = {side(across, !upper, condition(BoundaryKind::symmetry)),
                          side(across, upper, condition(BoundaryKind::wall_johnson_jackson, velocity))};
        setup.model.solids_fraction_floor = 0;
        Evaluation problem(PETSC_COMM_WORLD, setup);
        const Values state = problem.values([&](const Field& f, const Index& I) {
          if (!problem.lattice().inside(I)) return 0.0;
          return f.symbol == "nu" ? nu : f.symbol == "T" ? T : f.face_axis == along ? v : 0.0;
        });
        const Values residual = problem.residual(state, problem.zeros());
        const WallParameters& wall = setup.segments[1].condition.wall;
        const KineticParameters& k = setup.solids.kinetic;
        const double sqrt_T = std::sqrt(T + setup.solids.temperature_floor);
        const double N = critical_pressure(nu, setup.solids.friction);
        const double width = problem.lattice().axes[across].width(upper ? 5 : 0), t = setup.scales.time;
        const double V = setup.scales.velocity;
        Index cell{{2, 2, 0}};
        cell[across] = upper ? 5 : 0;
        SCOPED_TRACE(std::string(upper ? "upper " : "lower ") + "xyz"[across] + " wall moving at " +
                     std::to_string(wall_velocity));
        SolidsPoint<double> point{nu, T, 1, 0, 0};
        const double mu = solids_stress(point, setup.solids)[1], kappa = conductivity(nu, 1.0, k);
        const auto slip_at_wall = [&](double sqrt_T_wall) {
          return root_of(
              [&](double w) {
                return wall_traction_coefficient(nu, sqrt_T_wall, N, w * w, k, wall) * w -
                       mu * (std::abs(slip) - w) / (0.5 * width);
              },
              std::abs(slip));
        };
        const double w = slip_at_wall(sqrt_T);
        const double root_T = root_of(
            [&](double x) {
              return 2. / 3 * kappa * (x * x * x - std::pow(sqrt_T, 3)) / (0.5 * width) -
                     wall_heat_flux(nu, x * x, x, w * w, k, wall);
            },
            1.0);
        const double drag = mu * (std::abs(slip) - slip_at_wall(root_T)) / (0.5 * width) / width * (slip > 0 ? 1 : -1);
        EXPECT_NEAR(residual[problem.at(1 + along, cell)], drag * t / (k.rho_s * V),
                    1e-9 * std::abs(drag) * t / (k.rho_s * V))
            << "F = ... + traction/width, towards the velocity of the wall";
        const double heat = wall_heat_flux(nu, root_T * root_T, root_T, w * w, k, wall) / width;
        const double loss = dissipation(nu, T, sqrt_T, k);
        EXPECT_NEAR(residual[problem.at(3, cell)], (loss - heat) * t / (k.rho_s * V * V),
                    1e-9 * (loss + std::abs(heat)) * t / (k.rho_s * V * V))
            << "F = ... + loss - heat from the wall";
        Index middle = cell;
        middle[across] = 3;
        EXPECT_NEAR(residual[problem.at(1 + along, middle)], 0, 1e-9) << "away from walls nothing happens";
      }
}

}  // namespace
}  // namespace scree::test
