/// Rows that the closures give by hand: uniform dilation, shear of a varying bed, a wall along unequal cells, a plate.
#include <gtest/gtest.h>

#include "../../jacobian/scenes.hpp"
#include "scree/closures/stress.hpp"

namespace scree::test {
namespace {

/// SI to stored residual of momentum [N/m3].
double momentum_scale(const ProblemSetup& setup) {
  return setup.scales.time / (setup.solids.kinetic.rho_s * setup.scales.velocity);
}

/// v = E x along every axis: production of T and relaxation of chi are those of the closures at S:S = E^2 (dim -
/// dim^2/3).
TEST(UniformDilation, SourcesAreThoseOfTheClosures) {
  for (int dim = 1; dim <= 3; ++dim)
    for (const double E : {4.0, -4.0}) {
      ProblemSetup setup = sample_setup(graded_box(dim, {6, 5, 5}));
      setup.segments = all_sides(setup.box, condition(BoundaryKind::open));
      setup.model.void_fraction_floor = 0;
      Evaluation problem(PETSC_COMM_SELF, setup);
      const double nu = 0.56, T = 1e-4, chi = 0.95;
      const Values residual = problem.residual(problem.values([&](const Field& f, const Index& I) {
        if (f.face_axis >= 0) return E * problem.lattice().axes[f.face_axis].face(I[f.face_axis]);
        return f.symbol == "nu" ? nu : f.symbol == "T" ? T : chi;
      }),
                                               problem.zeros());
      const SolidsPoint<double> point{nu, T, chi, dim * E, E * E * (dim - dim * dim / 3.0)};
      const auto closure = cell_closure(point, setup.solids);
      const double V = setup.scales.velocity, t = setup.scales.time, rho_s = setup.solids.kinetic.rho_s;
      const Index cell{{3, dim > 1 ? 2 : 0, dim > 2 ? 2 : 0}};
      SCOPED_TRACE(std::to_string(dim) + "d, div v = " + std::to_string(dim * E) + " 1/s");
      const double energy = -closure[CellClosure::energy_source] * t / (rho_s * V * V);
      EXPECT_NEAR(residual[problem.at(problem.component("T"), cell)], energy, 1e-10 * std::abs(energy));
      const double relaxation = -nu * (closure[CellClosure::chi_star] - chi) / setup.solids.friction.tau * t;
      EXPECT_NEAR(residual[problem.at(problem.component("chi"), cell)], relaxation, 1e-10 * std::abs(relaxation));
      EXPECT_NEAR(residual[problem.at(0, cell)], nu * dim * E * t, 1e-12) << "continuity";
    }
}

/// v = E x from a wall at rest: rho_s nu v dv/dx at every face, by the second-order scheme exactly, also beside the
/// wall.
TEST(UniformDilation, AdvectionIsExactUpToTheWall) {
  for (const auto kind : {BoundaryKind::wall_free_slip, BoundaryKind::symmetry}) {
    ProblemSetup setup = sample_setup(uniform_box(1, {8, 0, 0}), FrictionModel::none, TemperatureModel::constant,
                                      AdvectionScheme::van_albada);
    setup.segments = {side(0, false, condition(kind)), side(0, true, condition(BoundaryKind::open))};
    setup.model.void_fraction_floor = 0;
    Evaluation problem(PETSC_COMM_SELF, setup);
    const double nu = 0.3, E = 5;
    const Axis& x = problem.lattice().axes[0];
    const Values residual = problem.residual(
        problem.values([&](const Field& f, const Index& I) { return f.symbol == "nu" ? nu : E * x.face(I[0]); }),
        problem.zeros());
    for (int i = 1; i < 8; ++i) {
      const double expected = setup.solids.kinetic.rho_s * nu * E * E * x.face(i) * momentum_scale(setup);
      EXPECT_NEAR(residual[problem.at(1, {{i, 0, 0}})], expected, 1e-10) << "face " << i;
    }
  }
}

/// v_x = gdot y where nu varies linearly in both directions: stresses with the nu of the place, on unequal cells.
TEST(UniformShear, StressFollowsTheSolidsFractionAtTheEdges) {
  ProblemSetup setup = sample_setup(graded_box(2, {6, 5, 0}), FrictionModel::none, TemperatureModel::constant);
  setup.segments = all_sides(setup.box, condition(BoundaryKind::symmetry));
  setup.model.void_fraction_floor = 0;
  Evaluation problem(PETSC_COMM_SELF, setup);
  const Axis &x = problem.lattice().axes[0], &y = problem.lattice().axes[1];
  const double gdot = 3;
  const auto nu = [](double at_x, double at_y) { return 0.4 + 5 * at_x - 7 * at_y; };
  const Values residual = problem.residual(problem.values([&](const Field& f, const Index& I) {
    if (f.symbol == "nu") return nu(x.centre(I[0]), y.centre(I[1]));
    return f.face_axis == 0 ? gdot * y.centre(I[1]) : 0.0;
  }),
                                           problem.zeros());
  const KineticParameters& k = setup.solids.kinetic;
  const double T = setup.solids.temperature_value, sqrt_T = std::sqrt(T), scale = momentum_scale(setup);
  const auto sigma = [&](int i, int j) { return -shear_viscosity(nu(x.face(i), y.face(j)), sqrt_T, k) * gdot; };
  const auto p = [&](int i, int j) { return kinetic_pressure(nu(x.centre(i), y.centre(j)), T, k); };
  const int i = 3, j = 2;
  const double along_x = (sigma(i, j + 1) - sigma(i, j)) / y.width(j) + (p(i, j) - p(i - 1, j)) / x.distance(i);
  const double along_y = (sigma(i + 1, j) - sigma(i, j)) / x.width(i) + (p(i, j) - p(i, j - 1)) / y.distance(j);
  EXPECT_NEAR(residual[problem.at(1, {{i, j, 0}})], along_x * scale, 1e-9 * std::abs(along_x * scale));
  EXPECT_NEAR(residual[problem.at(2, {{i, j, 0}})], along_y * scale, 1e-9 * std::abs(along_y * scale));
}

/// What a wall with friction adds to one without: each cell beside it its own traction, by its share in the volume.
TEST(WallTraction, OfUnequalCellsIsWeightedByTheirShares) {
  for (int across = 0; across < 2; ++across) {
    const int along = 1 - across;
    ProblemSetup rough = sample_setup(graded_box(2, {6, 6, 0}), FrictionModel::none, TemperatureModel::constant);
    rough.model.void_fraction_floor = 0;
    ProblemSetup smooth = rough;
    smooth.segments = all_sides(rough.box, condition(BoundaryKind::wall_free_slip));
    const double v = 0.03;
    const auto nu = [](int i) { return 0.5 + 0.02 * i; };
    const auto residual = [&](const ProblemSetup& setup) {
      Evaluation problem(PETSC_COMM_SELF, setup);
      return problem.residual(problem.values([&](const Field& f, const Index& I) {
        return f.symbol == "nu" ? nu(I[along]) : f.face_axis == along ? v : 0.0;
      }),
                              problem.zeros());
    };
    Evaluation problem(PETSC_COMM_SELF, rough);
    Index cell;
    cell[along] = 3;
    const double below = problem.lattice().axes[along].lower_share(3), width = problem.lattice().axes[across].width(0);
    const double sqrt_T = std::sqrt(rough.solids.temperature_value + rough.solids.temperature_floor);
    const auto c = [&](int i) {
      return wall_traction_coefficient(nu(i), sqrt_T, 0.0, v * v, rough.solids.kinetic,
                                       rough.segments[0].condition.wall);
    };
    const double expected = (below * c(2) + (1 - below) * c(3)) * v / width * momentum_scale(rough);
    const int row = problem.at(1 + along, cell);
    EXPECT_NEAR(residual(rough)[row] - residual(smooth)[row], expected, 1e-9 * expected)
        << "wall across "
        << "xyz"[across] << ", shares " << below << " and " << 1 - below;
  }
}

/// A plate over the whole width makes two boxes: below it every row is that of the lower box alone, whatever is above.
TEST(Plate, SeparatesTheTwoSides) {
  for (const auto advection : {AdvectionScheme::upwind, AdvectionScheme::van_albada})
    for (const auto kind :
         {BoundaryKind::wall_johnson_jackson, BoundaryKind::wall_no_slip, BoundaryKind::wall_free_slip})
      for (int axis = 0; axis < 2; ++axis) {
        ProblemSetup divided =
            sample_setup(graded_box(2, {6, 6, 0}), FrictionModel::relaxed, TemperatureModel::transport, advection);
        const Condition wall = condition(kind, {axis == 0 ? 0.0 : 0.02, axis == 0 ? 0.02 : 0.0, 0});
        divided.plates.push_back(sample_plate(divided.box, axis, wall));
        divided.plates[0].openings.clear();
        ProblemSetup lower = divided;
        lower.plates.clear();
        lower.box.faces[axis].resize(4);
        for (Segment& segment : lower.segments)
          if (segment.axis == axis && segment.upper) segment.condition = wall;
        Evaluation whole(PETSC_COMM_SELF, divided), part(PETSC_COMM_SELF, lower);
        const auto state = [](const Evaluation& e) {
          return e.values([](const Field& f, const Index& I) { return random_value(f, I, Regime::dense, 1); });
        };
        const Values in_whole = whole.residual(state(whole), whole.zeros());
        const Values in_part = part.residual(state(part), part.zeros());
        SCOPED_TRACE("plate of kind " + std::to_string(static_cast<int>(kind)) + " across " + "xyz"[axis]);
        for_each_node(Index{}, part.nodes(), [&](const Index& I) {
          for (const Field& f : part.fields()) {
            if (I[axis] == 3 && f.face_axis != axis) continue;  // padding of the lower box
            const double expected = in_part[part.at(f.component, I)];
            EXPECT_NEAR(in_whole[whole.at(f.component, I)], expected, 1e-12 * (1 + std::abs(expected)))
                << column_name(f) << " (" << I[0] << ", " << I[1] << ')';
          }
        });
      }
}

}  // namespace
}  // namespace scree::test
