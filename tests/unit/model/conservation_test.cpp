/// What the balances conserve for any state: solids, volume, momentum, and the advected amounts of chi and T.
#include <gtest/gtest.h>

#include "../../jacobian/scenes.hpp"
#include "scree/closures/stress.hpp"

namespace scree::test {
namespace {

Values random_state(const Evaluation& problem, int seed) {
  return problem.values([&](const Field& f, const Index& I) { return random_value(f, I, Regime::dense, seed); });
}
Values random_rate(const Evaluation& problem, int seed) {
  return problem.values([&](const Field& f, const Index& I) { return 5 * f.scale * noise(I, f.component, seed); });
}

/// Calls work(I) for all cells of the box.
template <class Work>
void each_cell(const Evaluation& problem, Work&& work) {
  for_each_node(Index{}, problem.nodes(), [&](const Index& I) {
    if (problem.lattice().inside(I)) work(I);
  });
}

class Conservation : public testing::TestWithParam<std::tuple<int, AdvectionScheme, GasModel>> {
 protected:
  static int dim() { return std::get<0>(GetParam()); }
  static GasModel gas() { return std::get<2>(GetParam()); }
  static ProblemSetup base() {
    return sample_setup(
        Combination{dim(), FrictionModel::relaxed, TemperatureModel::transport, std::get<1>(GetParam()), gas()});
  }
  /// Periodic in all axes, cells of equal size along none.
  static ProblemSetup periodic() {
    ProblemSetup setup = base();
    setup.box.periodic = {true, true, true};
    setup.segments.clear();
    setup.model.solids_fraction_floor = setup.model.darcy_solids_fraction = 0;
    setup.model.gas_viscous_stress = true;
    return setup;
  }
};

class GasConservation : public Conservation {};

TEST_P(Conservation, SolidsChangeByWhatFlowsThroughTheSides) {
  for (const NamedScene& scene : all_scenes(base())) {
    if (!scene.setup.model.solids_moving) continue;
    SCOPED_TRACE(scene.name);
    Evaluation problem(PETSC_COMM_WORLD, scene.setup);
    const Values state = random_state(problem, 1), rate = random_rate(problem, 2);
    const Values residual = problem.residual(state, rate);
    const double scale = problem.problem().model().continuity_scale();
    double sum = 0, magnitude = 0;
    each_cell(problem, [&](const Index& I) {
      const double volume = problem.lattice().volume(I);
      const int nu = problem.at(0, I);
      sum += volume * (residual[nu] / scale - rate[nu]);
      magnitude += volume * std::abs(residual[nu] / scale);
    });
    const double outflow = problem.outflow(state);
    EXPECT_NEAR(sum, outflow, 1e-13 * magnitude) << "divergence summed over the box against outflow";
    bool closed = true;
    for (const Segment& segment : scene.setup.segments) closed = closed && segment.condition.kind.stops_solids();
    EXPECT_TRUE(!closed || outflow == 0) << "outflow " << outflow << " of a closed box";
  }
}

/// What leaves the cells leaves through the sides: the gas makes room for the particles.
TEST_P(GasConservation, VolumeIsKept) {
  for (const NamedScene& scene : all_scenes(base())) {
    SCOPED_TRACE(scene.name);
    Evaluation problem(PETSC_COMM_WORLD, scene.setup);
    const Values state = random_state(problem, 1), residual = problem.residual(state, random_rate(problem, 2));
    const double t = scene.setup.scales.time;
    double sum = 0, magnitude = 0;
    each_cell(problem, [&](const Index& I) {
      const double volume = problem.lattice().volume(I);
      const int p = problem.at(problem.component("p_g"), I);
      sum += volume / t * residual[p];
      magnitude += volume / t * std::abs(residual[p]);
    });
    const double solids = problem.outflow(state), gas_flow = problem.outflow(state, Phase::gas);
    EXPECT_NEAR(sum, solids + gas_flow, 1e-13 * magnitude) << "solids " << solids << ", gas " << gas_flow;
    bool closed = true;
    for (const Segment& segment : scene.setup.segments) closed = closed && segment.condition.kind.stops_gas();
    EXPECT_EQ(closed, gas_flow == 0) << "outflow " << gas_flow;
  }
}

/// F = rho_s (nu Dv/Dt); with v times continuity it is the conservative form, whose fluxes and stresses cancel; so does
/// drag with that of the gas, and its pressure.
TEST_P(Conservation, MomentumOfAPeriodicBoxIsKept) {
  Evaluation problem(PETSC_COMM_WORLD, periodic());
  const Values state = random_state(problem, 3), rate = random_rate(problem, 4);
  const Values residual = problem.residual(state, rate);
  const ProblemSetup& setup = problem.problem().setup();
  const double rho_s = setup.solids.kinetic.rho_s, rho_g = setup.solids.gas.rho_g;
  const double V = setup.scales.velocity, t = setup.scales.time;
  for (int axis = 0; axis < dim(); ++axis) {
    const Axis& along = problem.lattice().axes[axis];
    const int v = 1 + axis;
    double sum = 0, change = 0, magnitude = 0;
    each_cell(problem, [&](const Index& I) {  // the lower faces of all cells are all faces
      const Index below = I - unit(axis);
      const double volume = problem.lattice().volume(I) / along.width(I[axis]) * along.distance(I[axis]);
      const double share = along.lower_share(I[axis]);
      const auto face = [&](const Values& q, int component = 0) {
        return share * q[problem.at(component, below)] + (1 - share) * q[problem.at(component, I)];
      };
      const double velocity = V * state[problem.at(v, I)], acceleration = V * rate[problem.at(v, I)];
      double force = residual[problem.at(v, I)] * rho_s * V / t + rho_s * velocity * face(residual) / t;
      change += volume * rho_s * (face(state) * acceleration + face(rate) * velocity);
      if (gas() == GasModel::incompressible) {
        const int u = problem.at(problem.component("u") + axis, I);
        const double gas_divergence = (face(residual, problem.component("p_g")) - face(residual)) / t + face(rate);
        const double on_gas = residual[u] * setup.scales.density * V / t + rho_g * V * state[u] * gas_divergence;
        force += on_gas;
        change += volume * rho_g * (1 - face(state)) * V * rate[u];
        magnitude += volume * std::abs(on_gas);
      }
      sum += volume * force;
      magnitude += volume * std::abs(force);
    });
    EXPECT_NEAR(sum, change, 1e-12 * magnitude) << "momentum along "
                                                << "xyz"[axis] << " [N]";
  }
}

TEST_P(Conservation, ChiIsCarriedWithTheParticles) {
  ProblemSetup setup = periodic();
  setup.solids.friction.tau = 1e300;  // no source
  Evaluation problem(PETSC_COMM_WORLD, setup);
  const Values state = random_state(problem, 5), rate = random_rate(problem, 6);
  const Values residual = problem.residual(state, rate);
  const int chi = problem.component("chi");
  const double t = setup.scales.time;
  double sum = 0, change = 0, magnitude = 0;
  each_cell(problem, [&](const Index& I) {
    const double volume = problem.lattice().volume(I);
    const int a = problem.at(0, I), b = problem.at(chi, I);
    sum += volume / t * (residual[b] + state[b] * residual[a]);
    magnitude += volume / t * std::abs(residual[b]);
    change += volume * (state[a] * rate[b] + rate[a] * state[b]);
  });
  EXPECT_NEAR(sum, change, 1e-12 * magnitude);
}

/// Rigid motion of elastic particles: no production, no dissipation but that of the gas between them; advection and
/// conduction only move T about.
TEST_P(Conservation, FluctuationEnergyOfElasticParticlesInRigidMotionIsKept) {
  ProblemSetup setup = periodic();
  setup.solids.kinetic.e_p = 1;
  Evaluation problem(PETSC_COMM_WORLD, setup);
  const double wind[] = {0.04, -0.03, 0.02};
  const Values state = problem.values([&](const Field& f, const Index& I) {
    return f.symbol == "p_g" ? 3.0 : f.face_axis >= 0 ? wind[f.face_axis] : random_value(f, I, Regime::dense, 7);
  });
  const Values rate = random_rate(problem, 8);
  const Values residual = problem.residual(state, rate);
  const int T = problem.component("T");
  const double t = setup.scales.time;
  const KineticParameters& k = setup.solids.kinetic;
  double sum = 0, change = 0, magnitude = 0;
  each_cell(problem, [&](const Index& I) {  // in units of rho_s V^2
    const double volume = problem.lattice().volume(I);
    const int a = problem.at(0, I), b = problem.at(T, I);
    sum += volume / t * (residual[b] + 1.5 * state[b] * residual[a]);
    magnitude += volume / t * std::abs(residual[b]);
    change += volume * 1.5 * (state[a] * rate[b] + rate[a] * state[b]);
    if (gas() == GasModel::none) return;
    const double beta = drag_coefficient(state[a], 0.0, k.d, setup.solids.gas);
    change += volume * 3 * beta * state[b] / k.rho_s;
  });
  EXPECT_NEAR(sum, change, 1e-12 * magnitude);
}

std::string name_of_instance(const testing::TestParamInfo<Conservation::ParamType>& instance) {
  const auto [dim, advection, gas] = instance.param;
  return std::to_string(dim) + (advection == AdvectionScheme::upwind ? "d_upwind" : "d_van_albada") +
         (gas == GasModel::none    ? ""
          : gas == GasModel::darcy ? "_darcy"
                                   : "_incompressible");
}
template <class... Gas>
auto models(Gas... gas) {
  return testing::Combine(testing::Values(1, 2, 3),
                          testing::Values(AdvectionScheme::upwind, AdvectionScheme::van_albada),
                          testing::Values(gas...));
}
INSTANTIATE_TEST_SUITE_P(Models, Conservation, models(GasModel::none, GasModel::darcy, GasModel::incompressible),
                         name_of_instance);
INSTANTIATE_TEST_SUITE_P(Models, GasConservation, models(GasModel::darcy, GasModel::incompressible), name_of_instance);

}  // namespace
}  // namespace scree::test
