/// The assembled Jacobian against differences of the residual, for every model combination and boundary kind, and the
/// same on any number of ranks. States are random but fixed: both signs of velocity and of div v, slip at walls, inflow
/// and outflow at open sides occur in each.
#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "differences.hpp"
#include "scenes.hpp"

namespace scree::test {
namespace {

/// A state, its rate and a width for difference steps of each unknown, all in stored units.
struct Sample {
  Values state, rate, width;
};

Sample sample(const Evaluation& problem, Regime regime, int seed) {
  Sample result;
  result.state = problem.values([&](const Field& f, const Index& I) { return random_value(f, I, regime, seed); });
  result.width =
      problem.values([&](const Field& f, const Index& I) { return random_scale(f, random_value(f, I, regime, seed)); });
  result.rate = problem.values([&](const Field& f, const Index& I) {
    return 30 * random_scale(f, random_value(f, I, regime, seed)) * noise(I, f.component, seed + 1000);
  });
  return result;
}

/// "velocity_x (3, 2, 0)" of a natural number.
std::string unknown_name(const Evaluation& problem, int natural) {
  const int node = natural / problem.unknowns();
  const Index& n = problem.nodes();
  std::ostringstream text;
  text << column_name(problem.fields()[static_cast<std::size_t>(natural % problem.unknowns())]) << " (" << node % n[0]
       << ", " << node / n[0] % n[1] << ", " << node / (n[0] * n[1]) << ')';
  return text.str();
}

/// Relative tolerance of a derivative: steps and extrapolation leave 1e-8 where the residual is smooth. To this the
/// differences' own estimate of their error and their rounding are added: terms of a row may be 1e4 times its weakest
/// block, and they cancel to 1e-16 of themselves over the narrowest step, 4e-6 widths.
constexpr double relative = 1e-6;
/// Differences whose error is below this part of the tolerance need not become better.
constexpr double negligible = .03;

/// Rounding of the differences in each row: its terms are about as large as the row is and as they change over a width;
/// in rows of chi, where chi* is subtracted from it, as large as what chi itself adds.
Values rounding_of(Evaluation& problem, const Sample& s) {
  Values terms = problem.zeros();
  const int chi = problem.component("chi");
  problem.each_entry([&](int row, int column, double entry) {
    const bool whole = row == column && column % problem.unknowns() == chi;
    terms[row] += std::abs(entry * (whole ? s.state[column] : s.width[column]));
  });
  problem.sum_over_ranks(terms);
  const Values residual = problem.residual(s.state, s.rate);
  for (std::size_t i = 0; i < terms.size(); ++i) terms[i] = 5e-11 * (terms[i] + std::abs(residual[i]));
  return terms;
}

/// d F_row/d(unknowns of one component) along a direction, to compare with differences.
struct BlockCheck {
  Evaluation& problem;
  const Values& product;    ///< J times direction
  const Values& magnitude;  ///< sum of |J_ij| |direction_j|: what may cancel in it
  const Values& rounding;
  const Differences& expected;
  std::string column;

