/// Rows that the closures give by hand: uniform dilation, shear of a varying bed, a wall along unequal cells, a plate;
/// drag, pressure gradient and viscous stress of the gas, and its inlets.
#include <gtest/gtest.h>

#include <sstream>

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
      setup.model.solids_fraction_floor = 0;
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
    setup.model.solids_fraction_floor = 0;
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
  setup.model.solids_fraction_floor = 0;
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
    rough.model.solids_fraction_floor = 0;
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
      // only collisions: c w = k (v - w) with k the viscosity over half the cell
      const double collisions =
          wall_traction_coefficient(nu(i), sqrt_T, 0.0, 0.0, rough.solids.kinetic, rough.segments[0].condition.wall);
      const double k = shear_viscosity(nu(i), sqrt_T, rough.solids.kinetic) / (0.5 * width);
      return collisions * k / (collisions + k);
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
        for (const auto gas : {GasModel::none, GasModel::darcy, GasModel::incompressible}) {
          ProblemSetup divided = sample_setup(graded_box(2, {6, 6, 0}), FrictionModel::relaxed,
                                              TemperatureModel::transport, advection, gas);
          divided.model.gas_viscous_stress = true;
          const Condition wall = sticky(condition(kind, {axis == 0 ? 0.0 : 0.02, axis == 0 ? 0.02 : 0.0, 0}));
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
          SCOPED_TRACE("plate of kind " + std::string(kind.name) + " across " + "xyz"[axis] + ", gas model " +
                       std::to_string(static_cast<int>(gas)));
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
}

// ---- gas ----

/// Uniform particles and gas with a slip that varies, in a box whose interior rows know nothing of the sides.
ProblemSetup gas_setup(int dim, GasModel gas) {
  ProblemSetup setup = sample_setup(graded_box(dim, {6, 5, 4}), FrictionModel::none, TemperatureModel::constant,
                                    AdvectionScheme::upwind, gas);
  setup.segments = all_sides(setup.box, condition(BoundaryKind::symmetry));
  setup.model.solids_fraction_floor = setup.model.darcy_solids_fraction = 0;
  return setup;
}

/// Calls work(axis, I) for the faces of each axis at which a control volume does not touch the sides.
template <class Work>
void each_inner_face(const Evaluation& problem, Work&& work) {
  const int dim = problem.lattice().dim;
  for_each_node(Index{}, problem.nodes(), [&](const Index& I) {
    bool inner = true;
    for (int a = 0; a < dim; ++a) inner = inner && I[a] >= 1 && I[a] < problem.lattice().axes[a].cells() - 1;
    for (int axis = 0; axis < dim && inner; ++axis) work(axis, I);
  });
}

/// What a state needs to know of one of the two phases at a face, SI.
struct AtFace {
  const Evaluation& problem;
  const Values& state;
  double operator()(int component, const Index& I) const {
    return problem.fields()[static_cast<std::size_t>(component)].scale * state[problem.at(component, I)];
  }
  double mean(int component, int axis, const Index& I) const {
    const double share = problem.lattice().axes[axis].lower_share(I[axis]);
    return share * (*this)(component, I - unit(axis)) + (1 - share) * (*this)(component, I);
  }
};

