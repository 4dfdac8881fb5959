#include "scree/closures/wall.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "derivative_check.hpp"

namespace scree {
namespace {

const KineticParameters kinetic;

/// (25) and (26) at 40 digits (mpmath) with the parameters of Table 2.
struct WallRow {
  double nu, T, N, slip, coefficient, heat_flux;
};
TEST(Wall, ReferenceValues) {
  const WallParameters wall;
  const std::vector<WallRow> rows = {
      {.58, 1e-4, 100, .05, 592.708521137, .377315652837},
      {.58, 1e-4, 100, 0, 7425.26282861, -.0162363827815},
      {.3, 1e-4, 0, .02, 13.3568565781, .00396511644378},
      {.6, 0, 1600, .003, 82226.2459672, 0},
  };
  for (const WallRow& row : rows) {
    const double sqrt_T = std::sqrt(row.T), slip2 = row.slip * row.slip;
    EXPECT_NEAR(wall_traction_coefficient(row.nu, sqrt_T, row.N, slip2, kinetic, wall), row.coefficient,
                1e-8 * row.coefficient);
    EXPECT_NEAR(wall_heat_flux(row.nu, row.T, sqrt_T, slip2, kinetic, wall), row.heat_flux,
                1e-8 * std::abs(row.heat_flux));
  }
}

// T7, matched Couette: uniform shear at nu = 0.3, T = 1 cm2/s2 satisfies (25) and (26) at once.
TEST(Wall, MatchedCouette) {
  WallParameters wall;
  wall.specularity = .325926893308;
  const double nu = .3, T = 1e-4, sqrt_T = 1e-2, slip = .889453952528e-2, rate = 8.6320486966;
  const double traction = wall_traction_coefficient(nu, sqrt_T, 0.0, slip * slip, kinetic, wall) * slip;
  EXPECT_NEAR(traction, shear_viscosity(nu, sqrt_T, kinetic) * rate, 1e-8 * traction);
  const double loss = wall_heat_flux(nu, T, sqrt_T, 0.0, kinetic, wall);
  EXPECT_NEAR(wall_heat_flux(nu, T, sqrt_T, slip * slip, kinetic, wall), 0, 1e-8 * std::abs(loss));
  EXPECT_NEAR(dissipation(nu, T, sqrt_T, kinetic), traction * rate, 1e-8 * traction * rate);
}

TEST(Wall, CoulombFrictionIsReachedAtSlip) {
  WallParameters wall;
  wall.specularity = 0;
  const double slip = 10, N = 50;
  EXPECT_NEAR(wall_traction_coefficient(.6, .01, N, slip * slip, kinetic, wall) * slip, N * std::tan(wall.delta), 1e-5);
}

/// {traction coefficient, heat flux} of x = (nu, T, N, slip squared).
struct AllWall {
  template <class Number>
  std::array<Number, 2> operator()(const std::array<Number, 4>& x) const {
    const WallParameters wall;
    const Number sqrt_T = sqrt_temperature(x[1], 1e-14);
    return {wall_traction_coefficient(x[0], sqrt_T, x[2], x[3], kinetic, wall),
            wall_heat_flux(x[0], x[1], sqrt_T, x[3], kinetic, wall)};
  }
};

TEST(Wall, DerivativesMatchDifferences) {
  for (double nu : {.1, .58, .64})
    for (double slip : {1e-3, .05})
      testing::expect_derivatives_match(AllWall{}, std::array<double, 4>{nu, 1e-4, 80, slip * slip},
                                        {.65 - nu < nu ? .65 - nu : nu, 1e-4, 80, slip * slip},
                                        "nu " + std::to_string(nu) + " slip " + std::to_string(slip));
}

/// {share of the slip, sqrt(T)} at the wall of x = (nu, sqrt(T), N, slip squared, k, kappa_0).
struct AtWall {
  static constexpr double distance = 5e-4;
  template <class Number>
  std::array<Number, 2> operator()(const std::array<Number, 6>& x) const {
    const WallParameters wall;
    const Number collisions = wall.specularity * wall_collision_rate(x[0], x[1], kinetic, wall);
    return {wall_slip_share(x[4], x[2], collisions, x[3], wall),
            wall_sqrt_temperature(x[0], x[1], x[5], x[3], distance, kinetic, wall)};
  }
};

// What the wall takes is what shear and conduction bring across the distance; the extremes are a wall that holds on and
// one that does nothing.
TEST(AtWall, BalancesTheFluxes) {
  const WallParameters wall;
  for (const double nu : {.1, .58, .64})
    for (const double T : {1e-10, 1e-4, 1e-2})
      for (const double N : {0., 80., 1e5})
        for (const double slip : {1e-4, .05, 2.}) {
          const double root = std::sqrt(T), kappa_0 = conductivity(nu, 1.0, kinetic);
          const double k = shear_viscosity(nu, root, kinetic) / AtWall::distance;
          const auto [share, root_T] = AtWall{}(std::array<double, 6>{nu, root, N, slip * slip, k, kappa_0});
          const double w = share * slip;
          EXPECT_GT(share, 0);
          EXPECT_LE(share, 1);
          const double taken = w * (wall_traction_coefficient(nu, root, N, w * w, kinetic, wall));
          EXPECT_NEAR(taken, k * (slip - w), 1e-9 * k * slip);
          const double heat = wall_heat_flux(nu, root_T * root_T, root_T, slip * slip, kinetic, wall);
          const double conducted = 2. / 3 * kappa_0 * (std::pow(root_T, 3) - std::pow(root, 3)) / AtWall::distance;
          EXPECT_NEAR(heat, conducted, 1e-9 * kappa_0 * std::pow(root_T + root, 3) / AtWall::distance);
        }
}

TEST(AtWall, DerivativesMatchDifferences) {
  for (const double nu : {.1, .58})
    for (const double slip : {1e-3, .05}) {
      const double k = shear_viscosity(nu, .01, kinetic) / AtWall::distance, kappa_0 = conductivity(nu, 1.0, kinetic);
      const std::array<double, 6> x{nu, .01, 80, slip * slip, k, kappa_0};
      testing::expect_derivatives_match(AtWall{}, x, {.65 - nu < nu ? .65 - nu : nu, .01, 80, slip * slip, k, kappa_0},
                                        "nu " + std::to_string(nu) + " slip " + std::to_string(slip));
    }
}

TEST(AtWall, FiniteAtTheEdges) {  // H15; no viscosity: the wall takes nothing
  using D = Dual<6>;
  for (const double nu : {-1e-9, 0.0, 1e-12, .65 - 1e-9})
    for (const double root : {1e-7, .01})
      for (const double slip2 : {0.0, 1e-20, 1.0})
        for (const double N : {0.0, 1e8})
          for (const double k : {0.0, 1e-310, 1e-30, 1e9})
            for (const double kappa_0 : {0.0, 1e-20, 10.0}) {
              const std::array<double, 6> x{nu, root, N, slip2, k, kappa_0};
              std::array<D, 6> seeded;
              for (int i = 0; i < 6; ++i) seeded[i] = D::variable(x[i], i);
              std::ostringstream state;
              state << "nu " << nu << " root " << root << " slip2 " << slip2 << " N " << N << " k " << k;
              for (const D& y : AtWall{}(seeded)) testing::expect_finite(y, state.str());
            }
}

TEST(Wall, FiniteAtTheEdges) {  // H15
  using D = Dual<4>;
  for (double nu : {0.0, 1e-12, .65 - 1e-9})
    for (double T : {0.0, 1e-4})
      for (double slip2 : {0.0, 1e-20, 1.0}) {
        const auto result = AllWall{}(
            std::array<D, 4>{D::variable(nu, 0), D::variable(T, 1), D::variable(0, 2), D::variable(slip2, 3)});
        std::ostringstream state;
        state << "nu " << nu << " T " << T << " slip^2 " << slip2;
        for (const D& y : result) testing::expect_finite(y, state.str());
      }
}

}  // namespace
}  // namespace scree
