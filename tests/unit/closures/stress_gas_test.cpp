/// The solids closures with gas.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "derivative_check.hpp"
#include "scree/closures/stress.hpp"

namespace scree {
namespace {

const std::vector<FrictionModel> friction_models = {FrictionModel::none, FrictionModel::critical_state,
                                                    FrictionModel::instantaneous, FrictionModel::relaxed};
const std::vector<TemperatureModel> temperature_models = {TemperatureModel::transport, TemperatureModel::algebraic,
                                                          TemperatureModel::constant};
const std::vector<GasModel> gas_models = {GasModel::darcy, GasModel::incompressible};

SolidsParameters with_models(FrictionModel friction, TemperatureModel temperature, double d = 1e-4,
                             GasModel gas = GasModel::incompressible) {
  SolidsParameters p;
  p.friction.model = friction;
  p.temperature = temperature;
  p.kinetic.d = p.friction.d = d;
  p.gas.model = gas;
  return p;
}

TEST(StressWithGas, EntriesAreTheClosures) {
  for (GasModel model : gas_models) {
    const SolidsParameters p = with_models(FrictionModel::none, TemperatureModel::transport, 1e-4, model);
    const double nu = .4, T = 1e-6, div_v = 3, S_S = 50, slip2 = .04, sqrt_T = std::sqrt(T + p.temperature_floor);
    const auto result = cell_closure(nu, T, 1.0, div_v, S_S, slip2, p);
    const double beta = drag_coefficient(nu, slip2, 1e-4, p.gas),
                 mu = shear_viscosity(nu, sqrt_T, beta / nu, p.kinetic);
    EXPECT_DOUBLE_EQ(result[CellClosure::drag], beta);
    EXPECT_DOUBLE_EQ(result[CellClosure::drag_over_nu], beta / nu);
    EXPECT_NEAR(result[CellClosure::viscosity], mu, 1e-13 * mu);
    EXPECT_LT(mu, .99 * shear_viscosity(nu, sqrt_T, p.kinetic)) << "the gas must matter here";
    EXPECT_NEAR(edge_closure(nu, critical_pressure(nu, p.friction), T, 1.0, div_v, S_S, slip2, p), mu, 1e-13 * mu);
    const double J_vis = viscous_dissipation(nu, T, sqrt_T, beta, slip2, p.gas.mu_g, p.kinetic);
    const double source = 2 * mu * S_S - result[CellClosure::pressure] * div_v - dissipation(nu, T, sqrt_T, p.kinetic);
    EXPECT_NEAR(result[CellClosure::energy_source], source - J_vis, 1e-12 * (std::abs(source) + std::abs(J_vis)));
    const double kappa = conductivity(nu, sqrt_T, beta / nu, p.kinetic);
    EXPECT_DOUBLE_EQ(face_conductivity(nu, T, slip2, p), kappa);
  }
}

TEST(StressWithGas, NoGasIgnoresTheSlip) {
  for (TemperatureModel temperature : temperature_models) {
    const SolidsParameters p = with_models(FrictionModel::relaxed, temperature, 1e-4, GasModel::none);
    const auto a = cell_closure(.58, 1e-4, .97, 1.0, 25.0, 0.0, p), b = cell_closure(.58, 1e-4, .97, 1.0, 25.0, 4.0, p);
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i], b[i]);
    EXPECT_EQ(b[CellClosure::drag], 0);
    EXPECT_EQ(b[CellClosure::drag_over_nu], 0);
    EXPECT_EQ(face_conductivity(.58, 1e-4, 4.0, p),
              conductivity(.58, sqrt_temperature(1e-4, p.temperature_floor), p.kinetic));
  }
}

TEST(StressWithGas, VanishingDensityAndViscosityIsNoGas) {  // T18
  for (FrictionModel friction : friction_models)
    for (TemperatureModel temperature : temperature_models)
      for (double nu : {.1, .3, .58, .62})
        for (double div_v : {-4.0, 0.0, 4.0}) {
          SolidsParameters p = with_models(friction, temperature, 1e-3);
          p.gas.rho_g = 1.3e-15;
          p.gas.mu_g = 1.8e-20;
          SolidsParameters without = p;
          without.gas.model = GasModel::none;
          auto a = cell_closure(nu, 1e-4, .97, div_v, 25.0, 1.0, p);
          auto b = cell_closure(nu, 1e-4, .97, div_v, 25.0, 1.0, without);
          if (temperature == TemperatureModel::algebraic)  // round-off
            a[CellClosure::energy_source] = b[CellClosure::energy_source] = 0;
          for (std::size_t i = 0; i < CellClosure::drag; ++i)
            EXPECT_NEAR(a[i], b[i], 1e-10 * std::abs(b[i])) << "entry " << i << " nu " << nu << " div v " << div_v;
          EXPECT_NEAR(face_conductivity(nu, 1e-4, 1.0, p), face_conductivity(nu, 1e-4, 1.0, without), 1e-10);
        }
}

