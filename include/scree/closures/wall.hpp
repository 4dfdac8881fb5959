/// Wall laws of Johnson & Jackson (1987), eqs. (25) and (26).
#pragma once

#include <algorithm>

#include "scree/closures/kinetic.hpp"

namespace scree {

/// Parameters of the wall laws (SI units).
struct WallParameters {
  double delta = 0.21467549799530256;  ///< angle of wall friction [rad], 12.3 deg
  double specularity = 0.25;           ///< phi' [-]
  double e_w = 0.91;                   ///< particle-wall restitution [-]
  double mu_w = 0;                     ///< coefficient of friction in collisions with the wall, in (26) alone [-]
  double nu_max = 0.65;                ///< maximum solids packing [-]
  double slip_regularisation = 3e-3;   ///< v_e of v_sl/sqrt(v_sl^2 + v_e^2) in Coulomb friction [m/s]
};

/// pi sqrt(3)/(6 nu_max) rho_s nu g0 sqrt(T), common to (25) and (26) [kg/(m2 s)].
template <class Number>
Number wall_collision_rate(const Number& nu, const Number& sqrt_T, const KineticParameters& kinetic,
                           const WallParameters& wall) {
  return (pi * std::sqrt(3.0) / (6 * wall.nu_max) * kinetic.rho_s) * (nu * radial_distribution(nu, kinetic) * sqrt_T);
}

/// c of (25) such that the shear traction of the wall on the particles is -c v_sl [kg/(m2 s)].
/// N = normal . sigma_f . normal [Pa] is the frictional normal stress. The Coulomb part N tan(delta) v_sl/|v_sl| is
/// regularised as v_sl/sqrt(v_sl^2 + v_e^2): without slip there would be no law.
template <class Number>
Number wall_traction_coefficient(const Number& nu, const Number& sqrt_T, const Number& N,
                                 const Number& slip_speed_squared, const KineticParameters& kinetic,
                                 const WallParameters& wall) {
  const double v_e_squared = wall.slip_regularisation * wall.slip_regularisation;
  return std::tan(wall.delta) * N / sqrt(slip_speed_squared + v_e_squared) +
         wall.specularity * wall_collision_rate(nu, sqrt_T, kinetic, wall);
}

/// 1 - e^2 of (26), e being e_w or, with friction in collisions, the effective restitution of the case [-].
inline double wall_inelasticity(const KineticParameters& kinetic, const WallParameters& wall) {
  const double e = wall.mu_w == 0 ? wall.e_w : kinetic.e_eff->e_eff(wall.e_w, wall.mu_w);
  return 1 - e * e;
}

/// n.q of (26), n from the wall into the particles: slip work minus inelastic loss [W/m2].
template <class Number>
Number wall_heat_flux(const Number& nu, const Number& T, const Number& sqrt_T, const Number& slip_speed_squared,
                      const KineticParameters& kinetic, const WallParameters& wall) {
  return wall_collision_rate(nu, sqrt_T, kinetic, wall) *
         (wall.specularity * slip_speed_squared - 1.5 * wall_inelasticity(kinetic, wall) * T);
}

// ---- from the centre of the cell beside a wall to the wall ----

/// Slip at the wall over slip at a distance from it (0 to 1): what (25) takes, c w, is what shear brings across the
/// distance, k (s - w), with k = viscosity/distance [kg/(m2 s)]. s = slip at the distance, its square given;
/// `collisions` = specularity times wall_collision_rate. By Newton's method from 0, where it comes up to the root.
template <class Number>
Number wall_slip_share(const Number& k, const Number& N, const Number& collisions, const Number& slip_speed_squared,
                       const WallParameters& wall) {
  const double tangent = std::tan(wall.delta), v_e_squared = wall.slip_regularisation * wall.slip_regularisation;
  constexpr double nothing = 1e-30;  // far above where its inverse overflows [kg/(m2 s)]
  const auto excess = [&](const auto& share, const auto& k_, const auto& N_, const auto& collisions_, const auto& s2) {
    return share * (tangent * N_ / sqrt(share * share * s2 + v_e_squared) + collisions_) - k_ * (1.0 - share);
  };
  Dual<1> share = Dual<1>::variable(0, 0), f;
  for (int iteration = 0; iteration < 50; ++iteration) {
    f = excess(share, value_of(k), value_of(N), value_of(collisions), value_of(slip_speed_squared));
    if (!(f.derivative[0] > nothing)) return Number(1.0);  // neither wall nor shear does anything
    const double step = -f.value / f.derivative[0];
    share.value += step;
    if (!(std::abs(step) > 1e-15)) break;
  }
  return share.value - excess(Number(share.value), k, N, collisions, slip_speed_squared) / f.derivative[0];
}

/// sqrt(T) at the wall such that (26) is what conduction brings across a distance [m/s], from sqrt(T) there. With a
/// conductivity kappa_0 sqrt(T) the flux is 2/3 kappa_0 (T_w^(3/2) - T^(3/2))/distance: a cubic with one positive root,
/// which Newton's method reaches from above. `slip_speed_squared` is that at the wall.
template <class Number>
Number wall_sqrt_temperature(const Number& nu, const Number& sqrt_T, const Number& kappa_0,
                             const Number& slip_speed_squared, double distance, const KineticParameters& kinetic,
                             const WallParameters& wall) {
  const Number rate = distance * wall_collision_rate(nu, Number(1.0), kinetic, wall), conduction = 2.0 / 3 * kappa_0;
  const Number A = conduction + 1.5 * wall_inelasticity(kinetic, wall) * rate;
  const Number B = wall.specularity * slip_speed_squared * rate;
  const Number C = conduction * sqrt_T * sqrt_T * sqrt_T;
  const double a = value_of(A), b = value_of(B), c = value_of(C);
  constexpr double nothing = 1e-150;  // where c goes to rounding and its quotients overflow: nu of 1e-315 exists
  if (!(c > nothing)) return sqrt_T;
  double x = std::sqrt(std::max(b, 0.0) / a) + std::cbrt(c / a), slope = 0;  // b < 0 where nu is, by rounding
  for (int iteration = 0; iteration < 50; ++iteration) {
    slope = 3 * a * x * x - b;
    const double step = (a * x * x * x - b * x - c) / slope;
    x -= step;
    if (!(std::abs(step) > 1e-15 * x)) break;
  }
  return x - (A * (x * x * x) - B * x - C) / slope;
}

}  // namespace scree