/// Half a cell each, with its own nu and its own |u - v|^2, and the gradient of p_g; the phases get opposite drag, and
/// the gradient by their shares of the volume. u is uniform, so that the rows of u hold nothing else; those of v hold
/// what they hold without gas where v is uniform.
TEST(Drag, ActsOnBothPhasesByTheCellsAboutAFace) {
  for (int dim = 1; dim <= 3; ++dim)
    for (const bool gas_is_uniform : {true, false}) {
      const ProblemSetup setup = gas_setup(dim, GasModel::incompressible);
      ProblemSetup vacuum = setup;
      vacuum.solids.gas.model = GasModel::none;
      Evaluation problem(PETSC_COMM_SELF, setup), without(PETSC_COMM_SELF, vacuum);
      const double wind[] = {0.04, -0.03, 0.02};
      const auto value = [&](const Field& f, const Index& I) {
        const bool uniform = f.face_axis >= 0 && (f.symbol == "u") == gas_is_uniform;
        return uniform ? wind[f.face_axis] : random_value(f, I, Regime::dense, 11);
      };
      const Values state = problem.values(value), residual = problem.residual(state, problem.zeros());
      const Values in_vacuum = without.residual(without.values(value), without.zeros());
      const AtFace at{problem, state};
      const int p = problem.component("p_g"), first_u = problem.component("u");
      const double V = setup.scales.velocity, t = setup.scales.time, rho_s = setup.solids.kinetic.rho_s;
      each_inner_face(problem, [&](int axis, const Index& I) {
        const Index e = unit(axis);
        const Axis& x = problem.lattice().axes[axis];
        const int v = 1 + axis, u = first_u + axis;
        const auto beta = [&](const Index& cell) {
          double squared = 0;
          for (int a = 0; a < dim; ++a) {
            double w = 0;
            for (int side = 0; side < 2; ++side)
              w += 0.5 * (at(first_u + a, cell + side * unit(a)) - at(1 + a, cell + side * unit(a)));
            squared += w * w;
          }
          return drag_coefficient(at(0, cell), squared, setup.solids.kinetic.d, setup.solids.gas);
        };
        const double share = x.lower_share(I[axis]), nu = at.mean(0, axis, I);
        const double drag = (share * beta(I - e) + (1 - share) * beta(I)) * (at(u, I) - at(v, I));
        const double gradient = (at(p, I) - at(p, I - e)) / x.distance(I[axis]);
        std::ostringstream place;
        place << dim << "d, "
              << "xyz"[axis] << " face of (" << I[0] << ", " << I[1] << ", " << I[2] << ')';
        if (gas_is_uniform) {
          const double expected = ((1 - nu) * gradient + drag) * t / (setup.scales.density * V);
          EXPECT_NEAR(residual[problem.at(u, I)], expected, 1e-11 * (std::abs(expected) + 1)) << "gas, " << place.str();
        } else {
          const double expected = (nu * gradient - drag) * t / (rho_s * V);
          const double rest = in_vacuum[without.at(v, I)];
          EXPECT_NEAR(residual[problem.at(v, I)] - rest, expected, 1e-11 * (std::abs(rest) + std::abs(expected)))
              << "particles, " << place.str();
        }
      });
    }
}

/// Without inertia of the gas, drag on the particles is what its pressure gradient on the gas is.
TEST(Drag, OfAGasWithoutInertiaIsItsPressureGradient) {
  for (int dim = 1; dim <= 3; ++dim) {
    const ProblemSetup setup = gas_setup(dim, GasModel::darcy);
    ProblemSetup vacuum = setup;
    vacuum.solids.gas.model = GasModel::none;
    Evaluation problem(PETSC_COMM_SELF, setup), without(PETSC_COMM_SELF, vacuum);
    const auto value = [&](const Field& f, const Index& I) {
      return f.face_axis >= 0 ? 0.02 : random_value(f, I, Regime::dense, 12);
    };
    const Values state = problem.values(value), residual = problem.residual(state, problem.zeros());
    const Values in_vacuum = without.residual(without.values(value), without.zeros());
    const AtFace at{problem, state};
    const int p = problem.component("p_g");
    each_inner_face(problem, [&](int axis, const Index& I) {
      const double gradient = (at(p, I) - at(p, I - unit(axis))) / problem.lattice().axes[axis].distance(I[axis]);
      const double expected = gradient * momentum_scale(setup), rest = in_vacuum[without.at(1 + axis, I)];
      EXPECT_NEAR(residual[problem.at(1 + axis, I)] - rest, expected, 1e-11 * (std::abs(rest) + std::abs(expected)))
          << dim << "d, axis " << axis;
    });
  }
}

/// A state of uniform slip, oblique to the axes, or of the uniform gradient of p_g that gives it; p_g = 0 where u is an
/// unknown. `value` gives nu, v and T.
struct UniformSlip {
  std::array<double, max_dim> slip{0.3, -0.2, 0.15};     ///< u - v where u is an unknown [m/s]
  std::array<double, max_dim> gradient{900, -500, 700};  ///< of p_g otherwise [Pa/m]

