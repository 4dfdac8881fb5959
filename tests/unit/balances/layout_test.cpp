/// The places of unknowns in a node, and what the traits say of each.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "scree/balances/present.hpp"

namespace scree {
namespace {

struct Tracer {
  static double scale(const Scales&) { return 2; }
  static double row_scale(const Scales& s, double) { return s.time; }
  static constexpr Unknown unknown{
      "tracer", "c", "1", "a tracer", Place::cell, scale, row_scale, ErrorNorm::with_particles, unbounded, {}, {}};
};

TEST(Layout, UnknownsStandInTheOrderOfTheirBalances) {
  using Full = Layout<3, true, true, GasModel::incompressible>;
  EXPECT_EQ(Full::nu, 0);
  EXPECT_EQ(Full::v(2), 3);
  EXPECT_EQ(Full::u(0), 4);
  EXPECT_EQ(Full::p, 7);
  EXPECT_EQ(Full::T, 8);
  EXPECT_EQ(Full::chi, 9);
  EXPECT_EQ(Full::count, 10);
}

TEST(Layout, AbsentUnknownsHaveNoPlace) {
  using Small = Layout<2, false, true, GasModel::darcy>;
  EXPECT_EQ(Small::u(1), -1);
  EXPECT_EQ(Small::T, -1);
  EXPECT_EQ(Small::p, 3);
  EXPECT_EQ(Small::chi, 4);
  EXPECT_EQ(Small::count, 5);
  EXPECT_FALSE(Small::is_u(-1));
  EXPECT_FALSE(Small::is_u(2));
}

TEST(Layout, VelocitiesKnowTheirAxis) {
  using Full = Layout<2, true, true, GasModel::incompressible>;
  for (int axis = 0; axis < 2; ++axis) {
    EXPECT_TRUE(Full::is_v(Full::v(axis)));
    EXPECT_TRUE(Full::is_u(Full::u(axis)));
    EXPECT_TRUE(Full::is_velocity(Full::u(axis)));
    EXPECT_EQ(Full::axis_of(Full::v(axis)), axis);
    EXPECT_EQ(Full::axis_of(Full::u(axis)), axis);
  }
  for (const int scalar : {Full::nu, Full::p, Full::T, Full::chi}) EXPECT_FALSE(Full::is_velocity(scalar));
}

TEST(Layout, TheCoreStandsAtTheSamePlacesInAllLayouts) {
  using Full = Layout<2, true, true, GasModel::incompressible, Tracer>;
  EXPECT_EQ(Full::Core::p, Full::p);
  EXPECT_EQ(Full::Core::u(1), Full::u(1));
  EXPECT_EQ(Full::Core::count, 6);
}

TEST(Layout, FurtherScalarsComeLast) {
  using With = Layout<2, true, false, GasModel::none, Tracer>;
  EXPECT_EQ(With::first<Tracer>(), 4);
  const std::vector<Field> fields = With::fields(Scales());
  ASSERT_EQ(fields.size(), 5u);
  EXPECT_EQ(fields[4].dataset, "tracer");
  EXPECT_EQ(fields[4].scale, 2);
  EXPECT_TRUE(fields[4].is<Tracer>());
  EXPECT_FALSE(fields[4].is<GranularEnergy>());
}

TEST(Layout, FluidityIsAbsentUnlessListed) {
  using With = Layout<2, true, true, GasModel::none, Fluidity>;
  EXPECT_TRUE(With::has_g_f);
  EXPECT_EQ(With::g_f, 5);
  EXPECT_EQ(With::count, 6);
  using Without = Layout<2, true, true, GasModel::none>;
  EXPECT_FALSE(Without::has_g_f);
  EXPECT_EQ(Without::g_f, -1);
  EXPECT_EQ(Without::count, 5);
}

TEST(Layout, FieldsAreThoseOfTheTraits) {
  const Scales scales{0.5, 0.05, 2000};
  const std::vector<Field> fields = Layout<2, true, true, GasModel::incompressible>::fields(scales);
  ASSERT_EQ(fields.size(), 8u);
  for (std::size_t k = 0; k < fields.size(); ++k) EXPECT_EQ(fields[k].component, static_cast<int>(k));
  EXPECT_EQ(column_name(fields[2]), "velocity_y");
  EXPECT_EQ(fields[5].symbol, "p_g");
  EXPECT_EQ(fields[5].scale, 2000 * 0.25);
  EXPECT_EQ(fields[6].scale, 0.25);
  EXPECT_EQ(fields[6].face_axis, -1);
}

TEST(Unknowns, PresentOnesAreThoseOfTheLayout) {
  ModelParameters model;
  SolidsParameters solids;
  const auto names = [&] {
    std::string all;
    for (const Unknown* unknown : present_unknowns(model, solids)) all += std::string(unknown->symbol) + " ";
    return all;
  };
  EXPECT_EQ(names(), "nu v T chi ");
  solids.gas.model = GasModel::incompressible;
  EXPECT_EQ(names(), "nu v u p_g T chi ");
  solids.gas.model = GasModel::darcy;
  model.temperature = TemperatureModel::algebraic;
  solids.friction.model = FrictionModel::critical_state;
  EXPECT_EQ(names(), "nu v p_g ");
  solids.gas.model = GasModel::none;
  solids.friction.model = FrictionModel::relaxed;
  solids.friction.coefficient = FrictionCoefficient::fluidity;
  EXPECT_EQ(names(), "nu v chi g_f ");
}

TEST(Unknowns, HaveNamesOfTheirOwn) {
  std::set<std::string> datasets, symbols;
  for (const Unknown* unknown : standard_unknowns) {
    EXPECT_TRUE(datasets.insert(unknown->dataset).second) << unknown->dataset;
    EXPECT_TRUE(symbols.insert(unknown->symbol).second) << unknown->symbol;
  }
}

TEST(Unknowns, BoundsOfNewtonsMethod) {
  const NewtonContext iterate{0.65, 1.1, false}, guess{0.65, 1.1, true};
  EXPECT_EQ(SolidsContinuity::unknown.bounds(0.55, iterate).lower, 0);
  EXPECT_DOUBLE_EQ(SolidsContinuity::unknown.bounds(0.55, iterate).upper, 0.62);
  EXPECT_DOUBLE_EQ(GranularEnergy::unknown.bounds(4, iterate).lower, 0.04);
  EXPECT_DOUBLE_EQ(GranularEnergy::unknown.bounds(4, guess).lower, 2);
  EXPECT_DOUBLE_EQ(FrictionRelaxation::unknown.bounds(0.9, iterate).lower, 0.09);
  EXPECT_DOUBLE_EQ(FrictionRelaxation::unknown.bounds(0.9, iterate).upper, 1.1);
  EXPECT_DOUBLE_EQ(Fluidity::unknown.bounds(20, iterate).lower, 2);
  EXPECT_GT(Fluidity::unknown.bounds(20, iterate).upper, 1e300);
  EXPECT_LT(SolidsMomentum::unknown.bounds(0, iterate).lower, -1e300);
}

}  // namespace
}  // namespace scree
