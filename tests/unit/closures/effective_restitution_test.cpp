/// Friction between particles: effective restitution in the dissipation (1.4) and in the wall law (26).
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "derivative_check.hpp"
#include "scree/closures/effective_restitution/chialvo_sundaresan.hpp"
#include "scree/closures/effective_restitution/jenkins_zhang.hpp"
#include "scree/closures/kinetic.hpp"
#include "scree/closures/wall.hpp"

namespace scree {
namespace {

TEST(EffectiveRestitution, IsListed) {
  std::vector<std::string> names;
  for (const EffectiveRestitution* form : effective_restitutions()) names.push_back(form->name);
  EXPECT_EQ(names, (std::vector<std::string>{"chialvo_sundaresan", "jenkins_zhang"}));
  EXPECT_EQ(KineticParameters{}.e_eff, effective_restitutions().front());
}

/// The published equations with 40 digits (mpmath), e = 0.91.
struct Row {
  double mu, chialvo_sundaresan, jenkins_zhang;
};
const std::vector<Row> rows = {
    {.02, .8817470639925, .8803807696216}, {.1, .7988772668977, .7933299865866}, {.3, .7270436531167, .6988276150784},
    {.5, .7426523798887, .6739873141651},  {1, .8353193974482, .6605639083879},
};

TEST(EffectiveRestitution, ReferenceValues) {
  for (const Row& row : rows) {
    EXPECT_NEAR(ChialvoSundaresan::e_eff(.91, row.mu), row.chialvo_sundaresan, 1e-12) << "mu " << row.mu;
    EXPECT_NEAR(JenkinsZhang::e_eff(.91, row.mu), row.jenkins_zhang, 1e-12) << "mu " << row.mu;
  }
}

TEST(EffectiveRestitution, IsTheRestitutionWithoutFriction) {
  for (const EffectiveRestitution* form : effective_restitutions()) {
    EXPECT_EQ(form->e_eff(.91, 0), .91) << form->name;
    EXPECT_NEAR(form->e_eff(.91, 1e-9), .91, 1e-8) << form->name;
  }
}

// (1 - e_eff^2)/(1 - e^2) at e = 0.91, mu = 0.3, and T/(d gdot)^2 = 1.10920688 of simple shear at nu = 0.55 over it.
TEST(EffectiveRestitution, ActsOnTheDissipationAlone) {
  const KineticParameters smooth;
  KineticParameters rough;
  rough.mu_p = .3;
  const double nu = .55, g0 = radial_distribution(nu, rough);
  EXPECT_NEAR(dissipation_factor(nu, g0, rough) / dissipation_factor(nu, g0, smooth), 2.74233581421, 1e-10);
  const auto with = kinetic_factors<factors_with_gas>(nu, rough),
             without = kinetic_factors<factors_with_gas>(nu, smooth);
  for (const KineticFactor f : {factor_pressure, factor_bulk, factor_shear, factor_g0, factor_streaming})
    EXPECT_EQ(with[f], without[f]) << f;
  EXPECT_EQ(conductivity(nu, .01, rough), conductivity(nu, .01, smooth));

  const double rate = 10, s = algebraic_sqrt_temperature(nu, 0.0, rate * rate / 2, rough, 1e-16);
  EXPECT_NEAR(s * s / (rough.d * rough.d * rate * rate), .404475220678, 1e-9);
  rough.e_eff = &effective_restitution_entry<JenkinsZhang>;
  EXPECT_NEAR(dissipation_factor(nu, g0, rough) / dissipation_factor(nu, g0, smooth), 2.97638141014, 1e-10);
}

// (26): slip work less 3/2 (1 - e^2) T, in units of wall_collision_rate; and T at the wall is that of e_eff given as
// e_w.
TEST(EffectiveRestitution, OfAWallActsOnTheLossAlone) {
  const KineticParameters kinetic;
  WallParameters wall, as_if;
  wall.mu_w = .3;
  as_if.e_w = rows[2].chialvo_sundaresan;
  const double nu = .58, T = 1e-4, root = 1e-2, rate = wall_collision_rate(nu, root, kinetic, wall);
  for (const double slip : {0.0, .05})
    EXPECT_NEAR(wall_heat_flux(nu, T, root, slip * slip, kinetic, wall) / rate,
                .25 * slip * slip - 1.5 * (1 - .7270436531167 * .7270436531167) * T, 1e-15);
  EXPECT_NEAR(wall_sqrt_temperature(nu, root, 3.0, 1e-4, 5e-4, kinetic, wall),
              wall_sqrt_temperature(nu, root, 3.0, 1e-4, 5e-4, kinetic, as_if), 1e-14);
  EXPECT_EQ(wall_traction_coefficient(nu, root, 80.0, 1e-4, kinetic, wall),
            wall_traction_coefficient(nu, root, 80.0, 1e-4, kinetic, WallParameters{}));
}

}  // namespace
}  // namespace scree