  template <class Value>
  Values state(const Evaluation& problem, Value&& value) const {
    const bool has_u = problem.component("u") >= 0;
    return problem.values([&](const Field& f, const Index& I) {
      if (f.symbol == "u")
        return value(problem.fields()[static_cast<std::size_t>(1 + f.face_axis)], I) + slip[f.face_axis];
      if (f.symbol != "p_g") return value(f, I);
      double p = 0;
      for (int a = 0; a < problem.lattice().dim && !has_u; ++a)
        p += gradient[a] * problem.lattice().axes[a].centre(I[a]);
      return p;
    });
  }
  /// |u - v|^2 where the solids fraction is nu.
  double squared(const ProblemSetup& setup, double nu) const {
    const bool has_u = setup.solids.gas.model == GasModel::incompressible;
    double sum = 0;
    for (int a = 0; a < setup.box.dim; ++a) sum += has_u ? slip[a] * slip[a] : gradient[a] * gradient[a];
    return has_u ? sum : darcy_slip_squared(nu, sum, 0.0, setup.solids.kinetic.d, setup.solids.gas);
  }
  double drag_over_nu_at(const ProblemSetup& setup, double nu) const {
    return drag_over_nu(nu, squared(setup, nu), setup.solids.kinetic.d, setup.solids.gas);
  }
};

/// (1-nu) u = (1-nu) (v - (1-nu)/beta grad p_g) with beta of the whole slip, not of one component.
TEST(GasFlux, OfAGasWithoutInertiaFollowsTheWholeGradient) {
  for (int dim = 1; dim <= 3; ++dim) {
    const ProblemSetup setup = gas_setup(dim, GasModel::darcy);
    Evaluation problem(PETSC_COMM_SELF, setup);
    const double nu = 0.45, v = 0.02;
    const UniformSlip flow;
    const Values state = flow.state(problem, [&](const Field& f, const Index&) { return f.symbol == "nu" ? nu : v; });
    const double beta = nu * flow.drag_over_nu_at(setup, nu);
    Vec x;
    check(DMCreateGlobalVector(problem.problem().dm(), &x));
    problem.put(state, x);
    for (int axis = 0; axis < dim; ++axis) {
      Patch middle;
      double area = 1, flux = 0;
      for (int a = 0; a < dim; ++a) {
        if (a == axis) continue;
        middle.lower[a] = setup.box.faces[a][1];
        middle.upper[a] = setup.box.faces[a][2];
        area *= middle.upper[a] - middle.lower[a];
      }
      check(problem.problem().plane_flux(0, x, Phase::gas, axis, setup.box.faces[axis][2], middle, &flux));
      const double expected = (1 - nu) * (v - (1 - nu) / beta * flow.gradient[axis]) * area;
      EXPECT_NEAR(flux, expected, 1e-10 * std::abs(expected)) << dim << "d along "
                                                              << "xyz"[axis];
    }
    check(VecDestroy(&x));
  }
}

/// k* of (1.5) at the mean nu and T of a face, and the slip there.
TEST(GasDamping, OfConductionIsThatOfTheSlipAtAFace) {
  for (int dim = 1; dim <= 3; ++dim)
    for (const auto gas : {GasModel::darcy, GasModel::incompressible}) {
      ProblemSetup setup = gas_setup(dim, gas);
      set_temperature_model(setup, TemperatureModel::transport);
      Evaluation problem(PETSC_COMM_SELF, setup);
      const UniformSlip flow;
      const auto nu = [](const Index& I) { return 0.3 + 0.02 * I[0] - 0.01 * I[1] + 0.015 * I[2]; };
      const auto T = [](const Index& I) { return 1e-4 * (1 + 0.3 * noise(I, 3, 16)); };
      const Values residual = problem.residual(flow.state(problem,
                                                          [&](const Field& f, const Index& I) {
                                                            if (f.symbol == "nu") return nu(I);
                                                            return f.symbol == "T" ? T(I) : 0.0;
                                                          }),
                                               problem.zeros());
      const KineticParameters& k = setup.solids.kinetic;
      const double V = setup.scales.velocity, t = setup.scales.time;
      const Index I{{2, dim > 1 ? 2 : 0, dim > 2 ? 1 : 0}};
      double expected = 0;
      for (int a = 0; a < dim; ++a)
        for (int side = 0; side < 2; ++side) {
          const Index face = I + side * unit(a), below = face - unit(a);
          const Axis& x = problem.lattice().axes[a];
          const double share = x.lower_share(face[a]);
          const double nu_face = share * nu(below) + (1 - share) * nu(face);
          const double T_face = share * T(below) + (1 - share) * T(face);
          const double kappa = conductivity(nu_face, sqrt_temperature(T_face, setup.solids.temperature_floor),
                                            flow.drag_over_nu_at(setup, nu_face), k);
          const double q = kappa * (T(below) - T(face)) / x.distance(face[a]);
          expected += (side == 0 ? -1 : 1) * q / x.width(I[a]);
        }
      // What is no flux: dissipation and agitation by the gas, at rest.
      const double sqrt_T = sqrt_temperature(T(I), setup.solids.temperature_floor);
      expected += dissipation(nu(I), T(I), sqrt_T, k) +
                  viscous_dissipation(nu(I), T(I), sqrt_T, nu(I) * flow.drag_over_nu_at(setup, nu(I)),
                                      flow.squared(setup, nu(I)), setup.solids.gas.mu_g, k);
      const double scale = t / (k.rho_s * V * V);
      EXPECT_NEAR(residual[problem.at(problem.component("T"), I)], expected * scale, 1e-9 * std::abs(expected * scale))
          << dim << "d, gas model " << static_cast<int>(gas);
    }
}

