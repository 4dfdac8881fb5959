/// H15: every closure that the balances and the walls call, at all edges of its arguments at once, for every
/// combination of models: values and derivatives are finite, and what cannot be negative is not.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "scree/closures/stress.hpp"
#include "scree/closures/wall.hpp"

namespace scree {
namespace {

constexpr double nu_max = .65, least = std::numeric_limits<double>::min();
const std::vector<double> solids_fractions = {0, least, 1e-12, 1e-3, .5, .5 + 1e-12, nu_max - 1e-9};
const std::vector<double> temperatures = {0, least, 1e-12, 1e-4};
const std::vector<double> ratios = {0, least, 1, 1.2};  // chi; the tip of the yield surface is at 1.112
const std::vector<double> divergences = {-1e3, -least, 0, least, 1e3};
const std::vector<double> shears = {0, least, 25};  // S:S
const std::vector<double> slips = {0, least, 1e4};  // slip squared

/// Floors as they are by default, and far below what any case needs.
struct Floors {
  double temperature, strain_rate;
};
const std::vector<Floors> floors = {{1e-14, 1e-4}, {1e-24, 1e-10}};

template <class Visit>
void for_each_model(const Visit& visit) {
  for (FrictionModel friction :
       {FrictionModel::none, FrictionModel::critical_state, FrictionModel::instantaneous, FrictionModel::relaxed})
    for (double fluctuation : {1.0, 0.0})
      for (TemperatureModel temperature :
           {TemperatureModel::transport, TemperatureModel::algebraic, TemperatureModel::constant})
        for (GasModel gas : {GasModel::none, GasModel::darcy, GasModel::incompressible})
          for (double d : {1e-3, 2e-5})
            for (const Floors& floor : floors) {
              SolidsParameters p;
              p.friction.model = friction;
              p.friction.fluctuation = fluctuation;
              p.friction.strain_rate_floor = floor.strain_rate;
              p.temperature = temperature;
              p.temperature_floor = floor.temperature;
              p.temperature_value = 0;
              p.gas.model = gas;
              p.kinetic.d = p.friction.d = d;
              visit(p);
            }
}

std::string describe(const SolidsParameters& p) {
  std::ostringstream text;
  text << "friction " << p.friction.model->name << " fluctuation " << p.friction.fluctuation << " temperature "
       << static_cast<int>(p.temperature) << " gas " << static_cast<int>(p.gas.model) << " d " << p.kinetic.d
       << " floor of T " << p.temperature_floor;
  return text.str();
}

template <std::size_t m>
std::string list(const std::array<double, m>& x) {
  std::ostringstream text;
  for (double value : x) text << ' ' << value;
  return text.str();
}

template <std::size_t m>
std::array<Dual<static_cast<int>(m)>, m> seeded(const std::array<double, m>& x) {
  std::array<Dual<static_cast<int>(m)>, m> result;
  for (std::size_t i = 0; i < m; ++i) result[i] = Dual<static_cast<int>(m)>::variable(x[i], static_cast<int>(i));
  return result;
}

template <int n>
bool finite(const Dual<n>& y) {
  bool good = std::isfinite(y.value);
  for (int j = 0; j < n; ++j) good = good && std::isfinite(y.derivative[static_cast<std::size_t>(j)]);
  return good;
}

/// f(nu, T, chi, div v, S:S, slip squared) at each combination of edges.
template <class Visit>
void for_each_edge(const Visit& visit) {
  for (double nu : solids_fractions)
    for (double T : temperatures)
      for (double chi : ratios)
        for (double div_v : divergences)
          for (double S_S : shears)
            for (double slip2 : slips) visit(std::array<double, 6>{nu, T, chi, div_v, S_S, slip2});
}

TEST(Edges, StressAndSourcesOfACell) {
  for_each_model([](const SolidsParameters& p) {
    for_each_edge([&](const std::array<double, 6>& x) {
      const auto q = seeded(x);
      const auto y = cell_closure(q[0], q[1], q[2], q[3], q[4], q[5], p);
      for (std::size_t r = 0; r < y.size(); ++r)
        if (!finite(y[r])) ADD_FAILURE() << "entry " << r << ", " << describe(p) << ", at" << list(x);
      for (CellClosure::Entry r : {CellClosure::viscosity, CellClosure::chi_star, CellClosure::frictional_pressure,
                                   CellClosure::frictional_viscosity, CellClosure::temperature,
                                   CellClosure::sqrt_temperature, CellClosure::drag, CellClosure::drag_over_nu})
        if (!(y[r].value >= 0)) ADD_FAILURE() << "entry " << r << " < 0, " << describe(p) << ", at" << list(x);
      if (p.gas.model != GasModel::none && !(y[CellClosure::drag_over_nu].value > 0))
        ADD_FAILURE() << "no drag on single particles, " << describe(p) << ", at" << list(x);
    });
  });
}

TEST(Edges, ViscosityOfAnEdge) {
  for_each_model([](const SolidsParameters& p) {
    for_each_edge([&](const std::array<double, 6>& x) {
      const auto q = seeded(x);
      const auto mu = edge_closure(q[0], critical_pressure(q[0], p.friction), q[1], q[2], q[3], q[4], q[5], p);
      if (!finite(mu) || !(mu.value >= 0)) ADD_FAILURE() << mu.value << ", " << describe(p) << ", at" << list(x);
    });
  });
}

TEST(Edges, ConductivityOfAFace) {
  for_each_model([](const SolidsParameters& p) {
    for (double nu : solids_fractions)
      for (double T : temperatures)
        for (double slip2 : slips) {
          const std::array<double, 3> x{nu, T, slip2};
          const auto q = seeded(x);
          const auto kappa = face_conductivity(q[0], q[1], q[2], p);
          if (!finite(kappa) || !(kappa.value >= 0))
            ADD_FAILURE() << kappa.value << ", " << describe(p) << ", at" << list(x);
        }
  });
}

TEST(Edges, WallLaws) {
  const KineticParameters kinetic;
  for (double specularity : {0.0, .25, 1.0})
    for (double delta : {0.0, .2147})
      for (double regularisation : {3e-3, 1e-9})
        for (double nu : solids_fractions)
          for (double T : temperatures)
            for (double N : {0.0, least, 1e40})
              for (double slip2 : slips) {
                WallParameters wall;
                wall.specularity = specularity, wall.delta = delta, wall.slip_regularisation = regularisation;
                const std::array<double, 4> x{nu, T, N, slip2};
                const auto q = seeded(x);
                const auto sqrt_T = sqrt_temperature(q[1], 1e-14);
                const auto c = wall_traction_coefficient(q[0], sqrt_T, q[2], q[3], kinetic, wall);
                const auto heat = wall_heat_flux(q[0], q[1], sqrt_T, q[3], kinetic, wall);
                if (!finite(c) || !(c.value >= 0) || !finite(heat))
                  ADD_FAILURE() << c.value << ", " << heat.value << ", specularity " << specularity << ", at"
                                << list(x);
              }
}

TEST(Edges, DragAndDarcyFlow) {
  GasParameters gas;
  for (double d : {1e-3, 2e-5})
    for (double nu : solids_fractions)
      for (double x2 : {0.0, least, 1e-20, 1.0, 1e12}) {  // slip squared, or the squared gradient of p_g
        const std::array<double, 2> x{nu, x2};
        const auto q = seeded(x);
        const auto beta = drag_coefficient(q[0], q[1], d, gas);
        EXPECT_TRUE(finite(beta) && beta.value >= 0) << d << ", at" << list(x);
        for (double floor : {1e-3, 1e-9}) {
          const auto flow = darcy_flow(q[0], q[1], floor, d, gas);
          EXPECT_TRUE(finite(flow[0]) && flow[0].value > 0) << d << ", floor " << floor << ", at" << list(x);
          EXPECT_TRUE(finite(flow[1]) && flow[1].value >= 0) << d << ", floor " << floor << ", at" << list(x);
        }
      }
}

// p_c grows without bound towards nu_max, and neither it nor what contains it is capped there.
TEST(Edges, PackingHasNoCap) {
  FrictionParameters p;
  double before = 0;
  for (double distance : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const Dual<1> p_c = critical_pressure(Dual<1>::variable(nu_max - distance, 0), p);
    EXPECT_TRUE(finite(p_c)) << distance;
    EXPECT_GT(p_c.value, before);
    // slope p_c (r/(nu - nu_min) + s/(nu_max - nu)), with the distance as it is after rounding
    const double nu = nu_max - distance, slope = p_c.value * (p.r / (nu - p.nu_min) + p.s / (nu_max - nu));
    EXPECT_NEAR(p_c.derivative[0], slope, 1e-12 * slope);
    before = p_c.value;
  }
  EXPECT_EQ(critical_pressure(nu_max, p), std::numeric_limits<double>::infinity());
  for_each_model([](const SolidsParameters& q) {
    const auto y = cell_closure(nu_max, 0.0, 1.0, 0.0, 0.0, 0.0, q);
    if (std::isfinite(y[CellClosure::pressure])) ADD_FAILURE() << "finite pressure at nu_max, " << describe(q);
  });
}

}  // namespace
}  // namespace scree
