#include "scree/closures/drag.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "derivative_check.hpp"
#include "scree/closures/drag/drag_law.hpp"
#include "scree/closures/drag/wen_yu.hpp"

namespace scree {
namespace {

const GasParameters gas;  // Table 2
constexpr double rho_s = 2900, g = 9.81;

/// Root of a growing function.
template <class Function>
double bisect(const Function& f, double lower, double upper) {
  for (int i = 0; i < 200; ++i) {
    const double middle = (lower + upper) / 2;
    (f(middle) < 0 ? lower : upper) = middle;
  }
  return lower;
}

TEST(Drag, ZeroSlip) {  // tests/VERIFICATION.md section 1, g/(cm3 s)
  EXPECT_NEAR(drag_coefficient(.6, 0.0, 1e-3, gas), 2204, .5);
  EXPECT_NEAR(drag_coefficient(.6, 0.0, 1e-4, gas), 220.4e3, 50);
  const double exact = 18 * gas.mu_g / 1e-8 * .6 * std::pow(.4, -2.65);
  EXPECT_NEAR(drag_coefficient(.6, 0.0, 1e-4, gas), exact, 1e-6 * exact) << "up to the floor of Re";
  EXPECT_GT(drag_over_nu(0.0, 0.0, 1e-4, gas), 0);
  EXPECT_EQ(drag_coefficient(0.0, 1.0, 1e-4, gas), 0);
}

// (6) and (7) as printed.
TEST(Drag, BothBranches) {
  for (double nu : {.01, .3, .6})
    for (double d : {1e-4, 1e-3, 4e-3})
      for (double w : {1e-3, .1, 1.0, 20.0, 200.0}) {
        const double Re = gas.rho_g * (1 - nu) * d * w / gas.mu_g;
        if (Re > 950 && Re < 1050) continue;
        const double C_D = Re < 1000 ? 24 / Re * (1 + .15 * std::pow(Re, .687)) : .44;
        const double beta = .75 * C_D * gas.rho_g * (1 - nu) * nu * w / d * std::pow(1 - nu, -2.65);
        EXPECT_NEAR(drag_coefficient(nu, w * w, d, gas), beta, 1e-12 * beta) << "nu " << nu << " Re " << Re;
      }
}

TEST(Drag, BranchesJoinSmoothly) {
  const double step = .01;
  Dual<1> last = lone_sphere_factor(Dual<1>::variable(940, 0));
  for (double Re = 940 + step; Re < 1060; Re += step) {
    const Dual<1> next = lone_sphere_factor(Dual<1>::variable(Re, 0));
    ASSERT_NEAR(next.value - last.value, step * (next.derivative[0] + last.derivative[0]) / 2, 1e-7) << Re;
    ASSERT_NEAR(next.derivative[0], last.derivative[0], 1e-4) << Re;
    ASSERT_GT(next.derivative[0], 0) << Re;
    ASSERT_NEAR(next.value, Re < 1000 ? 1 + .15 * std::pow(Re, .687) : .44 / 24 * Re, .005 * next.value) << Re;
    last = next;
  }
}

// T9: -dp/dz = beta w/(1-nu), w = U/(1-nu); cgs.
struct BedRow {
  double U, gradient;
};
const std::vector<BedRow> bed = {{1, 91.602}, {5, 513.627}, {10, 1128.665}, {22, 2906.40}};

TEST(Drag, FixedBed) {
  const double nu = .6, d = 4e-4;
  for (const BedRow& row : bed) {
    const double w = .01 * row.U / (1 - nu), gradient = 10 * row.gradient;
    EXPECT_NEAR(drag_coefficient(nu, w * w, d, gas) * w / (1 - nu), gradient, 1e-5 * gradient) << "U " << row.U;
    EXPECT_NEAR(darcy_mobility(nu, gradient * gradient, 1e-6, d, gas) * gradient, w, 1e-5 * w) << "U " << row.U;
  }
}

// T10: the pressure drop of the bed is its weight less buoyancy.
struct FluidisationRow {
  double d, nu, U;  ///< cgs
};
TEST(Drag, MinimumFluidisation) {
  for (const FluidisationRow& row :
       std::vector<FluidisationRow>{{.04, .55, 22.268}, {.04, .58, 17.144}, {.04, .60, 14.200}, {.01, .58, 1.505}}) {
    const double weight = row.nu * (rho_s - gas.rho_g) * g;
    const auto excess = [&](double U) {
      const double w = U / (1 - row.nu);
      return drag_coefficient(row.nu, w * w, .01 * row.d, gas) * w / (1 - row.nu) - weight;
    };
    EXPECT_NEAR(bisect(excess, 1e-6, 10), .01 * row.U, 5.1e-6) << "d " << row.d << " nu " << row.nu;
    const double w = darcy_mobility(row.nu, weight * weight, 1e-6, .01 * row.d, gas) * weight;
    EXPECT_NEAR(w * (1 - row.nu), .01 * row.U, 5.1e-6) << "d " << row.d << " nu " << row.nu;
  }
  const auto excess = [](double nu) {  // at U = 22 cm/s; denser beds have the more drag
    const double w = .22 / (1 - nu);
    return drag_over_nu(nu, w * w, 4e-4, gas) * w / (1 - nu) - (rho_s - gas.rho_g) * g;
  };
  EXPECT_NEAR(bisect(excess, .4, .64), .551452, 1e-6);
}

// T11: beta w/nu = (rho_s - rho_g) g at nu = 0; cgs.
struct TerminalRow {
  double d, w;
};
TEST(Drag, TerminalVelocity) {
  for (const TerminalRow& row : std::vector<TerminalRow>{{.1, 726.4}, {.04, 321.24}, {.01, 61.835}}) {
    const auto excess = [&](double w) {
      return drag_over_nu(0.0, w * w, .01 * row.d, gas) * w - (rho_s - gas.rho_g) * g;
    };
    EXPECT_NEAR(bisect(excess, 1e-6, 100), .01 * row.w, 2e-5 * .01 * row.w) << "d " << row.d;
  }
}

/// {beta/nu, beta} of x = (nu, slip squared).
struct AllDrag {
  double d;
  template <class Number>
  std::array<Number, 2> operator()(const std::array<Number, 2>& x) const {
    return {drag_over_nu(x[0], x[1], d, gas), drag_coefficient(x[0], x[1], d, gas)};
  }
};

TEST(Drag, DerivativesMatchDifferences) {
  for (double d : {1e-4, 1e-3})
    for (double nu : {.01, .3, .6})
      for (double w : {1e-6, 1e-3, .3, 10.0, 13.85 / (1 - nu), 40.0}) {  // the fifth in the blend at d = 1 mm
        const double blend = d == 1e-3 ? .02 : 1;
        testing::expect_derivatives_match(AllDrag{d}, std::array<double, 2>{nu, w * w},
                                          {blend * std::min(nu, .65 - nu), blend * w * w},
                                          "nu " + std::to_string(nu) + " w " + std::to_string(w), 1e-7);
      }
}

TEST(Drag, FiniteAtTheEdges) {  // H15
  using D = Dual<2>;
  for (double d : {1e-4, 1e-3})
    for (double nu : {0.0, 1e-12, .6, .65 - 1e-9})
      for (double slip2 : {0.0, 1e-30, 1e-12, 1.0, 1e4}) {
        const auto result = AllDrag{d}(std::array<D, 2>{D::variable(nu, 0), D::variable(slip2, 1)});
        std::ostringstream state;
        state << "nu " << nu << " slip^2 " << slip2;
        for (const D& y : result) testing::expect_finite(y, state.str());
        EXPECT_GT(result[0].value, 0) << state.str();
        // The force beta w by w: at zero slip beta itself, whatever the derivative of beta by the squared slip.
        const Dual<1> w = Dual<1>::variable(std::sqrt(slip2), 0);
        const Dual<1> force = drag_over_nu(Dual<1>(nu), w * w, d, gas) * w;
        EXPECT_GE(force.derivative[0], result[0].value) << state.str();
        EXPECT_LE(force.derivative[0], 2.01 * result[0].value) << state.str();
      }
}

TEST(Darcy, SatisfiesItsEquation) {
  const double floor = 1e-4;
  for (double d : {1e-4, 1e-3, 5e-3})
    for (double nu : {0.0, 1e-6, .01, .3, .6, .65 - 1e-9})
      for (double gradient = 1e-12; gradient < 1e9; gradient *= 1.7) {
        const double mobility = darcy_mobility(nu, gradient * gradient, floor, d, gas);
        const double slip2 = darcy_slip_squared(nu, gradient * gradient, floor, d, gas);
        const double beta = drag_coefficient(std::sqrt(nu * nu + floor * floor), slip2, d, gas);
        ASSERT_NEAR(mobility * beta, 1 - nu, 1e-13) << "d " << d << " nu " << nu << " gradient " << gradient;
        ASSERT_NEAR(beta * std::sqrt(slip2), (1 - nu) * gradient, 1e-13 * gradient)
            << "d " << d << " nu " << nu << " gradient " << gradient;
      }
}

TEST(Darcy, StokesLimit) {
  const double mobility = .4 / (18 * gas.mu_g / 1e-8 * .6 * std::pow(.4, -2.65));
  EXPECT_NEAR(darcy_mobility(.6, 0.0, 1e-6, 1e-4, gas), mobility, 1e-6 * mobility);
  EXPECT_EQ(darcy_slip_squared(.6, 0.0, 1e-6, 1e-4, gas), 0);
  const Dual<1> slip2 = darcy_slip_squared(Dual<1>(.6), Dual<1>::variable(0, 0), 1e-6, 1e-4, gas);
  EXPECT_NEAR(slip2.derivative[0], mobility * mobility, 2e-6 * mobility * mobility);
  GasParameters light;
  light.rho_g = 0;
  EXPECT_NEAR(darcy_mobility(.6, 1e6, 1e-6, 1e-4, light), mobility, 1e-6 * mobility) << "at any slip";
}

/// {mobility, slip squared} of x = (nu, gradient squared).
struct AllDarcy {
  double d, floor;
  template <class Number>
  std::array<Number, 2> operator()(const std::array<Number, 2>& x) const {
    return {darcy_mobility(x[0], x[1], floor, d, gas), darcy_slip_squared(x[0], x[1], floor, d, gas)};
  }
};

TEST(Darcy, DerivativesMatchDifferences) {
  for (double d : {1e-4, 1e-3})
    for (double nu : {.01, .3, .6})
      for (double gradient : {1e-4, 1.0, 100.0, 1e4, 1e6})
        testing::expect_derivatives_match(AllDarcy{d, 1e-3}, std::array<double, 2>{nu, gradient * gradient},
                                          {std::min(nu, .65 - nu), gradient * gradient},
                                          "nu " + std::to_string(nu) + " gradient " + std::to_string(gradient), 1e-7);
}

TEST(Darcy, DerivativesWhereTheBranchesJoin) {  // Re = 1000
  const double nu = .3, d = 1e-3, w = 1000 * gas.mu_g / (gas.rho_g * (1 - nu) * d);
  const double gradient = drag_coefficient(nu, w * w, d, gas) * w / (1 - nu);
  testing::expect_derivatives_match(AllDarcy{d, 1e-6}, std::array<double, 2>{nu, gradient * gradient},
                                    {.02 * nu, .02 * gradient * gradient}, "Re 1000", 1e-6);
}

TEST(Darcy, FiniteAtTheEdges) {  // H15
  using D = Dual<2>;
  for (double d : {1e-4, 1e-3})
    for (double nu : {-1e-9, 0.0, 1e-12, .6, .65 - 1e-9})
      for (double gradient2 : {0.0, 1e-30, 1e-12, 1.0, 1e10}) {
        const auto result = AllDarcy{d, 1e-4}(std::array<D, 2>{D::variable(nu, 0), D::variable(gradient2, 1)});
        std::ostringstream state;
        state << "nu " << nu << " gradient^2 " << gradient2;
        for (const D& y : result) testing::expect_finite(y, state.str());
        EXPECT_GT(result[0].value, 0) << state.str();
        EXPECT_GT(result[1].derivative[1], 0) << state.str();
      }
}

}  // namespace
}  // namespace scree