/// mu* of (1.5) on edges where nu varies, by the slip there; with the drag and the pressure gradient at the face.
TEST(GasDamping, OfShearIsThatOfTheSlipAtAnEdge) {
  for (int dim = 2; dim <= 3; ++dim)
    for (const auto gas : {GasModel::darcy, GasModel::incompressible}) {
      const ProblemSetup setup = gas_setup(dim, gas);
      Evaluation problem(PETSC_COMM_SELF, setup);
      const UniformSlip flow;
      const Axis &x = problem.lattice().axes[0], &y = problem.lattice().axes[1];
      const double gdot = 3;
      const auto nu = [](double at_x, double at_y) { return 0.4 + 5 * at_x - 7 * at_y; };
      const Values residual = problem.residual(flow.state(problem,
                                                          [&](const Field& f, const Index& I) {
                                                            if (f.symbol == "nu")
                                                              return nu(x.centre(I[0]), y.centre(I[1]));
                                                            return f.face_axis == 0 ? gdot * y.centre(I[1]) : 0.0;
                                                          }),
                                               problem.zeros());
      const KineticParameters& k = setup.solids.kinetic;
      const double T = setup.solids.temperature_value, sqrt_T = sqrt_temperature(T, setup.solids.temperature_floor);
      const auto sigma = [&](int i, int j) {
        const double at = nu(x.face(i), y.face(j));
        return -shear_viscosity(at, sqrt_T, flow.drag_over_nu_at(setup, at), k) * gdot;
      };
      const auto p = [&](int i, int j) { return kinetic_pressure(nu(x.centre(i), y.centre(j)), T, k); };
      const int i = 3, j = 2;
      double expected = (sigma(i, j + 1) - sigma(i, j)) / y.width(j) + (p(i, j) - p(i - 1, j)) / x.distance(i);
      if (gas == GasModel::darcy) {
        expected += flow.gradient[0];
      } else {
        const auto beta = [&](int cell) {
          const double at = nu(x.centre(cell), y.centre(j));
          return at * flow.drag_over_nu_at(setup, at);
        };
        const double share = x.lower_share(i);
        expected -= (share * beta(i - 1) + (1 - share) * beta(i)) * flow.slip[0];
      }
      expected *= momentum_scale(setup);
      const Index I{{i, j, dim > 2 ? 1 : 0}};
      EXPECT_NEAR(residual[problem.at(1, I)], expected, 1e-9 * std::abs(expected))
          << dim << "d, gas model " << static_cast<int>(gas);
    }
}

/// Acceleration of the gas, and its own velocity carried by the mean of the fluxes of two cells. No slip, no drag.
TEST(GasMomentum, IsThatOfTheVolumeOfGas) {
  const ProblemSetup setup = gas_setup(1, GasModel::incompressible);
  Evaluation problem(PETSC_COMM_SELF, setup);
  const auto value = [](const Field& f, const Index& I) {
    if (f.face_axis >= 0) return 0.3 + 0.1 * noise(I, 1, 13);
    return f.symbol == "p_g" ? 0.0 : random_value(f, I, Regime::dense, 13);
  };
  const Values state = problem.values(value);
  const Values rate = problem.values([](const Field& f, const Index& I) { return 5 * f.scale * noise(I, 2, 14); });
  const Values residual = problem.residual(state, rate);
  const AtFace at{problem, state}, changes{problem, rate};
  const int u = problem.component("u");
  const double rho_g = setup.solids.gas.rho_g;
  each_inner_face(problem, [&](int, const Index& I) {
    const Index e = unit(0);
    const auto flux = [&](const Index& face) { return face[0] == 0 ? 0 : (1 - at.mean(0, 0, face)) * at(u, face); };
    const double carried = 0.5 * (flux(I) + flux(I - e)) * (at(u, I) - at(u, I - e));  // all flow upwards
    const double expected =
        rho_g * ((1 - at.mean(0, 0, I)) * changes(u, I) + carried / problem.lattice().axes[0].distance(I[0]));
    const double scale = setup.scales.time / (setup.scales.density * setup.scales.velocity);
    EXPECT_NEAR(residual[problem.at(u, I)], expected * scale, 1e-11 * std::abs(expected * scale)) << "face " << I[0];
  });
}

