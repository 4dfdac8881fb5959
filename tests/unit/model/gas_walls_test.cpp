/// Gas sticks to walls alone: what a plane of symmetry is asked to do beside changes nothing.
#include <gtest/gtest.h>

#include "../../support/sample_problem.hpp"

namespace scree::test {
namespace {

Values residual(const BoundaryKind& kind, bool no_slip) {
  ProblemSetup setup = sample_setup(graded_box(2, {4, 5, 1}), FrictionModel::relaxed, TemperatureModel::transport,
                                    AdvectionScheme::upwind, GasModel::incompressible);
  setup.model.gas_viscous_stress = true;
  Condition side = condition(kind);
  side.gas_no_slip = no_slip;
  setup.segments = all_sides(setup.box, side);
  Evaluation problem(PETSC_COMM_SELF, setup);
  return problem.residual(
      problem.values([](const Field& f, const Index& I) { return random_value(f, I, Regime::dense, 3); }),
      problem.zeros());
}

TEST(GasWalls, GasSticksToAWallThatAsksForIt) {
  EXPECT_NE(residual(BoundaryKind::wall_free_slip, true), residual(BoundaryKind::wall_free_slip, false));
}

TEST(GasWalls, GasSlipsAlongAPlaneOfSymmetry) {
  EXPECT_EQ(residual(BoundaryKind::symmetry, true), residual(BoundaryKind::symmetry, false));
}

}  // namespace
}  // namespace scree::test
