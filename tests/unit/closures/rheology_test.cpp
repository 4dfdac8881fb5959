#include "scree/closures/rheology.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "derivative_check.hpp"
#include "scree/closures/solids_closures.hpp"

namespace scree {
namespace {

TEST(FrictionModels, AreListed) {
  std::vector<std::string> names;
  for (const FrictionModel model : friction_models()) names.push_back(model->name);
  EXPECT_EQ(names, (std::vector<std::string>{"none", "critical_state", "instantaneous", "relaxed"}));
  EXPECT_FALSE(FrictionModel::none->has_friction);
  for (const FrictionModel model : friction_models())
    EXPECT_EQ(model->has_unknown, model == FrictionModel::relaxed) << model->name;
  EXPECT_TRUE(FrictionModel::relaxed->uses_flow_rule);
  EXPECT_TRUE(FrictionModel::instantaneous->uses_flow_rule);
  EXPECT_FALSE(FrictionModel::critical_state->uses_flow_rule);
  EXPECT_FALSE(FrictionModel::none->uses_flow_rule);
}

/// A rheology that src/ does not know: mu(I) of Jop, Forterre & Pouliquen (2006) on p_c.
struct MuOfI {
  static constexpr const char *name = "mu_of_i", *source = "Jop, Forterre & Pouliquen (2006)";
  static constexpr bool has_friction = true, has_unknown = false, uses_flow_rule = false;
  static constexpr double mu_s = .38, mu_2 = .64, I_0 = .28, rho_s = 2900;

  template <class Number>
  static FrictionalStress<Number> stress(const FrictionalPoint<Number>& q, const FrictionParameters& p) {
    if (q.p_c == 0.0) return {Number(0.0), Number(0.0)};
    const Number rate = sqrt(2.0 * q.S_S + p.strain_rate_floor * p.strain_rate_floor);
    const Number I = rate * p.d / sqrt(q.p_c / rho_s);
    return {q.p_c, (mu_s + (mu_2 - mu_s) * I / (I_0 + I)) * q.p_c / rate};
  }

  template <class Number>
  static Number steady(const FrictionalPoint<Number>&, const FrictionParameters&) {
    return Number(1.0);
  }
};

/// cell_closure and edge_closure of x = (nu, T, chi, div_v, S_S).
struct AllStress {
  SolidsParameters p;
  template <class Number>
  std::array<Number, 3> operator()(const std::array<Number, 5>& x) const {
    const auto cell = cell_closure(x[0], x[1], x[2], x[3], x[4], Number(0.0), p);
    return {cell[CellClosure::pressure], cell[CellClosure::viscosity],
            edge_closure(x[0], critical_pressure(x[0], p.friction), x[1], x[2], x[3], x[4], Number(0.0), p)};
  }
};

TEST(FrictionModels, TakeOneFromOutside) {
  SolidsParameters p, none;
  p.friction.model = FrictionModel(rheology<MuOfI>);
  none.friction.model = FrictionModel::none;
  const double nu = .58, S_S = 50, p_c = 190.39685845, rate = 10, I = rate * 1e-3 / std::sqrt(p_c / 2900);
  const double tau = p_c * (.38 + .26 * I / (.28 + I));
  const auto with = cell_closure(nu, 1e-4, 1.0, 1.0, S_S, 0.0, p),
             kinetic = cell_closure(nu, 1e-4, 1.0, 1.0, S_S, 0.0, none);
  EXPECT_NEAR(with[CellClosure::frictional_pressure], p_c, 1e-7);
  EXPECT_NEAR(with[CellClosure::frictional_viscosity] * rate, tau, 1e-6);
  EXPECT_DOUBLE_EQ(with[CellClosure::viscosity],
                   kinetic[CellClosure::viscosity] + with[CellClosure::frictional_viscosity]);
  EXPECT_DOUBLE_EQ(edge_closure(nu, critical_pressure(nu, p.friction), 1e-4, 1.0, 1.0, S_S, 0.0, p),
                   with[CellClosure::viscosity]);
  testing::expect_derivatives_match(AllStress{p}, std::array<double, 5>{nu, 1e-4, .9, 1, S_S}, {.07, 1e-4, .03, 1, S_S},
                                    "mu(I)", 1e-7);
}

}  // namespace
}  // namespace scree