/// The gas of a side has (1-nu) u as given: nu on the line through two cells, as far as nu can be that, or what an
/// inlet brings.
TEST(GasMomentum, InletsHaveTheirSuperficialVelocityAtTheSide) {
  struct Row {
    BoundaryKind kind;
    double first, second, expected;  // nu of the two cells before the side, and at it
  };
  const Row rows[] = {{BoundaryKind::gas_inlet, 0.5, 0.4, 0.55},
                      {BoundaryKind::gas_inlet, 0.6, 0.0, 0.65},
                      {BoundaryKind::gas_inlet, 0.1, 0.5, 0.0},
                      {BoundaryKind::inlet, 0.5, 0.4, 0.3}};
  for (const Row& row : rows)
    for (const bool upper : {false, true}) {
      ProblemSetup setup = gas_setup(2, GasModel::incompressible);
      setup.box = uniform_box(2, {6, 6, 0});
      setup.model.advection = AdvectionScheme::van_albada;
      Condition inlet = condition(row.kind);
      inlet.gas_velocity = 0.2;
      inlet.bring(SolidsContinuity::unknown, 0.3);
      setup.segments = all_sides(setup.box, condition(BoundaryKind::symmetry));
      setup.segments.push_back(side(1, upper, inlet));
      Evaluation problem(PETSC_COMM_SELF, setup);
      const int face = upper ? 6 : 0, first = upper ? 5 : 0, second = upper ? 4 : 1;
      const Values residual = problem.residual(problem.values([&](const Field& f, const Index& I) {
        if (f.symbol == "nu") return I[1] == first ? row.first : I[1] == second ? row.second : 0.5;
        return f.symbol == "u" && f.face_axis == 1 && I[1] == face ? (upper ? -1 : 1) * 0.2 / (1 - row.expected) : 0.0;
      }),
                                               problem.zeros());
      EXPECT_NEAR(residual[problem.at(problem.component("u") + 1, Index{{2, face, 0}})], 0, 1e-14)
          << row.kind.name << ", nu " << row.first << ", " << row.second;
    }
}

/// Gas from an inlet brings nothing along the side: the row of u beside it holds flux times u, on either side.
TEST(GasMomentum, InletsBlowStraightIn) {
  for (const auto kind : {BoundaryKind::gas_inlet, BoundaryKind::inlet})
    for (int axis = 0; axis < 2; ++axis)
      for (const bool upper : {false, true}) {
        ProblemSetup setup = gas_setup(2, GasModel::incompressible);
        Condition inlet = condition(kind);
        inlet.gas_velocity = 0.3;
        setup.segments.push_back(side(axis, upper, inlet));
        Evaluation problem(PETSC_COMM_SELF, setup);
        const int along = 1 - axis, face = upper ? problem.lattice().axes[axis].cells() : 0;
        const double u = 0.07, nu = 0.4;
        const Values residual = problem.residual(problem.values([&](const Field& f, const Index& I) {
          if (f.symbol == "nu") return nu;
          if (f.face_axis == along) return u;
          return f.symbol == "u" && I[axis] == face ? (upper ? -1 : 1) * 0.3 / (1 - nu) : 0.0;
        }),
                                                 problem.zeros());
        Index cell{{2, 2, 0}};
        cell[axis] = upper ? face - 1 : 0;
        const double scale = setup.scales.time / (setup.scales.density * setup.scales.velocity);
        const double expected =
            setup.solids.gas.rho_g * 0.3 * u / problem.lattice().axes[axis].width(cell[axis]) * scale;
        EXPECT_NEAR(residual[problem.at(problem.component("u") + along, cell)], expected, 1e-12 * expected)
            << "kind " << kind.name << (upper ? ", upper " : ", lower ") << "xyz"[axis];
      }
}

