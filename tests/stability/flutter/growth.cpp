/// H8: growth of waves about base states, as two tables. What the model says, continuous in time with friction coupled
/// (rates against wave number), and what a segregated treatment makes of it, which takes chi from the state before the
/// step (factors per step against dt and tau).
///
///     flutter_growth [-rates rates.csv] [-steps steps.csv] [-given 0.6,1e-6,0,-0.12,0.01,0.02,0.02,0.01,1e-3,2e-3]
///
/// `-given`: nu, T [m2/s2], v_x, v_y [m/s], dv_x/dx, dv_x/dy, dv_y/dx, dv_y/dy [1/s], cell sizes [m] of the only base
/// state instead of the four built in.
#include <cstdio>
#include <utility>

#include "symbol.hpp"

namespace scree::test {
namespace {

using Wave = std::array<double, 2>;  ///< phase from cell to cell along x and y

const std::vector<AdvectionScheme> schemes{AdvectionScheme::upwind, AdvectionScheme::van_albada};

const char* name_of(AdvectionScheme scheme) { return scheme == AdvectionScheme::upwind ? "upwind" : "van_albada"; }

ProblemSetup setup_of(FrictionModel model, double tau, AdvectionScheme scheme) {
  ProblemSetup setup = sample_setup(uniform_box(2, {4, 4, 1}), model, TemperatureModel::transport, scheme);
  setup.model.gravity = {0, -9.81, 0};
  setup.solids.friction.tau = tau;
  return setup;
}

/// Waves of the model as it is, continuous in time.
class Waves {
 public:
  Waves(FrictionModel model, double tau, AdvectionScheme scheme, const BaseState& base)
      : symbol_(setup_of(model, tau, scheme), base) {}

  /// Growth rate of the fastest growing wave of this phase [1/s].
  double rate(const Wave& kh) const { return growth_rate(symbol_, kh); }

 private:
  Symbol symbol_;
};

/// Waves under backward Euler for all but chi, which moves towards chi* of the state before the step, first.
class LaggedWaves {
 public:
  LaggedWaves(AdvectionScheme scheme, const BaseState& base)
      : step_(lagged(scheme), base),
        slow_(setup_of(FrictionModel::relaxed, 2 * tau_, scheme), base),
        fast_(setup_of(FrictionModel::relaxed, tau_, scheme), base) {}

  /// What of a wave does not depend on step and tau.
  struct Parts {
    Matrix state, rate;
    std::vector<Complex> towards;  ///< chi* - chi in terms of each unknown
  };
  Parts parts(const Wave& kh) const {
    Parts result{step_.state_part(kh), step_.rate_part(kh), {}};
    const int n = result.state.size, chi = step_.chi();
    // What two times of relaxation tell from the rest of the row of chi.
    const Matrix fast = fast_.state_part(kh), slow = slow_.state_part(kh), rate = fast_.rate_part(kh);
    for (int j = 0; j < n; ++j)
      result.towards.push_back(-(fast(chi, j) - slow(chi, j)) / (rate(chi, chi) * (0.5 / tau_)));
    return result;
  }

  /// Greatest factor by which the wave grows in a step; tau = 0: `instantaneous`.
  double factor(const Parts& wave, double tau, double dt) const {
    Matrix after = wave.state, before = wave.rate;
    for (std::size_t k = 0; k < after.entry.size(); ++k) {
      before.entry[k] /= dt;
      after.entry[k] += before.entry[k];
    }
    double most = 0;
    for (const Complex& z : eigenvalues(with_new_chi(before, wave, dt / (dt + tau)), after))
      most = std::max(most, std::abs(z));
    return most;
  }

 private:
  static ProblemSetup lagged(AdvectionScheme scheme) {
    ProblemSetup setup = setup_of(FrictionModel::relaxed, tau_, scheme);
    setup.solids.friction.lagged = true;
    return setup;
  }

  /// before * P, where P replaces chi by chi + share (chi* - chi).
  Matrix with_new_chi(const Matrix& before, const Parts& wave, double share) const {
    const int n = before.size, chi = step_.chi();
    Matrix result = before;
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) result(i, j) += before(i, chi) * share * wave.towards[static_cast<std::size_t>(j)];
    return result;
  }