// T17: fJ rho_s T^1.5/d + 3 beta T = agitation/(sqrt(T) + limit); the table has limit = 0.
struct SlipRow {
  double nu, d, w, T;  ///< cgs
};
TEST(StressWithGas, TemperatureHeldUpBySlip) {
  for (const SlipRow& row : std::vector<SlipRow>{{.3, .01, 20, .207491}, {.3, .04, 100, .325318}}) {
    SolidsParameters p = with_models(FrictionModel::none, TemperatureModel::algebraic, .01 * row.d);
    const KineticParameters& k = p.kinetic;
    const double slip2 = 1e-4 * row.w * row.w, beta = drag_coefficient(row.nu, slip2, k.d, p.gas);
    const double g0 = radial_distribution(row.nu, k), fJ = dissipation_factor(row.nu, g0, k);
    const double agitation = 81 * row.nu * p.gas.mu_g * p.gas.mu_g * slip2 / (g0 * k.d * k.d * k.d * k.rho_s * sqrt_pi);
    const auto root = [](const auto& excess) {
      double lower = 1e-7, upper = 1;
      for (int i = 0; i < 200; ++i) {
        const double middle = (lower + upper) / 2;
        (excess(middle) > 0 ? lower : upper) = middle;
      }
      return lower;
    };
    const auto expected = [&](double limit) {
      const double s =
          root([&](double x) { return agitation / (x + limit) - fJ * k.rho_s / k.d * x * x * x - 3 * beta * x * x; });
      return s * s;
    };
    EXPECT_NEAR(expected(0), 1e-4 * row.T, 3e-6 * 1e-4 * row.T) << "the table, d " << row.d;

    const auto algebraic = cell_closure(row.nu, 0.0, 1.0, 0.0, 0.0, slip2, p);
    const double T = algebraic[CellClosure::temperature];
    EXPECT_NEAR(T, expected(agitation_limit), 1e-8 * T) << "d " << row.d;
    EXPECT_NEAR(T, 1e-4 * row.T, 5e-3 * T) << "the limit of (1.8) does little, d " << row.d;
    EXPECT_EQ(temperature(SolidsPoint<double>{row.nu, 0.0, 1.0, 0.0, 0.0, slip2}, p)[0], T);

    p.temperature = TemperatureModel::transport;
    p.temperature_floor = 1e-20;
    const double s = root(
        [&](double x) { return cell_closure(row.nu, x * x, 1.0, 0.0, 0.0, slip2, p)[CellClosure::energy_source]; });
    EXPECT_NEAR(s * s, expected(agitation_limit), 1e-9 * s * s) << "d " << row.d;
  }
}

TEST(StressWithGas, AlgebraicTemperatureBalancesTheEnergy) {
  for (double d : {1e-4, 1e-3})
    for (double nu : {.1, .3, .58, .64})
      for (double div_v : {-1000.0, -1.0, 0.0, 1.0, 100.0})
        for (double S_S : {1.0, 1e5})
          for (double slip2 : {0.0, 1e-4, 1.0, 100.0}) {
            const SolidsParameters p = with_models(FrictionModel::relaxed, TemperatureModel::algebraic, d);
            const auto result = cell_closure(nu, 0.0, 1.0, div_v, S_S, slip2, p);
            const double T = result[CellClosure::temperature], sqrt_T = result[CellClosure::sqrt_temperature];
            const double loss = dissipation(nu, T, sqrt_T, p.kinetic) + 3 * result[CellClosure::drag] * T;
            const double kinetic_p = result[CellClosure::pressure] - result[CellClosure::frictional_pressure];
            // The floors: production that holds T at 1e-14 m2/s2.
            const double floor =
                sqrt_T * dissipation(nu, 1e-14, 1.0, p.kinetic) + 3 * result[CellClosure::drag] * 1e-14;
            EXPECT_NEAR(result[CellClosure::energy_source] + floor, 0,
                        2e-8 * (loss + floor + std::abs(kinetic_p * div_v)))
                << "d " << d << " nu " << nu << " div v " << div_v << " S:S " << S_S << " slip^2 " << slip2;
          }
}