/// u_x = a y^2 + b x^2 where nu varies: the force -div of sigma, each phase by its share of the volume.
TEST(GasViscosity, ActsOnBothPhasesByTheirVolume) {
  ProblemSetup with = gas_setup(2, GasModel::incompressible), without = with;
  with.model.gas_viscous_stress = true;
  Evaluation problem(PETSC_COMM_SELF, with), inviscid(PETSC_COMM_SELF, without);
  const Axis &x = problem.lattice().axes[0], &y = problem.lattice().axes[1];
  const double a = 3e4, b = 2e4, mu = with.solids.gas.mu_g;
  const auto u = [&](int i, int j) { return a * y.centre(j) * y.centre(j) + b * x.face(i) * x.face(i); };
  const Values state = problem.values([&](const Field& f, const Index& I) {
    if (f.symbol == "nu") return random_value(f, I, Regime::dense, 15);
    return f.symbol == "u" && f.face_axis == 0 ? u(I[0], I[1]) : 0.0;
  });
  const Values residual = problem.residual(state, problem.zeros()), rest = inviscid.residual(state, problem.zeros());
  const AtFace at{problem, state};
  each_inner_face(problem, [&](int axis, const Index& I) {
    const int i = I[0], j = I[1];
    const auto D_xx = [&](int cell) { return (u(cell + 1, j) - u(cell, j)) / x.width(cell); };
    const auto sigma_xx = [&](int cell) { return -2 * mu * (1 - 1.0 / 3) * D_xx(cell); };
    const auto sigma_xy = [&](int edge) { return -mu * (u(i, edge) - u(i, edge - 1)) / y.distance(edge); };
    // sigma_yy = 2/3 mu D_xx and sigma_xy do not vary along y and x
    const double force =
        axis == 1 ? 0 : (sigma_xx(i) - sigma_xx(i - 1)) / x.distance(i) + (sigma_xy(j + 1) - sigma_xy(j)) / y.width(j);
    const double nu = at.mean(0, axis, I), V = with.scales.velocity, t = with.scales.time;
    const int on_gas = problem.at(problem.component("u") + axis, I), on_particles = problem.at(1 + axis, I);
    const double size = mu * a * t / V;
    EXPECT_NEAR(residual[on_gas] - rest[on_gas], (1 - nu) * force * t / (with.scales.density * V),
                1e-9 * size / with.scales.density + 1e-14 * std::abs(rest[on_gas]))
        << "gas, face (" << i << ", " << j << "), axis " << axis;
    EXPECT_NEAR(residual[on_particles] - rest[on_particles], nu * force * momentum_scale(with),
                1e-9 * size / with.solids.kinetic.rho_s + 1e-14 * std::abs(rest[on_particles]))
        << "particles, face (" << i << ", " << j << "), axis " << axis;
  });
}

/// What a wall adds to which gas sticks: mu (u - wall)/(half a cell) over the cell, also where it is a plate.
TEST(GasViscosity, WallActsOnTheCellBeside) {
  for (int across = 0; across < 2; ++across)
    for (const bool upper : {false, true})
      for (const bool plate : {false, true}) {
        const int along = 1 - across;
        ProblemSetup smooth = gas_setup(2, GasModel::incompressible);
        smooth.box = graded_box(2, {6, 6, 0});
        smooth.model.gas_viscous_stress = true;
        std::array<double, max_dim> velocity{0, 0, 0};
        velocity[along] = 0.07;
        ProblemSetup sticking = smooth;
        for (const bool sticks : {false, true}) {
          Condition wall = condition(BoundaryKind::wall_free_slip, velocity);
          wall.gas_no_slip = sticks;
          ProblemSetup& setup = sticks ? sticking : smooth;
          if (plate) {
            setup.plates.push_back(sample_plate(setup.box, across, wall));
            setup.plates[0].openings.clear();
          } else {
            setup.segments.push_back(side(across, upper, wall));
          }
        }
        Evaluation slips(PETSC_COMM_SELF, smooth), problem(PETSC_COMM_SELF, sticking);
        const double u = 0.03;
        const Values state = problem.values([&](const Field& f, const Index& I) {
          if (f.symbol == "nu") return 0.5 + 0.02 * I[along];
          return f.symbol == "u" && f.face_axis == along ? u : 0.0;
        });
        const Values residual = problem.residual(state, problem.zeros()), rest = slips.residual(state, problem.zeros());
        const Axis& normal = problem.lattice().axes[across];
        const int beside = plate ? (upper ? 2 : 3) : (upper ? 5 : 0);
        const double force = smooth.solids.gas.mu_g * (u - 0.07) / (0.5 * normal.width(beside) * normal.width(beside));
        Index cell;
        cell[along] = 3;
        cell[across] = beside;
        const double nu = AtFace{problem, state}.mean(0, along, cell);
        const double scale = smooth.scales.time / smooth.scales.velocity;
        const int on_gas = problem.at(problem.component("u") + along, cell), on_particles = problem.at(1 + along, cell);
        SCOPED_TRACE(std::string(plate ? "plate" : "side") + " across " + "xyz"[across] +
                     (upper ? " above" : " below"));
        EXPECT_NEAR(residual[on_gas] - rest[on_gas], (1 - nu) * force * scale / smooth.scales.density,
                    1e-9 * std::abs(force) * scale / smooth.scales.density);
        EXPECT_NEAR(residual[on_particles] - rest[on_particles], nu * force * momentum_scale(smooth),
                    1e-9 * std::abs(force) * momentum_scale(smooth));
        cell[across] += beside < 3 ? 1 : -1;
        if (!plate) {
          const int away = problem.at(problem.component("u") + along, cell);
          EXPECT_EQ(residual[away], rest[away]) << "one cell further";
        }
      }
}