  static constexpr double tau_ = 1e-3;
  Symbol step_, slow_, fast_;
};

// ---- tables ----

/// Cells of the paper's grid, 1 mm particles: plane shear with the granular temperature that it keeps up; the plug high
/// up in the bin as it dilates and as it compacts, slowly; the converging flow above the orifice.
std::vector<BaseState> built_in() {
  const std::array<double, 2> h{1e-3, 2e-3};
  return {{"shear", .58, 1.1e-4, {.05, -.05}, {{{0, 10}, {0, 0}}}, h},
          {"plug dilating", .60, 1e-6, {0, -.12}, {{{.01, .02}, {.02, .01}}}, h},
          {"plug compacting", .60, 1e-6, {0, -.12}, {{{-.01, .02}, {.02, -.01}}}, h},
          {"orifice", .56, 4e-3, {-.05, -.4}, {{{-14, 10}, {8, 20}}}, h}};
}

/// All directions of a wave whose phase along one axis is kh, and along the other at most that: pi reaches the corner,
/// where neighbours along both axes alternate. A wave and the one of opposite phase along both axes are conjugates.
std::vector<Wave> directions(double kh) {
  constexpr int parts = 4;
  std::vector<Wave> waves;
  for (int k = -parts; k <= parts; ++k) {
    const double other = kh * k / parts;
    waves.push_back({kh, other});
    if (std::abs(k) < parts) waves.push_back({other, kh});
  }
  return waves;
}

void rates_of(std::FILE* file, const BaseState& base) {
  struct Treatment {
    const char* name;
    FrictionModel model;
    double tau;
  };
  const std::vector<Treatment> treatments{{"none", FrictionModel::none, 1e-3},
                                          {"critical_state", FrictionModel::critical_state, 1e-3},
                                          {"instantaneous", FrictionModel::instantaneous, 1e-3},
                                          {"relaxed", FrictionModel::relaxed, 1e-4},
                                          {"relaxed", FrictionModel::relaxed, 1e-3},
                                          {"relaxed", FrictionModel::relaxed, 1e-1}};
  for (const Treatment& t : treatments)
    for (const AdvectionScheme scheme : schemes) {
      const Waves waves(t.model, t.tau, scheme, base);
      for (const double kh : {.05, .1, .2, .4, .7, 1., 1.5, 2., 2.5, pi}) {
        double greatest = -1e300;
        for (const Wave& wave : directions(kh)) greatest = std::max(greatest, waves.rate(wave));
        std::fprintf(file, "%s,%g,%s,%g,%s,%g,%.6g\n", base.name.c_str(), base.cell[0], t.name, t.tau, name_of(scheme),
                     kh, greatest);
      }
    }
}

void steps_of(std::FILE* file, const BaseState& base) {
  for (const AdvectionScheme scheme : schemes) {
    const LaggedWaves waves(scheme, base);
    std::vector<std::pair<double, LaggedWaves::Parts>> parts;
    for (const double kh : {pi / 8, pi / 4, pi / 2, pi})
      for (const Wave& wave : directions(kh)) parts.emplace_back(kh, waves.parts(wave));
    for (const double tau : {0., 1e-4, 1e-3, 1e-2, 1e-1})
      for (int half_decade = 0; half_decade <= 10; ++half_decade) {
        const double dt = 1e-7 * std::pow(10, 0.5 * half_decade);
        double most = 0, at = 0;
        for (const auto& [kh, wave] : parts) {
          const double factor = waves.factor(wave, tau, dt);
          if (factor > most) most = factor, at = kh;
        }
        std::fprintf(file, "%s,%g,%s,%g,%g,%.6g,%g\n", base.name.c_str(), base.cell[0], name_of(scheme), tau, dt, most,
                     at);
      }
  }
}

BaseState refined(BaseState base, double times) {
  for (double& size : base.cell) size /= times;
  return base;
}

std::vector<BaseState> base_states() {
  std::array<double, 10> x;
  int count = x.size();
  PetscBool given;
  check(PetscOptionsGetRealArray(nullptr, nullptr, "-given", x.data(), &count, &given));
  if (!given) return built_in();
  if (count != static_cast<int>(x.size())) throw std::runtime_error("-given: expected ten numbers");
  return {{"given", x[0], x[1], {x[2], x[3]}, {{{x[4], x[5]}, {x[6], x[7]}}}, {x[8], x[9]}}};
}

/// The file that `option` names.
std::FILE* opened(const char* option, const char* usual) {
  char name[PETSC_MAX_PATH_LEN];
  check(PetscStrncpy(name, usual, sizeof name));
  check(PetscOptionsGetString(nullptr, nullptr, option, name, sizeof name, nullptr));
  std::FILE* file = std::fopen(name, "w");
  if (!file) throw std::runtime_error("cannot write " + std::string(name));
  return file;
}

void write_tables() {
  std::FILE* rates = opened("-rates", "rates.csv");
  std::FILE* steps = opened("-steps", "steps.csv");
  std::fprintf(rates, "base,cell,friction,tau,advection,kh,rate\n");
  std::fprintf(steps, "base,cell,advection,tau,dt,factor,kh\n");
  for (const BaseState& base : base_states()) {
    for (const double times : {1., 4.}) rates_of(rates, refined(base, times));
    steps_of(steps, base);
  }
  std::fclose(rates);
  std::fclose(steps);
}

}  // namespace
}  // namespace scree::test

int main(int argc, char** argv) {
  if (PetscInitialize(&argc, &argv, nullptr, nullptr) != 0) return 1;
  try {
    scree::test::write_tables();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "flutter_growth: %s\n", error.what());
    return 1;
  }
  return PetscFinalize() == 0 ? 0 : 1;
}
