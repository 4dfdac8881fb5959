/// Order of accuracy in space, of all balances and boundary conditions (T19).
#include <gtest/gtest.h>

#include <cstdio>

#include "manufactured_problem.hpp"
#include "order_table.hpp"

namespace scree::test {
namespace {

constexpr double length = 0.02;  // of the box [m]

struct SpaceCase {
  std::string name;
  int dim = 2;
  AdvectionScheme scheme = AdvectionScheme::van_albada;
  GasModel gas = GasModel::none;
  FrictionModel friction = FrictionModel::relaxed;
  TemperatureModel temperature = TemperatureModel::transport;
  bool dilating = true;
  bool graded = false, viscous = false;
  bool tests_side = false, nu_varies_at_wall = false;
  BoundaryKind kind = BoundaryKind::symmetry;
};

void PrintTo(const SpaceCase& c, std::ostream* out) { *out << c.name; }

std::vector<double> faces(int cells, bool graded) {
  std::vector<double> x;
  for (int i = 0; i <= cells; ++i) {
    const double s = static_cast<double>(i) / cells;
    x.push_back(length * (graded ? s + .08 * std::sin(2 * pi * s) : s));  // cells of 1.5 to 0.5 of their mean
  }
  return x;
}

Condition tested_condition(const SpaceCase& c, const ExactFields& exact) {
  Condition result = condition(c.kind);
  if (c.kind == BoundaryKind::inlet) {
    const Point q = exact.at({0, 0, 0}, 0);
    for (int a = 0; a < c.dim; ++a) result.velocity[a] = q.v[a].value;
    result.bring(SolidsContinuity::unknown, q.nu.value);
    result.bring(GranularEnergy::unknown, q.T.value);
    result.bring(FrictionRelaxation::unknown, q.chi.value);
    result.gas_velocity = (1 - q.nu.value) * q.u[1].value;
  }
  if (c.kind == BoundaryKind::gas_inlet) result.gas_velocity = exact.gas_inflow;
  if (c.gas == GasModel::darcy && c.kind.brings_gas()) {
    const Point q = exact.at({0, 0, 0}, 0);
    const double gradient = q.p.first[1],
                 mobility = darcy_mobility(q.nu.value, gradient * gradient, ModelParameters().darcy_solids_fraction,
                                           SolidsParameters().kinetic.d, GasParameters());
    result.gas_velocity = (1 - q.nu.value) * (q.v[1].value - mobility * gradient);
  }
  if (c.kind == BoundaryKind::wall_no_slip) result.velocity[0] = exact.at({0, 0, 0}, 0).v[0].value;
  return result;
}

/// Makes exact fields obey (25) and (26): the gradients on the wall depend on each other through the viscosity.
void fit_to_wall(const ProblemSetup& setup, ExactFields& exact) {
  const WallParameters wall;
  for (int iteration = 0; iteration < 200; ++iteration) {
    const Point q = exact.at({0, 0, 0}, 0);
    const StrongForm form(q, exact.dim, setup.model, setup.solids);
    exact.shear_at_wall += 0.5 * (form.shear_of_wall_law(wall) - exact.shear_at_wall);
    exact.T_gradient_at_wall = form.T_gradient_of_wall_law(wall);
  }
}

ProblemSetup setup_of(const SpaceCase& c, const ExactFields& exact, int cells) {
  Box box;
  box.dim = c.dim;
  for (int axis = 0; axis < c.dim; ++axis) box.faces[axis] = faces(cells, c.graded);
  ProblemSetup setup = sample_setup(box, c.friction, c.temperature, c.scheme, c.gas);
  setup.model.gravity = {1, -9.81, .5};
  setup.model.gas_viscous_stress = c.viscous;
  setup.solids.friction.tau = 1e-2;  // what chi changes over is resolved on the coarsest grid
  setup.segments = all_sides(box, condition(BoundaryKind::open));
  if (c.tests_side) setup.segments.push_back(side(1, false, tested_condition(c, exact)));
  return setup;
}

/// 64 cells in the plane beside sides where the gas has inertia, for there all balances are, and with `instantaneous`
/// friction; the others show the same orders on half as many.
int finest(const SpaceCase& c) {
  const bool second_order = c.scheme == AdvectionScheme::van_albada;
  const bool whole = c.tests_side && c.gas == GasModel::incompressible && second_order;
  const bool half = c.dim == 2 && !whole && c.friction != FrictionModel::instantaneous;
  PetscInt cells = half ? 32 : 64;
  check(PetscOptionsGetInt(nullptr, nullptr, "-finest", &cells, nullptr));
  if (c.dim == 1) return static_cast<int>(4 * cells);
  return static_cast<int>(c.dim == 2 ? cells : cells / 2);
}

/// Orders to be reached, where grids end below 128 cells and from there on. Upwind is of first order. Beside walls with
/// shear the strain rate of the cells there is of first order, and T with it.
double least_order(const SpaceCase& c) {
  const bool fine = finest(c) >= 128;
  if (c.scheme == AdvectionScheme::upwind) return fine ? .95 : .8;
  const bool sheared = c.kind == BoundaryKind::wall_no_slip || c.kind == BoundaryKind::wall_johnson_jackson;
  if (c.tests_side) return sheared ? (fine ? 1.65 : 1.7) : 1.85;
  return fine ? 1.9 : 1.7;
}

class SpaceOrder : public testing::TestWithParam<SpaceCase> {};

TEST_P(SpaceOrder, EachUnknown) {
  const SpaceCase& c = GetParam();
  ExactFields exact;
  exact.dim = c.dim;
  exact.length = length;
  exact.dilating = c.dilating;
  exact.tests_side = c.tests_side;
  exact.kind = c.kind;
  exact.nu_varies_at_wall = c.nu_varies_at_wall;
  exact.darcy = c.gas == GasModel::darcy;

  if (c.tests_side && c.kind == BoundaryKind::wall_johnson_jackson) fit_to_wall(setup_of(c, exact, 16), exact);

  std::vector<int> grids;
  std::vector<std::map<std::string, FieldError>> errors;
  for (int cells = finest(c); cells >= 16 && grids.size() < 4; cells /= 2) grids.insert(grids.begin(), cells);
  for (const int cells : grids) {
    ManufacturedProblem problem(setup_of(c, exact, cells), exact, 3 * cells / 16);  // a band of one width
    EXPECT_LT(problem.solve(), 1e-8) << "Newton on " << cells << " cells";
    errors.push_back(problem.errors());
  }
  const double bound = least_order(c);
  for (const auto& [symbol, ignored] : errors.back()) {
    OrderRow row{c.name, symbol, {}, {}, bound, {}, "grids"};
    for (const int cells : grids) row.steps.push_back(cells);
    for (auto& error : errors) {
      row.mean.push_back(error[symbol].mean());
      row.greatest.push_back(error[symbol].greatest);
    }
    EXPECT_GE(OrderTable::add(row), bound) << c.name << ": " << symbol;
  }
}

std::vector<SpaceCase> space_cases() {
  const GasModel gases[] = {GasModel::none, GasModel::darcy, GasModel::incompressible};
  std::vector<SpaceCase> cases;
  const auto add = [&](const std::string& name, auto&& change) {
    SpaceCase c;
    change(c);
    c.name = std::to_string(c.dim) + "-D, " + name;
    if (c.scheme == AdvectionScheme::upwind) c.name += ", upwind";
    cases.push_back(c);
  };
  const std::pair<const char*, FrictionModel> frictions[] = {{"no friction", FrictionModel::none},
                                                             {"critical_state", FrictionModel::critical_state},
                                                             {"instantaneous", FrictionModel::instantaneous},
                                                             {"relaxed", FrictionModel::relaxed}};
  for (int g = 0; g < 3; ++g)
    for (const auto& [friction_name, friction] : frictions)
      for (const bool dilating : {true, false}) {
        const bool with_n = friction == FrictionModel::instantaneous || friction == FrictionModel::relaxed;
        if (!with_n && !dilating && g != 2) continue;
        add(gas_name(gases[g]) + ", " + friction_name + (dilating ? ", dilation" : ", compaction"),
            [&, f = friction](SpaceCase& c) {
              c.gas = gases[g];
              c.friction = f;
              c.dilating = dilating;
            });
      }
  for (int g = 0; g < 3; ++g) {
    const std::string gas = gas_name(gases[g]);
    for (const int dim : {1, 3})
      if (dim == 1 || gases[g] != GasModel::darcy)  // its own kernels are tried in the plane
        add(gas + ", relaxed, dilation", [&](SpaceCase& c) { c.dim = dim, c.gas = gases[g]; });
    for (const bool dilating : {true, false})
      add(gas + ", relaxed" + (dilating ? ", dilation" : ", compaction"), [&](SpaceCase& c) {
        c.gas = gases[g];
        c.dilating = dilating;
        c.scheme = AdvectionScheme::upwind;
      });
    add(gas + ", relaxed, algebraic T", [&](SpaceCase& c) {
      c.gas = gases[g];
      c.temperature = TemperatureModel::algebraic;
    });
    add(gas + ", relaxed, graded", [&](SpaceCase& c) { c.gas = gases[g], c.graded = true; });
  }
  add("incompressible, viscous gas, relaxed", [&](SpaceCase& c) { c.gas = gases[2], c.viscous = true; });
  const std::pair<const char*, BoundaryKind> kinds[] = {{"symmetry", BoundaryKind::symmetry},
                                                        {"wall_free_slip", BoundaryKind::wall_free_slip},
                                                        {"wall_no_slip", BoundaryKind::wall_no_slip},
                                                        {"wall_johnson_jackson", BoundaryKind::wall_johnson_jackson},
                                                        {"open", BoundaryKind::open},
                                                        {"inlet", BoundaryKind::inlet},
                                                        {"gas_inlet", BoundaryKind::gas_inlet}};
  for (int g = 0; g < 3; ++g)
    for (const auto& [kind_name, kind] : kinds) {
      if (kind == BoundaryKind::gas_inlet && g == 0) continue;
      for (const AdvectionScheme scheme : {AdvectionScheme::van_albada, AdvectionScheme::upwind}) {
        if (scheme == AdvectionScheme::upwind && g != 2) continue;
        add(gas_name(gases[g]) + ", side " + kind_name, [&, k = kind](SpaceCase& c) {
          c.gas = gases[g];
          c.tests_side = true;
          c.kind = k;
          c.scheme = scheme;
        });
      }
    }
  for (const AdvectionScheme scheme : {AdvectionScheme::van_albada, AdvectionScheme::upwind})
    add("no gas, side wall_johnson_jackson, nu varies", [&](SpaceCase& c) {
      c.tests_side = c.nu_varies_at_wall = true;
      c.kind = BoundaryKind::wall_johnson_jackson;
      c.scheme = scheme;
    });
  return cases;
}

std::string test_name(const testing::TestParamInfo<SpaceCase>& info) {
  std::string name;
  for (const char letter : info.param.name)
    if (std::isalnum(letter) || letter == '_')
      name += letter;
    else if (letter == ' ')
      name += '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(, SpaceOrder, testing::ValuesIn(space_cases()), test_name);

}  // namespace
}  // namespace scree::test