/// Superficial velocity times profile times history, into the box on either side.
TEST(GasInlet, LetsInWhatItsConditionSays) {
  for (const auto gas : {GasModel::darcy, GasModel::incompressible})
    for (int axis = 0; axis < 2; ++axis)
      for (const bool upper : {false, true}) {
        ProblemSetup setup = gas_setup(2, gas);
        Condition inlet = condition(BoundaryKind::gas_inlet);
        const int along = 1 - axis;
        inlet.gas_velocity = 0.4;
        inlet.gas_variation.axis = along;
        inlet.gas_variation.profile = {{0, 0.02}, {0, 4}};  // 200/m
        inlet.gas_variation.history = {{0, 10}, {1, 3}};
        setup.segments.push_back(side(axis, upper, inlet));
        const double time = 2.5, factor = 1.5;
        Evaluation problem(PETSC_COMM_SELF, setup, time);
        const Axis &x = problem.lattice().axes[along], &normal = problem.lattice().axes[axis];
        const int face = upper ? normal.cells() : 0;
        const auto given = [&](int i) { return 0.4 * factor * 200 * x.centre(i); };
        const auto nu = [&](const Index& I) { return 0.4 + 0.01 * I[along] + 0.02 * I[axis]; };
        const Values state = problem.values([&](const Field& f, const Index& I) {
          if (f.symbol == "nu") return problem.lattice().inside(I) ? nu(I) : 0.0;
          if (f.symbol != "u" || f.face_axis != axis || I[axis] != face || I[along] >= x.cells()) return 0.0;
          return (upper ? -1 : 1) * given(I[along]) / (1 - nu(upper ? I - unit(axis) : I));
        });
        double flow = 0;
        for (int i = 0; i < x.cells(); ++i) flow += given(i) * x.width(i);
        SCOPED_TRACE("gas model " + std::to_string(static_cast<int>(gas)) + (upper ? ", upper " : ", lower ") +
                     "xyz"[axis]);
        EXPECT_NEAR(problem.outflow(state, Phase::gas), -flow, 1e-14 * flow);
        EXPECT_EQ(problem.outflow(state), 0) << "no particles";
        const Values residual = problem.residual(state, problem.zeros());
        for (int i = 0; i < x.cells(); ++i) {
          Index I;
          I[along] = i;
          I[axis] = face;
          if (gas == GasModel::incompressible) {
            const int u = problem.at(problem.component("u") + axis, I);
            EXPECT_NEAR(residual[u], 0, 1e-14) << "u that brings this";
            Values other = state;
            other[u] += 1;
            EXPECT_GT(std::abs(problem.residual(other, problem.zeros())[u]), 0.1);
          }
          const Index cell = upper ? I - unit(axis) : I;
          const int p = problem.at(problem.component("p_g"), cell);
          EXPECT_NEAR(residual[p], -given(i) / normal.width(cell[axis]) * setup.scales.time, 1e-12)
              << "into the cell beside it";
        }
      }
}

}  // namespace
}  // namespace scree::test