  void run() const {
    const int unknowns = problem.unknowns();
    std::vector<double> block(static_cast<std::size_t>(unknowns), 0.0);
    for (int row = 0; row < problem.size(); ++row)
      block[row % unknowns] = std::max(block[row % unknowns], magnitude[row]);
    int failures = 0;
    for (int row = 0; row < problem.size() && failures < 3; ++row) {
      const double tolerance = relative * magnitude[row] + 3 * expected.error[row] + rounding[row];
      const double difference = std::abs(product[row] - expected.slope[row]);
      const bool trusted = expected.error[row] <= 1e-4 * block[row % unknowns] + 1e-9;
      if (difference <= tolerance && trusted) continue;
      ++failures;
      ADD_FAILURE() << "row " << unknown_name(problem, row) << ", along " << column << ": Jacobian " << product[row]
                    << ", differences " << expected.slope[row] << " +- " << expected.error[row] << ", tolerance "
                    << tolerance << (trusted ? "" : ": differences are not to be trusted, a kink is near");
    }
  }
};

/// Compares J times random directions, one component of the unknowns after the other, with differences.
void check_blocks(Evaluation& problem, const Sample& s, double shift, int seed) {
  problem.assemble(s.state, s.rate, shift);
  const Values rounding = rounding_of(problem, s);
  for (const Field& field : problem.fields()) {
    Values direction = problem.zeros(), rate_direction = direction, magnitude = direction;
    for (int i = field.component; i < problem.size(); i += problem.unknowns()) {
      direction[i] = s.width[i] * noise(Index{{i, 0, 0}}, 0, seed + 7);
      rate_direction[i] = shift * direction[i];
    }
    problem.each_entry(
        [&](int row, int column, double entry) { magnitude[row] += std::abs(entry * direction[column]); });
    problem.sum_over_ranks(magnitude);
    Values enough = problem.zeros();
    for (std::size_t i = 0; i < enough.size(); ++i)
      enough[i] = std::min(negligible * (relative * magnitude[i] + rounding[i]), 1e-4 * magnitude[i] + 1e-9);
    BlockCheck{problem,
               problem.product(direction),
               magnitude,
               rounding,
               differences(problem, s.state, s.rate, direction, rate_direction, enough),
               column_name(field)}
        .run();
  }
}

/// Compares residual, entries and pattern of the rows of this rank with those of the same problem on one rank.
void check_ranks(Evaluation& problem, Evaluation& alone, const Sample& s, double shift) {
  const Values there = problem.residual(s.state, s.rate), here = alone.residual(s.state, s.rate);
  double scale = 0;
  for (const double f : here) scale = std::max(scale, std::abs(f));
  for (std::size_t i = 0; i < here.size(); ++i)
    ASSERT_NEAR(there[i], here[i], 1e-14 * scale)
        << "residual of " << unknown_name(alone, static_cast<int>(i)) << " depends on the number of ranks";

  alone.assemble(s.state, s.rate, shift);
  std::vector<std::map<int, double>> rows(here.size());
  alone.each_entry([&](int row, int column, double entry) { rows[row][column] = entry; });
  problem.each_entry([&](int row, int column, double entry) {
    const auto found = rows[row].find(column);
    ASSERT_NE(found, rows[row].end()) << "row " << unknown_name(alone, row) << ", column "
                                      << unknown_name(alone, column) << " has no place on one rank";
    EXPECT_NEAR(entry, found->second, 1e-13 * std::abs(found->second) + 1e-13)
        << "row " << unknown_name(alone, row) << ", column " << unknown_name(alone, column)
        << " depends on the number of ranks";
    rows[row].erase(found);
  });
  PetscInt first, end;
  AO order;
  check(MatGetOwnershipRange(problem.problem().matrix(), &first, &end));
  check(DMDAGetAO(problem.problem().dm(), &order));
  for (PetscInt row = first; row < end; ++row) {
    PetscInt natural = row;
    check(AOPetscToApplication(order, 1, &natural));
    EXPECT_TRUE(rows[natural].empty()) << "row " << unknown_name(alone, natural) << " lacks " << rows[natural].size()
                                       << " entries that it has on one rank";
  }
}

/// Compares every entry with differences, one unknown after the other; rows outside of the pattern must not change in
/// the last bit.
void check_entries(Evaluation& problem, const Sample& s, double shift) {
  problem.assemble(s.state, s.rate, shift);
  const int size = problem.size();
  std::vector<std::map<int, double>> columns(static_cast<std::size_t>(size));
  const Values rounding = rounding_of(problem, s);
  Values row_scale = problem.zeros();
  const bool with_pressure = problem.component("p_g") >= 0;
  problem.each_entry([&](int row, int column, double entry) {
    if (with_pressure && row == column && row % problem.unknowns() == problem.component("p_g")) entry -= pressure_hold;
    columns[column][row] = entry * s.width[column];
    row_scale[row] = std::max(row_scale[row], std::abs(entry * s.width[column]));
  });
  int failures = 0;
  for (int column = 0; column < size && failures < 5; ++column) {
    Values direction = problem.zeros(), rate_direction = direction;
    direction[column] = s.width[column];
    rate_direction[column] = shift * direction[column];
    Values enough = problem.zeros();
    for (const auto& [row, entry] : columns[column])
      enough[row] = std::min(negligible * (relative * std::abs(entry) + rounding[row]), 1e-5 * row_scale[row] + 1e-9);
    const Differences expected = differences(problem, s.state, s.rate, direction, rate_direction, enough);
    for (int row = 0; row < size; ++row) {
      const auto found = columns[column].find(row);
      const double entry = found != columns[column].end() ? found->second : 0;
      const bool in_pattern = found != columns[column].end();
      const double tolerance = in_pattern ? relative * std::abs(entry) + 3 * expected.error[row] + rounding[row] : 0;
      const bool trusted = expected.error[row] <= 1e-5 * row_scale[row] + 1e-9;
      if (std::abs(entry - expected.slope[row]) <= tolerance && trusted) continue;
      ++failures;
      ADD_FAILURE() << "row " << unknown_name(problem, row) << ", column " << unknown_name(problem, column) << ": "
                    << (in_pattern ? "Jacobian " : "outside of the pattern ") << entry << ", differences "
                    << expected.slope[row] << " +- " << expected.error[row] << ", tolerance " << tolerance
                    << ", largest entry of the row " << row_scale[row];
    }
  }
}

class Jacobian : public testing::TestWithParam<Combination> {};

TEST_P(Jacobian, BlocksMatchDifferencesForEveryBoundaryKind) {
  for (const NamedScene& scene : scenes_for(GetParam())) {
    Evaluation problem(PETSC_COMM_WORLD, scene.setup);
    for (int seed = 1; seed <= (GetParam().dim == 3 || GetParam().gas != GasModel::none ? 1 : 2); ++seed) {
      SCOPED_TRACE(scene.name + ", state " + std::to_string(seed));
      check_blocks(problem, sample(problem, Regime::dense, seed), 30.0, seed);
    }
  }
}

TEST_P(Jacobian, BlocksMatchDifferencesInDiluteAndEmptyRegions) {
  for (const NamedScene& scene : mixed_scenes(sample_setup(GetParam()))) {
    Evaluation problem(PETSC_COMM_WORLD, scene.setup);
    for (const auto& [name, regime] : {std::pair("dilute", Regime::dilute), std::pair("empty", Regime::empty)}) {
      SCOPED_TRACE(scene.name + ", " + name);
      check_blocks(problem, sample(problem, regime, 3), 30.0, 3);
    }
    if (GetParam().dim == 3) break;  // it has each kind of boundary
  }
}

/// Free surfaces on every side of every axis, under gravity; every second of them closes.
TEST_P(Jacobian, BlocksMatchDifferencesAtSurfaces) {
  ProblemSetup base = sample_setup(GetParam());
  base.model.gravity = {-5.0, 9.81, -0.5};
  std::vector<NamedScene> scenes = scenes_of_mixed_kinds(base);
  scenes.push_back({"open", base});
  scenes.back().setup.segments = all_sides(base.box, sample_opening());
  for (const NamedScene& scene : scenes) {
    Evaluation problem(PETSC_COMM_WORLD, scene.setup);
    SCOPED_TRACE(scene.name);
    check_blocks(problem, sample(problem, Regime::surface, 11), 30.0, 11);
  }
}

/// At nu = 0 itself the residual has a kink where v < 0 (a mass flux of zero counts as positive): no differences there.
TEST_P(Jacobian, IsFiniteWithoutParticlesTemperatureOrMotion) {
  for (const NamedScene& scene : mixed_scenes(sample_setup(GetParam()))) {
    Evaluation problem(PETSC_COMM_WORLD, scene.setup);
    for (const double nu : {0.0, 0.5, 0.6}) {
      const Values state = problem.values([&](const Field& f, const Index&) { return f.symbol == "nu" ? nu : 0.0; });
      problem.assemble(state, problem.zeros(), 30.0);
      problem.each_entry([&, name = scene.name](int row, int column, double entry) {
        EXPECT_TRUE(std::isfinite(entry)) << name << ", nu = " << nu << ": row " << unknown_name(problem, row)
                                          << ", column " << unknown_name(problem, column) << ": " << entry;
      });
    }
  }
}

TEST_P(Jacobian, SameOnAnyNumberOfRanks) {
  std::vector<NamedScene> scenes = mixed_scenes(sample_setup(GetParam()));
  for (NamedScene& scene : periodic_scenes(sample_setup(GetParam()))) scenes.push_back(std::move(scene));
  for (const NamedScene& scene : scenes) {
    SCOPED_TRACE(scene.name);
    Evaluation problem(PETSC_COMM_WORLD, scene.setup), alone(PETSC_COMM_SELF, scene.setup);
    const Sample s = sample(problem, Regime::dense, 4);
    problem.assemble(s.state, s.rate, 30.0);
    check_ranks(problem, alone, s, 30.0);
  }
}

/// dF/d(dU/dt): the residual is linear in the rates, and the shift multiplies that part alone.
TEST_P(Jacobian, ShiftMultipliesTheDerivativeWithRespectToRates) {
  Evaluation problem(PETSC_COMM_WORLD, mixed_scenes(sample_setup(GetParam()))[0].setup);
  const Sample s = sample(problem, Regime::dense, 5);
  const Values direction =
      problem.values([](const Field& f, const Index& I) { return f.scale * noise(I, f.component, 6); });
  problem.assemble(s.state, s.rate, 0.0);
  const Values without = problem.product(direction);
  problem.assemble(s.state, s.rate, 50.0);
  const Values with = problem.product(direction);
  Values rate = s.rate;
  for (std::size_t i = 0; i < rate.size(); ++i) rate[i] += 50.0 * direction[i];
  const Values before = problem.residual(s.state, s.rate), after = problem.residual(s.state, rate);
  bool depends = false;
  for (std::size_t i = 0; i < rate.size(); ++i) {
    const double rounding =
        1e-12 * (std::abs(with[i]) + std::abs(without[i]) + std::abs(before[i]) + std::abs(after[i]));
    EXPECT_NEAR(with[i] - without[i], after[i] - before[i], rounding) << unknown_name(problem, static_cast<int>(i));
    depends = depends || std::abs(after[i] - before[i]) > 1e-3;
  }
  EXPECT_TRUE(depends) << "no row depends on the rates";
}

TEST(JacobianOfClosures, BlocksMatchDifferences) {
  for (const GasModel gas : {GasModel::none, GasModel::darcy, GasModel::incompressible})
    for (const TemperatureModel temperature : {TemperatureModel::transport, TemperatureModel::algebraic}) {
      const Combination c{2, FrictionModel::relaxed, temperature, AdvectionScheme::upwind, gas};
      for (const NamedScene& scene : scenes_of_closures(sample_setup(c))) {
        Evaluation problem(PETSC_COMM_WORLD, scene.setup);
        for (const auto& [name, regime] : {std::pair("dense", Regime::dense), std::pair("dilute", Regime::dilute)}) {
          SCOPED_TRACE(name_of(c) + ", " + scene.name + ", " + name);
          check_blocks(problem, sample(problem, regime, 2), 30.0, 2);
        }
      }
    }
}

TEST(JacobianOfClosures, BlocksMatchDifferencesAtTheCriticalState) {
  for (const TemperatureModel temperature : {TemperatureModel::transport, TemperatureModel::constant}) {
    const Combination c{2, FrictionModel::critical_state, temperature, AdvectionScheme::upwind};
    for (const NamedScene& scene : scenes_of_inertial_friction(sample_setup(c))) {
      SCOPED_TRACE(name_of(c) + ", " + scene.name);
      Evaluation problem(PETSC_COMM_WORLD, scene.setup);
      check_blocks(problem, sample(problem, Regime::dense, 2), 30.0, 2);
    }
  }
}

/// The layouts that have a balance of fluidity.
std::vector<Combination> with_fluidity() {
  std::vector<Combination> chosen;
  for (const TemperatureModel temperature : {TemperatureModel::transport, TemperatureModel::constant})
    for (const AdvectionScheme advection : {AdvectionScheme::upwind, AdvectionScheme::van_albada})
      chosen.push_back({2, FrictionModel::relaxed, temperature, advection, GasModel::none});
  return chosen;
}

TEST(JacobianOfFluidity, BlocksMatchDifferences) {
  for (const Combination& c : with_fluidity())
    for (const NamedScene& scene : scenes_of_fluidity(sample_setup(c))) {
      Evaluation problem(PETSC_COMM_WORLD, scene.setup);
      for (const auto& [name, regime] : {std::pair("dense", Regime::dense), std::pair("dilute", Regime::dilute),
                                         std::pair("surface", Regime::surface)}) {
        SCOPED_TRACE(name_of(c) + ", " + scene.name + ", " + name);
        check_blocks(problem, sample(problem, regime, 6), 30.0, 6);
      }
    }
}

/// Entry by entry, and nothing outside of the pattern.
TEST(JacobianOfFluidity, EntriesMatchDifferences) {
  for (const NamedScene& scene : scenes_of_fluidity(sample_setup(with_fluidity()[1]))) {
    SCOPED_TRACE(scene.name);
    Evaluation problem(PETSC_COMM_SELF, scene.setup);
    check_entries(problem, sample(problem, Regime::dense, 8), 30.0);
  }
}

TEST(JacobianOfFluidity, SameOnAnyNumberOfRanks) {
  for (const NamedScene& scene : scenes_of_fluidity(sample_setup(with_fluidity()[1]))) {
    SCOPED_TRACE(scene.name);
    Evaluation problem(PETSC_COMM_WORLD, scene.setup), alone(PETSC_COMM_SELF, scene.setup);
    const Sample s = sample(problem, Regime::dense, 4);
    problem.assemble(s.state, s.rate, 30.0);
    check_ranks(problem, alone, s, 30.0);
  }
}

INSTANTIATE_TEST_SUITE_P(Models, Jacobian, testing::ValuesIn(combinations()),
                         [](const auto& instance) { return name_of(instance.param); });

/// Entry by entry, where that is cheap: each rank for itself.
class JacobianEntries : public testing::TestWithParam<Combination> {};

TEST_P(JacobianEntries, MatchDifferencesAndNothingLiesOutsideOfThePattern) {
  const Combination& c = GetParam();
  ProblemSetup base = sample_setup(c);
  if (c.dim == 3) base.box = graded_box(3, {3, 3, 3});
  for (const NamedScene& scene : mixed_scenes(base)) {
    SCOPED_TRACE(scene.name);
    Evaluation problem(PETSC_COMM_SELF, scene.setup);
    check_entries(problem, sample(problem, Regime::dense, 8), 30.0);
    if (c.dim == 3) break;
  }
}

/// All layouts, where that is cheap.
std::vector<Combination> cheap_combinations() {
  std::vector<Combination> chosen;
  for (const Combination& c : combinations()) {
    const bool largest = c.friction == FrictionModel::relaxed && c.temperature == TemperatureModel::transport;
    const bool cheap =
        c.dim == 1 || (c.dim == 2 && (c.gas == GasModel::none || c.advection == AdvectionScheme::upwind));
    if (largest || cheap) chosen.push_back(c);
  }
  return chosen;
}

INSTANTIATE_TEST_SUITE_P(Models, JacobianEntries, testing::ValuesIn(cheap_combinations()),
                         [](const auto& instance) { return name_of(instance.param); });

/// The smallest periodic grid: a cell is its own neighbour's neighbour, and entries fall on each other.
TEST(JacobianEntries, AddUpWhereAPeriodicAxisIsShort) {
  for (const auto advection : {AdvectionScheme::upwind, AdvectionScheme::van_albada}) {
    Box box = uniform_box(2, {3, 3, 0});
    box.periodic = {true, true, false};
    SCOPED_TRACE(advection == AdvectionScheme::upwind ? "upwind" : "van_albada");
    Evaluation problem(PETSC_COMM_SELF,
                       sample_setup(box, FrictionModel::relaxed, TemperatureModel::transport, advection));
    check_entries(problem, sample(problem, Regime::dense, 9), 30.0);
  }
}

}  // namespace
}  // namespace scree::test
