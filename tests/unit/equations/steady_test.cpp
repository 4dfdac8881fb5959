/// States whose residual is known by hand: uniform flow, a column at rest, uniform shear; and which way forces act.
#include <gtest/gtest.h>

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

/// Every row is zero but that of T, which cools by collisions.
void expect_free_stream(const ProblemSetup& setup, const std::array<double, max_dim>& wind, double nu, double T) {
  Evaluation problem(PETSC_COMM_WORLD, setup);
  const Values state = problem.values([&](const Field& f, const Index& I) {
    if (f.symbol == "nu") return problem.lattice().inside(I) ? nu : 0.0;
    if (f.symbol == "T") return problem.lattice().inside(I) ? T : 0.0;
    if (f.symbol == "chi") return problem.lattice().inside(I) ? 1.0 : 0.0;
    return problem.lattice().is_face(f.face_axis, I) ? wind[f.face_axis] : 0.0;
  });
  const Values residual = problem.residual(state, problem.zeros());
  const KineticParameters& k = setup.solids.kinetic;
  const double V = setup.scales.velocity;
  const double cooling = dissipation(nu, T, sqrt_temperature(T, setup.solids.temperature_floor), k) *
                         setup.scales.time / (k.rho_s * V * V);
  const double pressure = largest(residual, problem, 0) + 1;  // rows of v: pressures of 1e4 times rho_s g dx cancel
  for_each_node(Index{}, problem.nodes(), [&](const Index& I) {
    for (const Field& f : problem.fields()) {
      const bool cell = problem.lattice().inside(I);
      const double expected = f.symbol == "T" && cell ? cooling : 0;
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
        setup.model.void_fraction_floor = 0;
        setup.segments.clear();
        Condition inlet = condition(BoundaryKind::inlet, wind);
        inlet.solids_fraction = 0.56;
        inlet.granular_temperature = 1e-4;
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
    setup.model.void_fraction_floor = 0;
    setup.box.periodic = {true, false, false};
    setup.segments = all_sides(setup.box, condition(kind, {0.05, 0, 0}));
    SCOPED_TRACE("walls of kind " + std::to_string(static_cast<int>(kind)));
    expect_free_stream(setup, {0.05, 0, 0}, 0.58, 1e-4);
  }
}

// ---- column at rest ----

/// sigma of particles at rest at the given T [Pa].
double pressure_at_rest(double nu, double T, const SolidsParameters& p) {
  return solids_stress(SolidsPoint<double>{nu, T, 1.0, 0.0, 0.0}, p)[0];
}

TEST(ColumnAtRest, CarriesItsWeightExactly) {
  for (int axis = 0; axis < 3; ++axis)
    for (const auto friction : {FrictionModel::critical_state, FrictionModel::relaxed, FrictionModel::instantaneous}) {
      const int dim = std::max(2, axis + 1);
      std::array<int, max_dim> cells{3, 3, 3};
      cells[axis] = 12;
      ProblemSetup setup = sample_setup(graded_box(dim, cells, 1e-3), friction, TemperatureModel::constant);
      const double g = 9.81, T = setup.solids.temperature_value, rho_s = setup.solids.kinetic.rho_s;
      setup.model.gravity[axis] = -g;
      Evaluation problem(PETSC_COMM_WORLD, setup);
      const Axis& z = problem.lattice().axes[axis];
      std::vector<double> nu(12, 0.53);  // the top cell; below, the pressure of each balances the weight above
      for (int i = 10; i >= 0; --i) {
        const double above = nu[static_cast<std::size_t>(i + 1)], share = z.lower_share(i + 1);
        double low = above, high = 0.6499;
        for (int step = 0; step < 200; ++step) {
          const double middle = 0.5 * (low + high);
          const double weight = rho_s * g * (share * middle + (1 - share) * above) * z.distance(i + 1);
          const bool heavy =
              pressure_at_rest(above, T, setup.solids) + weight > pressure_at_rest(middle, T, setup.solids);
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
      SCOPED_TRACE("gravity along " + std::string(1, "xyz"[axis]) + ", friction model " +
                   std::to_string(static_cast<int>(friction)));
      for (const Field& f : problem.fields())
        EXPECT_LT(largest(residual, problem, f.component), 1e-9)
            << column_name(f) << ", in units of rho_s g; rounding of nu in a stiff p_c";
    }
}

TEST(ColumnAtRest, UniformColumnIsPulledDown) {
  ProblemSetup setup =
      sample_setup(uniform_box(2, {4, 6, 0}), FrictionModel::critical_state, TemperatureModel::constant);
  setup.model.gravity = {0, -9.81, 0};
  Evaluation problem(PETSC_COMM_WORLD, setup);
  const Values state = problem.values([](const Field& f, const Index&) { return f.symbol == "nu" ? 0.57 : 0.0; });
  const Values residual = problem.residual(state, problem.zeros());
  const double scale = setup.scales.time / setup.scales.velocity;
  EXPECT_NEAR(residual[problem.at(2, {{1, 3, 0}})], 0.57 * 9.81 * scale, 1e-9) << "F = nu (dv/dt - g), g downwards";
  EXPECT_NEAR(residual[problem.at(1, {{2, 3, 0}})], 0, 1e-9);
}

// ---- uniform shear ----

struct Matched {  // T7 of verification.md, cgs there
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
        setup.model.void_fraction_floor = 0;
        const double lower = 0.5 * (box.faces[axis][0] + box.faces[axis][1]);
        const double upper = 0.5 * (box.upper(axis) + box.faces[axis][box.faces[axis].size() - 2]);
        setup.segments.clear();
        for (const bool up : {false, true}) {
          Condition wall = condition(BoundaryKind::wall_johnson_jackson);
          wall.wall.specularity = m.specularity;
          wall.wall.e_w = m.e_w;
          wall.velocity[along] = up ? m.gdot * upper + m.slip : m.gdot * lower - m.slip;
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
    setup.model.void_fraction_floor = 0;
    SCOPED_TRACE("friction model " + std::to_string(static_cast<int>(friction)));
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
      setup.model.void_fraction_floor = 0;
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

/// The share of a wall in the balance of a tangential velocity in the cell beside it: (25) and (26) with the cell's
/// values.
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
        setup.model.void_fraction_floor = 0;
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
        const double drag = wall_traction_coefficient(nu, sqrt_T, N, slip * slip, k, wall) * slip / width;
        EXPECT_NEAR(residual[problem.at(1 + along, cell)], drag * t / (k.rho_s * V), 1e-11 * std::abs(drag))
            << "F = ... + traction/width, towards the velocity of the wall";
        const double heat = wall_heat_flux(nu, T, sqrt_T, slip * slip, k, wall) / width;
        const double loss = dissipation(nu, T, sqrt_T, k);
        EXPECT_NEAR(residual[problem.at(3, cell)], (loss - heat) * t / (k.rho_s * V * V),
                    1e-11 * (loss + std::abs(heat)) * t / (k.rho_s * V * V))
            << "F = ... + loss - heat from the wall";
        Index middle = cell;
        middle[across] = 3;
        EXPECT_NEAR(residual[problem.at(1 + along, middle)], 0, 1e-9) << "away from walls nothing happens";
      }
}

}  // namespace
}  // namespace scree::test
