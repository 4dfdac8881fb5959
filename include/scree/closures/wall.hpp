/// Wall laws of Johnson & Jackson (1987), eqs. (25) and (26).
#pragma once

#include "scree/closures/kinetic.hpp"

namespace scree {

/// Parameters of the wall laws (SI units).
struct WallParameters {
  double delta = 0.21467549799530256;  ///< angle of wall friction [rad], 12.3 deg
  double specularity = 0.25;           ///< phi' [-]
  double e_w = 0.91;                   ///< particle-wall restitution [-]
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

/// n.q of (26), n from the wall into the particles: slip work minus inelastic loss [W/m2].
template <class Number>
Number wall_heat_flux(const Number& nu, const Number& T, const Number& sqrt_T, const Number& slip_speed_squared,
                      const KineticParameters& kinetic, const WallParameters& wall) {
  return wall_collision_rate(nu, sqrt_T, kinetic, wall) *
         (wall.specularity * slip_speed_squared - 1.5 * (1 - wall.e_w * wall.e_w) * T);
}

}  // namespace scree
