/// Growth of short waves about homogeneous shear that may dilate or compact, under the stress law of a case: from the
/// Jacobian of the program as it is discretised. Reads base states, writes a row for each:
///
///     growth_rates CASE.yaml [-options of the case] < states.csv > rates.csv
///
/// A line of states.csv: nu, I, ratio, k_d
///     nu      solids fraction
///     I       inertial number d gdot sqrt(rho_s/p_c(nu)), which sets the rate of shear gdot
///     ratio   div v/gdot, equal along both axes: > 0 dilates, < 0 compacts
///     k_d     wave number times particle diameter
/// rates.csv repeats them, with
///     strain_rate   gdot [1/s]
///     temperature   T that this rate keeps up, or the value of the case where T is constant [m2/s2]
///     chi           p_f/p_c that stays
///     growth        greatest growth rate over all directions of the wave [1/s]
///     angle         of its wave vector to the direction of the flow [deg]
/// Coefficients are frozen: numbers count where growth is fast against gdot, and div v changes nu slowly. A wave has
/// 2 pi/kh cells: those of the grid follow the wave number.
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <sstream>

#include "../flutter/symbol.hpp"
#include "scree/app/petsc_session.hpp"
#include "scree/app/problem_setup.hpp"
#include "scree/config/command_line.hpp"
#include "scree/config/input_error.hpp"
#include "scree/config/read_case.hpp"

namespace scree::test {
namespace {

constexpr double kh = 0.02;  ///< phase from cell to cell: errors of differences are its square over 12

struct State {
  double nu, I, ratio, k_d;
};

/// Base state and grid of a line.
BaseState base_of(const State& state, const ProblemSetup& setup) {
  const FrictionParameters& friction = setup.solids.friction;
  const double gdot = state.I / friction.d * std::sqrt(critical_pressure(state.nu, friction) / friction.rho_s);
  const double half = 0.5 * state.ratio * gdot, h = kh / state.k_d * friction.d;
  BaseState base{"", state.nu, setup.solids.temperature_value, {0, 0}, {{{half, gdot}, {0, half}}}, {h, h}};
  base.slope = 0;  // p_c may be nearly rigid
  if (setup.solids.temperature != TemperatureModel::constant) base.T = steady_temperature(base, setup.solids);
  return base;
}

struct Greatest {
  double growth = -1e300, angle = 0;
};

/// Over directions: a scan of half a circle, and each peak of it made exact. Peaks can be narrow: the shorter the wave,
/// the closer it lies to a direction in which friction has no viscosity.
Greatest greatest_over_directions(const Symbol& symbol) {
  constexpr int parts = 36;
  Greatest greatest;
  const auto growth = [&](double angle) {
    const double rate = growth_rate(symbol, {kh * std::cos(angle), kh * std::sin(angle)});
    if (rate > greatest.growth) greatest = {rate, angle};
    return rate;
  };
  std::array<double, parts> scan{};
  for (int k = 0; k < parts; ++k) scan[static_cast<std::size_t>(k)] = growth(k * pi / parts);
  for (int k = 0; k < parts; ++k) {
    const auto at = [&](int place) { return scan[static_cast<std::size_t>((place + parts) % parts)]; };
    if (at(k) < at(k - 1) || at(k) < at(k + 1)) continue;
    const double golden = 0.5 * (std::sqrt(5.0) - 1);
    double low = (k - 1) * pi / parts, high = (k + 1) * pi / parts;
    for (int step = 0; step < 20; ++step) {
      const double left = high - golden * (high - low), right = low + golden * (high - low);
      if (growth(left) > growth(right))
        high = right;
      else
        low = left;
    }
  }
  return greatest;
}

State read_state(const std::string& line) {
  std::istringstream stream(line);
  State state{};
  char comma = ',';
  stream >> state.nu >> comma >> state.I >> comma >> state.ratio >> comma >> state.k_d;
  if (!stream || !(state.nu > 0) || !(state.I > 0) || !(state.k_d > 0))
    throw std::runtime_error("not a base state: \"" + line +
                             "\"; right would be nu, I, ratio, k_d, such as 0.6, 0.1, 0, 1");
  return state;
}

void write_growth(const State& state, const ProblemSetup& setup) {
  const FrictionParameters& friction = setup.solids.friction;
  if (!(state.nu > friction.nu_min && state.nu < friction.nu_max))
    throw std::runtime_error("no p_c at nu = " + std::to_string(state.nu) + ", right would be between " +
                             std::to_string(friction.nu_min) + " and " + std::to_string(friction.nu_max));
  const BaseState base = base_of(state, setup);
  const Greatest greatest = greatest_over_directions(Symbol(setup, base));
  std::printf("%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.5g\n", state.nu, state.I, state.ratio, state.k_d,
              base.gradient[0][1], base.T, steady_chi(base, setup.solids), greatest.growth, greatest.angle * 180 / pi);
}

void write_rates(const Case& scene) {
  const ProblemSetup setup = problem_setup(scene);
  if (setup.box.dim != 2)
    throw InputError("dimension", std::to_string(setup.box.dim), "2: waves are those of plane flow");
  if (setup.solids.gas.model != GasModel::none)
    throw InputError("gas", setup.solids.gas.model == GasModel::darcy ? "darcy" : "incompressible",
                     "none: waves are those of particles alone");
  if (!setup.solids.friction.model->has_friction)
    throw InputError("friction_model", "none", "a law of friction to look at");
  std::printf("nu,I,ratio,k_d,strain_rate,temperature,chi,growth,angle\n");
  for (std::string line; std::getline(std::cin, line);)
    if (!line.empty()) write_growth(read_state(line), setup);
}

}  // namespace
}  // namespace scree::test

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  int code = 0;
  try {
    const scree::Case scene = scree::read_case(scree::case_input(scree::read_command_line({argv + 1, argv + argc})));
    const scree::PetscSession petsc(argv[0], scene.petsc_options);
    scree::test::write_rates(scene);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "growth_rates: %s\n", error.what());
    code = 1;
  }
  MPI_Finalize();
  return code;
}
