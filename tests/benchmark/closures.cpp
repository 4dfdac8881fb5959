#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "benchmarks.hpp"
#include "scree/closures/rheology/relaxed.hpp"
#include "scree/closures/stress.hpp"
#include "scree/closures/wall.hpp"

namespace scree::benchmarks {
namespace {

/// States of a dense flow, dilating and compacting, with slip of a gas: enough of them that no branch can be learnt.
std::vector<std::array<double, 6>> flow_states() {
  std::vector<std::array<double, 6>> states;
  for (int k = 0; k < 512; ++k) {
    const double a = std::sin(1.7 * k), b = std::sin(2.3 * k + 1), c = std::cos(3.1 * k), e = std::cos(4.9 * k + 2);
    states.push_back({0.56 + 0.06 * a, 1e-4 * std::exp(2 * b), 0.9 + 0.2 * c, 10 * e, 400 * std::exp(a * b),
                      0.04 * std::exp(c * e)});
  }
  return states;
}

double sum_of(double x) { return x; }
template <int n>
double sum_of(const Dual<n>& x) {
  return x.value + x.derivative[0];
}
template <class Number, std::size_t count>
double sum_of(const std::array<Number, count>& x) {
  double sum = 0;
  for (const Number& entry : x) sum += sum_of(entry);
  return sum;
}

template <class Number>
Number input(double value, [[maybe_unused]] int index) {
  if constexpr (std::is_same_v<Number, double>)
    return value;
  else
    return Number::variable(value, index);
}

/// Measures closure(z0, z1, ...) of the numbers `entries` of a flow state, differentiated by them or not.
template <class Number, int... entries, class Closure>
void measure(benchmark::State& state, const Closure& closure) {
  const auto states = flow_states();
  std::size_t k = 0;
  for (auto _ : state) {
    const auto& s = states[k++ % states.size()];
    int next = 0;
    const std::array<Number, sizeof...(entries)> z{input<Number>(s[entries], next++)...};
    double sum = sum_of(std::apply(closure, z));
    benchmark::DoNotOptimize(sum);
  }
}

template <int... entries, class Closure>
void add(const std::string& name, const Closure& closure) {
  constexpr int count = sizeof...(entries);
  benchmark::RegisterBenchmark(("closure/" + name + "/double").c_str(),
                               [closure](benchmark::State& s) { measure<double, entries...>(s, closure); });
  benchmark::RegisterBenchmark(("closure/" + name + "/dual_" + std::to_string(count)).c_str(),
                               [closure](benchmark::State& s) { measure<Dual<count>, entries...>(s, closure); });
}

enum Entry { nu, T, chi, div_v, S_S, slip_squared };

SolidsParameters parameters(GasModel gas) {
  SolidsParameters p;
  p.gas.model = gas;
  return p;
}

void add_whole_points(const std::string& name, const SolidsParameters& p) {
  add<nu, T, chi, div_v, S_S, slip_squared>("cell" + name, [p](const auto&... z) { return cell_closure(z..., p); });
  add<nu, T, chi, div_v, S_S, slip_squared>("edge" + name, [p](const auto& nu_, const auto&... z) {
    return edge_closure(nu_, critical_pressure(nu_, p.friction), z..., p);
  });
  add<nu, T, slip_squared>("face_conductivity" + name, [p](const auto&... z) { return face_conductivity(z..., p); });
}

}  // namespace

void add_closures() {
  const SolidsParameters p = parameters(GasModel::none), air = parameters(GasModel::incompressible);
  add<nu>("radial_distribution", [p](const auto& x) { return radial_distribution(x, p.kinetic); });
  add<nu>("kinetic_factors", [p](const auto& x) { return kinetic_factors(x, p.kinetic); });
  add<nu>("critical_pressure", [p](const auto& x) { return critical_pressure(x, p.friction); });
  add<T, chi, div_v, S_S>("friction", [p](const auto& t, const auto& x, const auto& div, const auto& s) {
    using Number = std::decay_t<decltype(x)>;
    const Number gamma = fluctuating_strain_rate(s, t, p.friction);
    const FrictionalPoint<Number> q{Number(.6), Number(t), x, Number(div), Number(s), Number(100.0), gamma};
    const auto stress = Relaxed::stress(q, p.friction);
    return std::array<Number, 3>{stress.pressure, stress.viscosity, Relaxed::steady(q, p.friction)};
  });
  add<nu, slip_squared>("drag",
                        [air](const auto& x, const auto& w2) { return drag_over_nu(x, w2, air.kinetic.d, air.gas); });
  add<nu, slip_squared>("darcy", [air](const auto& x, const auto& w2) {
    return darcy_flow(x, decltype(w2 * 1.0)(w2 * 1e6), 1e-3, air.kinetic.d, air.gas);
  });
  add<nu, T, slip_squared>("wall", [p](const auto& x, const auto& t, const auto& s2) {
    const WallParameters wall;
    const auto root = sqrt_temperature(t, p.temperature_floor);
    using Number = std::decay_t<decltype(root)>;
    const Number collisions = wall.specularity * wall_collision_rate(x, root, p.kinetic, wall);
    const Number share = wall_slip_share(Number(50.0), Number(100.0), collisions, s2, wall);
    return Number(share *
                  wall_traction_coefficient(x, root, Number(100.0), Number(share * share * s2), p.kinetic, wall));
  });
  add_whole_points("", p);
  add_whole_points("_gas", air);
}

}  // namespace scree::benchmarks