TEST(StressWithGas, RestHasTheFloorTemperature) {
  for (double nu : {.3, .58, .64}) {
    const SolidsParameters p = with_models(FrictionModel::none, TemperatureModel::algebraic);
    EXPECT_NEAR(cell_closure(nu, 0.0, 1.0, 0.0, 0.0, 0.0, p)[CellClosure::sqrt_temperature], 1e-7, 1e-15) << nu;
  }
}

/// cell_closure, edge_closure and face_conductivity of x = (nu, T, chi, div_v, S_S, slip squared).
struct AllStress {
  SolidsParameters p;
  template <class Number>
  std::array<Number, CellClosure::count + 2> operator()(const std::array<Number, 6>& x) const {
    const auto cell = cell_closure(x[0], x[1], x[2], x[3], x[4], x[5], p);
    std::array<Number, CellClosure::count + 2> result;
    std::copy(cell.begin(), cell.end(), result.begin());
    // Zero up to round-off, which differences would only amplify.
    if (p.temperature == TemperatureModel::algebraic) result[CellClosure::energy_source] = 0.0;
    result[CellClosure::count] =
        edge_closure(x[0], critical_pressure(x[0], p.friction), x[1], x[2], x[3], x[4], x[5], p);
    result[CellClosure::count + 1] =
        through([&](const auto& nu, const auto& T, const auto& slip2) { return face_conductivity(nu, T, slip2, p); },
                x[0], x[1], x[5]);
    return result;
  }
};

std::string describe(const SolidsParameters& p, const std::array<double, 6>& x) {
  std::ostringstream text;
  text << "friction " << p.friction.model->name << " temperature " << static_cast<int>(p.temperature) << " d "
       << p.kinetic.d << " nu " << x[0] << " T " << x[1] << " chi " << x[2] << " div v " << x[3] << " S:S " << x[4]
       << " slip^2 " << x[5];
  return text.str();
}

TEST(StressWithGas, DerivativesMatchDifferences) {
  for (FrictionModel friction : friction_models)
    for (TemperatureModel temperature : temperature_models)
      for (double d : {1e-4, 1e-3})
        for (double nu : {.1, .48, .55, .62})
          for (double div_v : {-4.0, -.3, .3, 4.0})
            for (double slip2 : {1e-6, .04, 1.0}) {
              const AllStress f{with_models(friction, temperature, d)};
              const double chi = .6, length = std::min({nu, std::abs(nu - .5), .65 - nu});
              const std::array<double, 6> x{nu, 1e-4, chi, div_v, 25, slip2};
              testing::expect_derivatives_match(f, x, {length, 1e-4, .03 * chi, std::abs(div_v), 25, slip2},
                                                describe(f.p, x), 1e-7);
            }
}

TEST(StressWithGas, FiniteAtTheEdges) {  // H15
  using D = Dual<6>;
  for (FrictionModel friction : friction_models)
    for (TemperatureModel temperature : temperature_models)
      for (double nu : {-1e-9, 0.0, 1e-12, 1e-3, .5, .5 + 1e-9, .65 - 1e-9})
        for (double T : {0.0, 1e-12, 1e-4})
          for (double div_v : {-1e3, -1e-9, 0.0, 1e-9, 1e3})
            for (double S_S : {0.0, 1e-12, 25.0})
              for (double slip2 : {0.0, 1e-20, 1.0, 1e4}) {
                const AllStress f{with_models(friction, temperature)};
                const std::array<double, 6> x{nu, T, 1.0, div_v, S_S, slip2};
                std::array<D, 6> seeded;
                for (std::size_t i = 0; i < 6; ++i) seeded[i] = D::variable(x[i], static_cast<int>(i));
                for (const D& y : f(seeded)) testing::expect_finite(y, describe(f.p, x));
              }
}

TEST(StressWithGas, PackedBeyondTheMaximumIsNotFinite) {
  for (TemperatureModel temperature : temperature_models) {
    const auto result =
        cell_closure(.65 + 1e-6, 1e-4, 1.0, 0.0, 25.0, 1.0, with_models(FrictionModel::relaxed, temperature));
    EXPECT_FALSE(std::isfinite(result[CellClosure::pressure])) << "the solver has to see it";
  }
}

}  // namespace
}  // namespace scree
