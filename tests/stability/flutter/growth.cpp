/// H8: growth rates of waves about base states, for each way of treating chi, as a table (growth.csv): what the model
/// says (time continuous), and what a segregated treatment makes of it (chi from the state before the step).
///
///     flutter_growth [-table growth.csv]
#include <slepcsys.h>

#include <cstdio>

#include "symbol.hpp"

namespace scree::test {
namespace {

constexpr int angles = 24;
const std::vector<double> wave_numbers{0.05, 0.1, 0.2, 0.4, 0.6, 0.8, 1.0, 1.3, 1.6, 2.0, 2.4, 2.8, pi};
const std::vector<double> taus{1e-4, 1e-3, 1e-2, 1e-1};

/// A way of treating chi.
struct Treatment {
  std::string name;
  FrictionModel model;
  double tau = 1e-3;
  bool lagged = false;
  double dt = 0;  ///< of a lagged treatment; 0: continuous in time [s]
};

std::vector<Treatment> treatments() {
  std::vector<Treatment> list{{"none", FrictionModel::none},
                              {"critical_state", FrictionModel::critical_state},
                              {"instantaneous", FrictionModel::instantaneous}};
  for (const double tau : taus) list.push_back({"relaxed", FrictionModel::relaxed, tau});
  for (const double dt : {1e-6, 1e-5, 1e-4, 1e-3}) {
    list.push_back({"lagged instantaneous", FrictionModel::relaxed, 0, true, dt});
    for (const double tau : taus) list.push_back({"lagged relaxed", FrictionModel::relaxed, tau, true, dt});
  }
  return list;
}

ProblemSetup setup_of(const Treatment& t, AdvectionScheme scheme, const BaseState& base) {
  Box box = uniform_box(2, {4, 4, 1});
  ProblemSetup setup = sample_setup(box, t.model, TemperatureModel::transport, scheme);
  setup.model.gravity = {0, -9.81, 0};
  setup.solids.friction.tau = t.tau > 0 ? t.tau : 1e-3;
  setup.solids.friction.lagged = t.lagged;
  (void)base;
  return setup;
}

/// Growth rates of all waves about one base state with one treatment.
class Growth {
 public:
  Growth(const Treatment& t, AdvectionScheme scheme, const BaseState& base)
      : treatment_(t), symbol_(setup_of(t, scheme, base), base) {
    if (!t.lagged) return;
    for (const double tau : {1e-3, 2e-3}) {  // two times of relaxation tell chi* from the rest of its row
      Treatment free{"", FrictionModel::relaxed, tau};
      free_.push_back(Symbol(setup_of(free, scheme, base), base));
    }
  }

  /// Of the fastest growing wave exp(i k.x) [1/s].
  double rate(const std::array<double, 2>& kh) const {
    double greatest = -1e300;
    if (!treatment_.lagged) {
      Matrix A = symbol_.state_part(kh);
      for (Complex& entry : A.entry) entry = -entry;
      for (const Complex& lambda : eigenvalues(A, symbol_.rate_part(kh))) greatest = std::max(greatest, lambda.real());
      return greatest;
    }
    double most = 0;
    Matrix after = symbol_.state_part(kh), before = symbol_.rate_part(kh);
    for (std::size_t k = 0; k < after.entry.size(); ++k) {
      before.entry[k] /= treatment_.dt;
      after.entry[k] += before.entry[k];
    }
    for (const Complex& factor : eigenvalues(with_new_chi(before, kh), after)) most = std::max(most, std::abs(factor));
    return std::log(most) / treatment_.dt;
  }

 private:
  /// before * P, P being what the lagged step does to chi before it solves for the rest.
  Matrix with_new_chi(const Matrix& before, const std::array<double, 2>& kh) const {
    const int n = before.size, chi = symbol_.chi();
    const double share = treatment_.dt / (treatment_.dt + treatment_.tau);
    const Matrix one = free_[0].state_part(kh), two = free_[1].state_part(kh), rate = free_[0].rate_part(kh);
    Matrix result = before;
    for (int j = 0; j < n; ++j) {
      const Complex towards = -(one(chi, j) - two(chi, j)) / (rate(chi, chi) * (1 / 1e-3 - 1 / 2e-3));
      for (int i = 0; i < n; ++i) result(i, j) += before(i, chi) * share * towards;
    }
    return result;
  }

  Treatment treatment_;
  Symbol symbol_;
  std::vector<Symbol> free_;
};

/// Plane shear with the granular temperature that it keeps up; the plug high up in the bin as it begins to dilate; the
/// converging flow above the orifice. The last two are those of the bin on the paper's grid (1 mm particles).
std::vector<BaseState> base_states() {
  const std::array<double, 2> h{1e-3, 2e-3};
  return {{"shear", .58, 1.1e-4, {.05, -.05}, {{{0, 10}, {0, 0}}}, h},
          {"plug", .60, 1e-6, {0, -.12}, {{{.01, .02}, {.02, .01}}}, h},
          {"plug compacting", .60, 1e-6, {0, -.12}, {{{-.01, .02}, {.02, -.01}}}, h},
          {"orifice", .56, 4e-3, {-.05, -.4}, {{{-14, 10}, {8, 20}}}, h}};
}

void write_rows(std::FILE* file, const BaseState& base, const Treatment& t, AdvectionScheme scheme) {
  const Growth growth(t, scheme, base);
  for (const double kh : wave_numbers) {
    double greatest = -1e300, angle = 0;
    for (int k = 0; k < angles; ++k) {
      const double theta = pi * k / angles;
      const double rate = growth.rate({kh * std::cos(theta), kh * std::sin(theta)});
      if (rate > greatest) greatest = rate, angle = theta;
    }
    std::fprintf(file, "%s,%g,%s,%g,%s,%g,%g,%g,%.6g\n", base.name.c_str(), base.cell[0], t.name.c_str(), t.tau,
                 scheme == AdvectionScheme::upwind ? "upwind" : "van_albada", t.dt, kh, angle * 180 / pi, greatest);
  }
}

void write_table(std::FILE* file) {
  std::fprintf(file, "base,cell,treatment,tau,advection,dt,kh,angle,growth\n");
  for (BaseState base : base_states())
    for (const double refinement : {1., 2., 4., 8.}) {
      BaseState refined = base;
      for (double& size : refined.cell) size /= refinement;
      for (const Treatment& t : treatments()) {
        if (refinement > 1 && t.lagged) continue;
        for (const AdvectionScheme scheme : {AdvectionScheme::upwind, AdvectionScheme::van_albada})
          write_rows(file, refined, t, scheme);
      }
    }
}

}  // namespace
}  // namespace scree::test

int main(int argc, char** argv) {
  if (SlepcInitialize(&argc, &argv, nullptr, nullptr) != 0) return 1;
  char name[PETSC_MAX_PATH_LEN] = "growth.csv";
  (void)PetscOptionsGetString(nullptr, nullptr, "-table", name, sizeof name, nullptr);
  std::FILE* file = std::fopen(name, "w");
  if (!file) {
    std::fprintf(stderr, "flutter_growth: cannot write %s\n", name);
    return 1;
  }
  scree::test::write_table(file);
  std::fclose(file);
  return SlepcFinalize() == 0 ? 0 : 1;
}
