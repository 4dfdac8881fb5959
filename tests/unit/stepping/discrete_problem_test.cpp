#include <gtest/gtest.h>

#include "../../support/sample_problem.hpp"

namespace scree::test {
namespace {

TEST(DiscreteProblem, MeasuresVolumeAndFluxes) {
  ProblemSetup setup = sample_setup(graded_box(2, {6, 4, 0}), FrictionModel::critical_state);
  setup.segments[2] = side(1, false, condition(BoundaryKind::open));
  Evaluation problem(PETSC_COMM_WORLD, setup);
  const Box& box = setup.box;
  const auto width = [&](int i) { return box.faces[0][i + 1] - box.faces[0][i]; };
  Vec state;
  check(DMCreateGlobalVector(problem.problem().dm(), &state));
  // nu = 0.4 + 0.02 i, v_y = -0.1 (1 + i) m/s everywhere
  problem.put(problem.values([&](const Field& f, const Index& I) {
    if (f.symbol == "nu") return 0.4 + 0.02 * I[0];
    return f.face_axis == 1 ? -0.1 * (1 + I[0]) : 0.0;
  }),
              state);
  double volume, outflow, all, some, expected_volume = 0, flux = 0, part = 0;
  check(problem.problem().solids_volume(state, &volume));
  check(problem.problem().outflow(0, state, Phase::solids, &outflow));
  Patch patch;
  patch.lower[0] = box.faces[0][1];
  patch.upper[0] = box.faces[0][3];
  check(problem.problem().plane_flux(0, state, Phase::solids, 1, box.faces[1][2], Patch(), &all));
  check(problem.problem().plane_flux(0, state, Phase::solids, 1, box.faces[1][2] + 1e-5, patch, &some));
  for (int i = 0; i < 6; ++i) {
    const double nu = 0.4 + 0.02 * i, q = -0.1 * (1 + i) * nu * width(i);
    expected_volume += nu * width(i) * box.upper(1);
    flux += q;
    if (i == 1 || i == 2) part += q;
  }
  EXPECT_NEAR(volume, expected_volume, 1e-14 * volume);
  EXPECT_NEAR(outflow, -flux, 1e-14 * std::abs(flux)) << "out through the open bottom";
  EXPECT_NEAR(all, flux, 1e-14 * std::abs(flux)) << "along +y";
  EXPECT_NEAR(some, part, 1e-14 * std::abs(part)) << "faces nearest to the plane, centres in the patch";
  check(VecDestroy(&state));
}

TEST(DiscreteProblem, TimeWindowsTakeEffectWhenConditionsAreUpdated) {
  ProblemSetup setup = sample_setup(uniform_box(1, {8, 0, 0}), FrictionModel::critical_state);
  Condition gate = condition(BoundaryKind::wall_free_slip);
  gate.until = 1;
  setup.segments = {side(0, false, condition(BoundaryKind::open)), side(0, false, gate),
                    side(0, true, condition(BoundaryKind::symmetry))};
  Evaluation problem(PETSC_COMM_WORLD, setup, 0);
  const Values state = problem.values([](const Field& f, const Index&) {
    return f.symbol == "nu" ? 0.5 : f.face_axis == 0 ? -0.2 : 0.0;
  });
  EXPECT_EQ(problem.outflow(state), 0) << "closed until 1 s";
  check(problem.problem().update_conditions(1.0));
  EXPECT_NEAR(problem.outflow(state), 0.1, 1e-15) << "open from 1 s";
}

}  // namespace
}  // namespace scree::test
