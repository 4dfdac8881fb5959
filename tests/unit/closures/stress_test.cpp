#include "scree/closures/stress.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "derivative_check.hpp"

namespace scree {
namespace {

const std::vector<FrictionModel> friction_models = {FrictionModel::none, FrictionModel::critical_state,
                                                    FrictionModel::instantaneous, FrictionModel::relaxed};
const std::vector<TemperatureModel> temperature_models = {TemperatureModel::transport, TemperatureModel::algebraic,
                                                          TemperatureModel::constant};

SolidsParameters with_models(FrictionModel friction, TemperatureModel temperature = TemperatureModel::transport) {
  SolidsParameters p;
  p.friction.model = friction;
  p.temperature = temperature;
  return p;
}

/// src/MODEL.md (1.1), (1.4), (14), (18), (20), (21) evaluated apart with 40 digits (mpmath), without floors.
struct CellRow {
  FrictionModel model;
  double nu, T, chi, div_v, S_S, pressure, viscosity, energy_source, chi_star, p_f, mu_f;
};

TEST(CellClosure, ReferenceValues) {
  const std::vector<CellRow> rows = {
      {FrictionModel::none, .58, 1e-4, .97, 1, 25, 9.7913558644, 0.33491306603, -23.509667908, 0.94006931639, 0.0, 0.0},
      {FrictionModel::critical_state, .58, 1e-4, .97, 1, 25, 200.18821432, 6.0807417819, -23.509667908, 0.94006931639,
       190.39685845, 5.7458287158},
      {FrictionModel::instantaneous, .58, 1e-4, .97, 1, 25, 188.77760043, 6.0578671911, -23.509667908, 0.94006931639,
       178.98624457, 5.7229541251},
      {FrictionModel::relaxed, .58, 1e-4, .97, 1, 25, 194.47630856, 6.0749966216, -23.509667908, 0.94006931639,
       184.6849527, 5.7400835555},
      {FrictionModel::none, .58, 1e-4, .97, -1, 25, 10.54355254, 0.33491306603, -3.1747595044, 1.0036382147, 0.0, 0.0},
      {FrictionModel::critical_state, .58, 1e-4, .97, -1, 25, 200.94041099, 6.0807417819, -3.1747595044, 1.0036382147,
       190.39685845, 5.7458287158},
      {FrictionModel::instantaneous, .58, 1e-4, .97, -1, 25, 201.63311565, 6.0793834789, -3.1747595044, 1.0036382147,
       191.08956311, 5.7444704128},
      {FrictionModel::relaxed, .58, 1e-4, .97, -1, 25, 195.22850524, 6.0749966216, -3.1747595044, 1.0036382147,
       184.6849527, 5.7400835555},
      {FrictionModel::none, .62, 1e-5, 1.04, -20, 400, 9.2250209259, 0.28574034547, 410.46743515, 1.0268815524, 0.0,
       0.0},
      {FrictionModel::critical_state, .62, 1e-5, 1.04, -20, 400, 29638.854651, 494.00742043, 410.46743515, 1.0268815524,
       29629.62963, 493.72168008},
      {FrictionModel::instantaneous, .62, 1e-5, 1.04, -20, 400, 30435.345092, 485.66484828, 410.46743515, 1.0268815524,
       30426.120071, 485.37910793},
      {FrictionModel::relaxed, .62, 1e-5, 1.04, -20, 400, 30824.039836, 472.22075726, 410.46743515, 1.0268815524,
       30814.814815, 471.93501691},
      {FrictionModel::none, .55, 4e-4, .3, 15, 100, 18.404981884, 0.41816524977, -343.23960643, 0.52380281969, 0.0,
       0.0},
      {FrictionModel::critical_state, .55, 4e-4, .3, 15, 100, 30.904981884, 0.60677881076, -343.23960643, 0.52380281969,
       12.5, 0.18861356099},
      {FrictionModel::instantaneous, .55, 4e-4, .3, 15, 100, 24.95251713, 0.56106162318, -343.23960643, 0.52380281969,
       6.5475352462, 0.1428963734},
      {FrictionModel::relaxed, .55, 4e-4, .3, 15, 100, 22.154981884, 0.51033794905, -343.23960643, 0.52380281969, 3.75,
       0.092172699281},
      {FrictionModel::none, .4, 1e-4, 1, 2, 50, 1.2130103224, 0.043236851607, -1.7163807463, 0.88992163964, 0.0, 0.0},
      {FrictionModel::critical_state, .4, 1e-4, 1, 2, 50, 1.2130103224, 0.043236851607, -1.7163807463, 0.88992163964,
       0.0, 0.0},
      {FrictionModel::instantaneous, .4, 1e-4, 1, 2, 50, 1.2130103224, 0.043236851607, -1.7163807463, 0.88992163964,
       0.0, 0.0},
      {FrictionModel::relaxed, .4, 1e-4, 1, 2, 50, 1.2130103224, 0.043236851607, -1.7163807463, 0.88992163964, 0.0,
       0.0},
  };
  for (const CellRow& row : rows) {
    const SolidsParameters p = with_models(row.model);
    const auto result = cell_closure(row.nu, row.T, row.chi, row.div_v, row.S_S, 0.0, p);
    std::ostringstream state;
    state << "model " << row.model->name << " nu " << row.nu << " div v " << row.div_v;
    const auto expect = [&](CellClosure::Entry entry, double expected) {
      EXPECT_NEAR(result[entry], expected, 1e-8 * std::abs(expected)) << state.str() << " entry " << entry;
    };
    expect(CellClosure::pressure, row.pressure);
    expect(CellClosure::viscosity, row.viscosity);
    expect(CellClosure::energy_source, row.energy_source);
    if (row.model == FrictionModel::relaxed || row.model == FrictionModel::instantaneous)
      expect(CellClosure::chi_star, row.chi_star);
    expect(CellClosure::frictional_pressure, row.p_f);
    expect(CellClosure::frictional_viscosity, row.mu_f);
    EXPECT_EQ(result[CellClosure::temperature], row.T);
    EXPECT_NEAR(result[CellClosure::sqrt_temperature], std::sqrt(row.T), 1e-8 * std::sqrt(row.T));
    EXPECT_NEAR(edge_closure(row.nu, critical_pressure(row.nu, p.friction), row.T, row.chi, row.div_v, row.S_S, 0.0, p),
                row.viscosity, 1e-8 * row.viscosity);
  }
}

TEST(CellClosure, WithoutStrainRateFluctuation) {  // (15)-(17), mpmath
  SolidsParameters p = with_models(FrictionModel::instantaneous);
  p.friction.fluctuation = 0;
  const auto result = cell_closure(.58, 1e-4, 1.0, 1.0, 25.0, 0.0, p);
  EXPECT_NEAR(result[CellClosure::chi_star], .86476385862, 1e-8);
  EXPECT_NEAR(result[CellClosure::frictional_pressure], 164.64832198, 1e-6);
  EXPECT_NEAR(result[CellClosure::frictional_viscosity], 12.589163734, 1e-7);
}

TEST(CellClosure, ConstantTemperatureIgnoresTheArgument) {
  SolidsParameters p = with_models(FrictionModel::relaxed, TemperatureModel::constant);
  p.temperature_value = 1e-4;
  const SolidsParameters transported = with_models(FrictionModel::relaxed);
  const auto a = cell_closure(.58, 77.0, .97, 1.0, 25.0, 0.0, p),
             b = cell_closure(.58, 1e-4, .97, 1.0, 25.0, 0.0, transported);
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_DOUBLE_EQ(a[i], b[i]);
}

TEST(CellClosure, AlgebraicTemperatureBalancesTheEnergy) {
  const SolidsParameters p = with_models(FrictionModel::relaxed, TemperatureModel::algebraic);
  for (double nu : {.1, .3, .58, .64})
    for (double div_v : {-100.0, -1.0, 0.0, 1.0, 100.0})
      for (double S_S : {1.0, 400.0}) {
        const auto result = cell_closure(nu, 0.0, 1.0, div_v, S_S, 0.0, p);
        const double loss =
            dissipation(nu, result[CellClosure::temperature], result[CellClosure::sqrt_temperature], p.kinetic);
        EXPECT_NEAR(result[CellClosure::energy_source], 0,
                    2e-8 * (loss + 2 * result[CellClosure::viscosity] * S_S + std::abs(result[0] * div_v)))
            << "nu " << nu << " div v " << div_v << " S:S " << S_S;
      }
}

TEST(CellClosure, ShearHeatsNoVoids) {
  EXPECT_EQ(production_share(0.0), 0);
  EXPECT_DOUBLE_EQ(production_share(1e-4), 0.5);
  EXPECT_NEAR(production_share(1e-3), 1, 2e-8);
  const auto heat = [](TemperatureModel model, double nu) {
    return cell_closure(nu, 1e-4, 1.0, 0.0, 1e6, 0.0, with_models(FrictionModel::none, model));
  };
  for (const double nu : {1e-9, 1e-7, 1e-5}) {
    const auto at = heat(TemperatureModel::transport, nu);
    EXPECT_GT(at[CellClosure::viscosity], 1e-4) << nu;  // does not vanish with nu
    EXPECT_LT(at[CellClosure::energy_source], 1e-7 * 2 * at[CellClosure::viscosity] * 1e6) << nu;
  }
  const auto dense = heat(TemperatureModel::transport, 0.1);
  EXPECT_GT(dense[CellClosure::energy_source], 0.9 * 2 * dense[CellClosure::viscosity] * 1e6);
}

// T2: steady simple shear, total shear stress.
TEST(CellClosure, SteadySimpleShear) {
  const SolidsParameters p = with_models(FrictionModel::critical_state, TemperatureModel::algebraic);
  const double rate = 20, nu = .6, d = p.kinetic.d;
  const auto result = cell_closure(nu, 0.0, 1.0, 0.0, rate * rate / 2, 0.0, p);
  const double T = 1.09362578378 * d * d * rate * rate;
  EXPECT_NEAR(result[CellClosure::temperature], T, 1e-8 * T);
  const double kinetic = 17.4033844433 * p.kinetic.rho_s * d * std::sqrt(T) * rate;
  const double frictional = 1600 * std::sin(p.friction.phi) * rate / std::sqrt(rate * rate + 2 * T / (d * d));
  EXPECT_NEAR(result[CellClosure::viscosity] * rate, kinetic + frictional, 1e-8 * (kinetic + frictional));
}

TEST(CellClosure, PiecesAreEntries) {
  const SolidsParameters p = with_models(FrictionModel::relaxed);
  const SolidsPoint<double> q{.58, 1e-4, .97, 1.0, 25.0};
  const auto all = cell_closure(q, p);
  EXPECT_EQ(solids_stress(q, p)[0], all[CellClosure::pressure]);
  EXPECT_EQ(solids_stress(q, p)[1], all[CellClosure::viscosity]);
  EXPECT_EQ(solids_energy_source(q, p), all[CellClosure::energy_source]);
  EXPECT_EQ(temperature(q, p)[0], all[CellClosure::temperature]);
  EXPECT_EQ(temperature(q, p)[1], all[CellClosure::sqrt_temperature]);
  EXPECT_NEAR(chi_source(.97, .94, p.friction), -30, 1e-12);
}

/// cell_closure and edge_closure of x = (nu, T, chi, div_v, S_S).
struct AllStress {
  SolidsParameters p;
  template <class Number>
  std::array<Number, CellClosure::count + 1> operator()(const std::array<Number, 5>& x) const {
    const auto cell = cell_closure(x[0], x[1], x[2], x[3], x[4], Number(0.0), p);
    std::array<Number, CellClosure::count + 1> result;
    std::copy(cell.begin(), cell.end(), result.begin());
    // Zero up to round-off, which differences would only amplify.
    if (p.temperature == TemperatureModel::algebraic) result[CellClosure::energy_source] = 0.0;
    result[CellClosure::count] =
        edge_closure(x[0], critical_pressure(x[0], p.friction), x[1], x[2], x[3], x[4], Number(0.0), p);
    return result;
  }
};

std::string describe(const SolidsParameters& p, const std::array<double, 5>& x) {
  std::ostringstream text;
  text << "friction " << p.friction.model->name << " temperature " << static_cast<int>(p.temperature) << " nu " << x[0]
       << " T " << x[1] << " chi " << x[2] << " div v " << x[3] << " S:S " << x[4];
  return text.str();
}

TEST(CellClosure, DerivativesMatchDifferences) {
  for (FrictionModel friction : friction_models)
    for (TemperatureModel temperature : temperature_models)
      for (double nu : {.1, .48, .55, .62})
        for (double chi : {.6, 1.02})
          for (double div_v : {-4.0, -.3, .3, 4.0}) {
            const AllStress f{with_models(friction, temperature)};
            const std::array<double, 5> x{nu, 1e-4, chi, div_v, 25};
            const double length = std::min({nu, std::abs(nu - .5), .65 - nu});
            testing::expect_derivatives_match(f, x, {length, 1e-4, .03 * chi, std::abs(div_v), 25}, describe(f.p, x),
                                              1e-7);
          }
}

TEST(CellClosure, FiniteAtTheEdges) {  // H15
  using D = Dual<5>;
  for (FrictionModel friction : friction_models)
    for (TemperatureModel temperature : temperature_models)
      for (double nu : {0.0, 1e-12, .5, .5 + 1e-9, .65 - 1e-9})
        for (double T : {0.0, 1e-12, 1e-4})
          for (double chi : {0.0, 1.0, 1.2})
            for (double div_v : {-1e3, -1e-9, 0.0, 1e-9, 1e3})
              for (double S_S : {0.0, 1e-12, 25.0}) {
                const AllStress f{with_models(friction, temperature)};
                const auto result = f(std::array<D, 5>{D::variable(nu, 0), D::variable(T, 1), D::variable(chi, 2),
                                                       D::variable(div_v, 3), D::variable(S_S, 4)});
                for (const D& y : result) testing::expect_finite(y, describe(f.p, {nu, T, chi, div_v, S_S}));
              }
}

TEST(CellClosure, PackedBeyondTheMaximumIsNotFinite) {
  for (FrictionModel friction : friction_models) {
    const auto result = cell_closure(.65 + 1e-6, 1e-4, 1.0, 0.0, 25.0, 0.0, with_models(friction));
    EXPECT_FALSE(std::isfinite(result[CellClosure::pressure])) << "the solver has to see it";
  }
}

// The way kernels call: few intermediates, many unknowns, the frozen ones constants.
TEST(CellClosure, ThroughManyUnknowns) {
  const SolidsParameters p = with_models(FrictionModel::critical_state);
  using D = Dual<12>;
  const D nu = .5 * (D::variable(.57, 0) + D::variable(.59, 1)), T = D::variable(1e-4, 4);
  const D div_v = D::variable(3, 7) - D::variable(2, 8), S_S = 25.0 + div_v * div_v;
  const auto result = through([&](const auto&... z) { return cell_closure(z..., p); }, nu, T, 1.0, div_v, S_S, 0.0);
  const Dual<5> expected =
      cell_closure(Dual<5>::variable(.58, 0), Dual<5>::variable(1e-4, 1), Dual<5>(1.0), Dual<5>::variable(1, 3),
                   Dual<5>::variable(26, 4), Dual<5>(0.0), p)[CellClosure::pressure];
  const D& pressure = result[CellClosure::pressure];
  EXPECT_DOUBLE_EQ(pressure.value, expected.value);
  EXPECT_DOUBLE_EQ(pressure.derivative[1], .5 * expected.derivative[0]);
  EXPECT_DOUBLE_EQ(pressure.derivative[4], expected.derivative[1]);
  EXPECT_NEAR(pressure.derivative[8], -expected.derivative[3] - 2 * expected.derivative[4], 1e-12);
  EXPECT_EQ(pressure.derivative[2], 0);
}

}  // namespace
}  // namespace scree
