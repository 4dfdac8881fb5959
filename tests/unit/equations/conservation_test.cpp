/// What the balances conserve for any state: solids, momentum, and the advected amounts of chi and T.
#include <gtest/gtest.h>

#include "../../jacobian/scenes.hpp"

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

class Conservation : public testing::TestWithParam<std::pair<int, AdvectionScheme>> {
 protected:
  ProblemSetup base() const {
    return sample_setup(
        Combination{GetParam().first, FrictionModel::relaxed, TemperatureModel::transport, GetParam().second});
  }
  /// Periodic in all axes, cells of equal size along none.
  ProblemSetup periodic() const {
    ProblemSetup setup = base();
    setup.box.periodic = {true, true, true};
    setup.segments.clear();
    setup.model.void_fraction_floor = 0;
    return setup;
  }
};

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
    for (const Segment& segment : scene.setup.segments) closed = closed && is_wall(segment.condition.kind);
    EXPECT_TRUE(!closed || outflow == 0) << "outflow " << outflow << " of a closed box";
  }
}

/// F = rho_s (nu Dv/Dt); with v times continuity it is the conservative form, whose fluxes and stresses cancel.
TEST_P(Conservation, MomentumOfAPeriodicBoxIsKept) {
  Evaluation problem(PETSC_COMM_WORLD, periodic());
  const Values state = random_state(problem, 3), rate = random_rate(problem, 4);
  const Values residual = problem.residual(state, rate);
  const ProblemSetup& setup = problem.problem().setup();
  const double rho_s = setup.solids.kinetic.rho_s, V = setup.scales.velocity, t = setup.scales.time;
  for (int axis = 0; axis < GetParam().first; ++axis) {
    const Axis& along = problem.lattice().axes[axis];
    const int v = 1 + axis;
    double sum = 0, change = 0, magnitude = 0;
    each_cell(problem, [&](const Index& I) {  // the lower faces of all cells are all faces
      const Index below = I - unit(axis);
      const double volume = problem.lattice().volume(I) / along.width(I[axis]) * along.distance(I[axis]);
      const double share = along.lower_share(I[axis]);
      const auto face = [&](const Values& q) {
        return share * q[problem.at(0, below)] + (1 - share) * q[problem.at(0, I)];
      };
      const double velocity = V * state[problem.at(v, I)], acceleration = V * rate[problem.at(v, I)];
      const double force = residual[problem.at(v, I)] * rho_s * V / t + rho_s * velocity * face(residual) / t;
      sum += volume * force;
      change += volume * rho_s * (face(state) * acceleration + face(rate) * velocity);
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

/// Rigid motion of elastic particles: no production, no dissipation; advection and conduction only move T about.
TEST_P(Conservation, FluctuationEnergyOfElasticParticlesInRigidMotionIsKept) {
  ProblemSetup setup = periodic();
  setup.solids.kinetic.e_p = 1;
  Evaluation problem(PETSC_COMM_WORLD, setup);
  const double wind[] = {0.04, -0.03, 0.02};
  const Values state = problem.values([&](const Field& f, const Index& I) {
    return f.symbol == "v" ? wind[f.face_axis] : random_value(f, I, Regime::dense, 7);
  });
  const Values rate = random_rate(problem, 8);
  const Values residual = problem.residual(state, rate);
  const int T = problem.component("T");
  const double t = setup.scales.time;
  double sum = 0, change = 0, magnitude = 0;
  each_cell(problem, [&](const Index& I) {  // in units of rho_s V^2
    const double volume = problem.lattice().volume(I);
    const int a = problem.at(0, I), b = problem.at(T, I);
    sum += volume / t * (residual[b] + 1.5 * state[b] * residual[a]);
    magnitude += volume / t * std::abs(residual[b]);
    change += volume * 1.5 * (state[a] * rate[b] + rate[a] * state[b]);
  });
  EXPECT_NEAR(sum, change, 1e-12 * magnitude);
}

INSTANTIATE_TEST_SUITE_P(
    DimensionsAndSchemes, Conservation,
    testing::Values(std::pair(1, AdvectionScheme::upwind), std::pair(1, AdvectionScheme::van_albada),
                    std::pair(2, AdvectionScheme::upwind), std::pair(2, AdvectionScheme::van_albada),
                    std::pair(3, AdvectionScheme::upwind), std::pair(3, AdvectionScheme::van_albada)),
    [](const auto& instance) {
      return std::to_string(instance.param.first) +
             (instance.param.second == AdvectionScheme::upwind ? "d_upwind" : "d_van_albada");
    });

}  // namespace
}  // namespace scree::test
