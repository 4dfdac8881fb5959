/// The projection of u: what is left of div(nu v + (1-nu) u), and what it leaves alone.
#include "scree/stepping/gas_projection.hpp"

#include <gtest/gtest.h>

#include "../../jacobian/scenes.hpp"
#include "scree/stepping/corrections.hpp"

namespace scree::test {
namespace {

Values projected(const Evaluation& problem, const DiscreteProblem& discrete, const Values& state) {
  Vec x;
  check(DMCreateGlobalVector(discrete.dm(), &x));
  problem.put(state, x);
  check(project_gas(discrete, problem.time(), x));
  Values result = problem.get(x);
  check(VecDestroy(&x));
  return result;
}
Values projected(Evaluation& problem, const Values& state) { return projected(problem, problem.problem(), state); }

Values random_state(const Evaluation& problem, Regime regime, int seed) {
  return problem.values([&](const Field& f, const Index& I) {
    return f.symbol == "p_g" ? 0.0 : random_value(f, I, regime, seed);  // nothing holds its level in (2)
  });
}

/// Greatest volume that leaves a cell in unit time, and the greatest flow through a face [m^dim/s].
struct Flows {
  double imbalance = 0, greatest = 0;
};
Flows flows(Evaluation& problem, const Values& state) {
  const Lattice& grid = problem.lattice();
  const ProblemSetup& setup = problem.problem().setup();
  const Values residual = problem.residual(state, problem.zeros());
  const int p = problem.component("p_g"), first_u = problem.component("u");
  const double V = setup.scales.velocity;
  Flows result;
  for_each_node(Index{}, problem.nodes(), [&](const Index& I) {
    if (!grid.inside(I)) return;
    const double volume = grid.volume(I);
    result.imbalance = std::max(result.imbalance, volume * std::abs(residual[problem.at(p, I)]) / setup.scales.time);
    for (int axis = 0; axis < grid.dim; ++axis)
      for (const int component : {1 + axis, first_u + axis})
        result.greatest = std::max(
            result.greatest, volume / grid.axes[axis].width(I[axis]) * V * std::abs(state[problem.at(component, I)]));
  });
  return result;
}

/// The scenes in which gas can make room: some side is open, or all are closed to it. Plates across three axes make
/// chambers: there inlets are opened.
std::vector<NamedScene> solvable(std::vector<NamedScene> scenes) {
  std::vector<NamedScene> result;
  for (NamedScene& scene : scenes) {
    bool open = false, closed = true;
    for (Segment& segment : scene.setup.segments) {
      BoundaryKind& kind = segment.condition.kind;
      if (scene.setup.plates.size() == 3 && kind.brings_gas()) kind = BoundaryKind::open;
      open = open || kind == BoundaryKind::open;
      closed = closed && kind.stops_gas();
    }
    if (open || closed) result.push_back(std::move(scene));
  }
  return result;
}

class Projection : public testing::TestWithParam<Combination> {};

TEST_P(Projection, BalancesVolumeToRoundingFromAnyState) {
  int count = 0;
  for (const NamedScene& scene : solvable(all_scenes(sample_setup(GetParam())))) {
    Evaluation problem(PETSC_COMM_WORLD, scene.setup);
    for (const auto regime : {Regime::dense, Regime::dilute}) {
      SCOPED_TRACE(scene.name + (regime == Regime::dense ? ", dense" : ", dilute"));
      const Values state = random_state(problem, regime, 1);
      const Values result = projected(problem, state);
      const Flows before = flows(problem, state), after = flows(problem, result);
      EXPECT_GT(before.imbalance, 0.1 * before.greatest);
      EXPECT_LT(after.imbalance, 1e-14 * after.greatest);
      ++count;
    }
  }
  EXPECT_GT(count, 20);
}

/// nu, v, T, chi, p_g and what sides and plates say of u.
TEST_P(Projection, ChangesNothingButTheFreeFluxes) {
  for (const NamedScene& scene : solvable(mixed_scenes(sample_setup(GetParam())))) {
    SCOPED_TRACE(scene.name);
    Evaluation problem(PETSC_COMM_WORLD, scene.setup);
    Evaluation alone(PETSC_COMM_SELF, scene.setup);
    const Values state = random_state(problem, Regime::dense, 2), result = projected(problem, state);
    const Barriers& barriers = alone.problem().barriers();
    for_each_node(Index{}, problem.nodes(), [&](const Index& I) {
      for (const Field& f : problem.fields()) {
        const int axis = f.face_axis, i = problem.at(f.component, I);
        const bool free = f.symbol == "u" && alone.lattice().is_face(axis, I) &&
                          (!barriers.at(axis, I) || barriers.condition(axis, I).kind == BoundaryKind::open);
        EXPECT_EQ(result[i] != state[i], free) << column_name(f) << " (" << I[0] << ", " << I[1] << ", " << I[2] << ')';
      }
    });
  }
}

/// The change of (1-nu) u is a gradient: it has no circulation about an edge, so that no smaller one would do.
TEST_P(Projection, IsTheLeastChange) {
  ProblemSetup setup = sample_setup(GetParam());
  setup.segments[0].condition = condition(BoundaryKind::open);
  Evaluation problem(PETSC_COMM_WORLD, setup);
  const Values state = random_state(problem, Regime::dense, 3), result = projected(problem, state);
  const Lattice& grid = problem.lattice();
  const int first_u = problem.component("u");
  double greatest = 0;
  const auto step = [&](int axis, const Index& I) {  // of the potential across a face
    const double share = grid.axes[axis].lower_share(I[axis]);
    const double nu = share * state[problem.at(0, I - unit(axis))] + (1 - share) * state[problem.at(0, I)];
    const int u = problem.at(first_u + axis, I);
    const double change = (1 - nu) * (result[u] - state[u]) * grid.axes[axis].distance(I[axis]);
    greatest = std::max(greatest, std::abs(change));
    return change;
  };
  for_each_node(Index{}, problem.nodes(), [&](const Index& I) {
    for (int a = 0; a < grid.dim; ++a)
      for (int b = 0; b < a; ++b) {
        if (I[a] < 1 || I[b] < 1 || !grid.inside(I)) continue;
        const double circulation = step(a, I) - step(a, I - unit(b)) - step(b, I) + step(b, I - unit(a));
        EXPECT_LT(std::abs(circulation), 1e-12 * greatest)
            << "about edge (" << I[0] << ", " << I[1] << ", " << I[2] << ')';
      }
  });
  EXPECT_TRUE(grid.dim == 1 || greatest > 0);
}

TEST_P(Projection, LeavesABalancedStateAsItIs) {
  for (const NamedScene& scene : solvable(all_scenes(sample_setup(GetParam())))) {
    SCOPED_TRACE(scene.name);
    ProblemSetup sealed = scene.setup;
    for (Segment& segment : sealed.segments) segment.condition.gas_velocity = 0;
    Evaluation still(PETSC_COMM_WORLD, sealed), problem(PETSC_COMM_WORLD, scene.setup);
    const Values rest = still.values(
        [](const Field& f, const Index& I) { return f.face_axis >= 0 ? 0.0 : random_value(f, I, Regime::dense, 4); });
    EXPECT_EQ(projected(still, rest), rest) << "at rest";
    const Values once = projected(problem, random_state(problem, Regime::dense, 4)), twice = projected(problem, once);
    for (std::size_t i = 0; i < once.size(); ++i)
      ASSERT_NEAR(twice[i], once[i], 1e-13) << "projected before, unknown " << i;
  }
}

std::vector<Combination> with_u() {
  std::vector<Combination> chosen;
  for (int dim = 1; dim <= 3; ++dim)
    for (const auto advection : {AdvectionScheme::upwind, AdvectionScheme::van_albada})
      chosen.push_back({dim, FrictionModel::relaxed, TemperatureModel::transport, advection, GasModel::incompressible});
  return chosen;
}
INSTANTIATE_TEST_SUITE_P(Models, Projection, testing::ValuesIn(with_u()),
                         [](const auto& instance) { return name_of(instance.param); });

void expect_balance_on_a_fine_grid(bool open) {
  ProblemSetup setup = sample_setup(uniform_box(2, {60, 100, 0}), FrictionModel::none, TemperatureModel::constant,
                                    AdvectionScheme::upwind, GasModel::incompressible);
  if (open) setup.segments[3] = side(1, true, condition(BoundaryKind::open));
  Evaluation problem(PETSC_COMM_WORLD, setup);
  const Values state = problem.values([&](const Field& f, const Index& I) {
    if (f.symbol == "nu") return 0.5 + 0.1 * noise(I, 0, 5);
    return f.symbol == "u" ? 0.3 * std::sin(0.05 * I[f.face_axis] + f.face_axis) : 0.0;
  });
  const Flows after = flows(problem, projected(problem, state));
  EXPECT_LT(after.imbalance, 1e-14 * after.greatest) << (open ? "open" : "closed") << " above";
}

/// On a fine grid too, where potentials are large.
TEST(FineProjection, BalancesVolumeToRounding) {
  for (const bool open : {false, true}) expect_balance_on_a_fine_grid(open);
}

/// What grids take that are too large for a factorisation.
TEST(FineProjection, BalancesVolumeToRoundingWithMultigrid) {
  check(PetscOptionsSetValue(nullptr, "-gas_projection_pc_type", "hypre"));
  for (const bool open : {false, true}) expect_balance_on_a_fine_grid(open);
  check(PetscOptionsClearValue(nullptr, "-gas_projection_pc_type"));
}

}  // namespace
}  // namespace scree::test
