/// Correlation length of Berzi & Vescovi (2015).
#pragma once

#include "scree/closures/kinetic.hpp"
#include "scree/math/rounded.hpp"

namespace scree {

/// max{1, sqrt(2 J/(15 (1 - e_eff^2))) [1 + 26/15 (1 - e_eff) (nu - 0.49)/(nu_max - nu)]^(3/2)} above the freezing
/// point nu = 0.49, with nu_max for the random close packing of the paper. The law says nothing of looser states, where
/// nearly elastic spheres would keep an L above d: there it fades out down to nu = 0.40.
struct BerziVescovi {
  static constexpr const char *name = "berzi_vescovi", *source = "Berzi & Vescovi (2015), Phys. Fluids 27, 013302";
  static constexpr double freezing = .49, loose = .40;

  template <class Number>
  static Number ratio(const Number& nu, const KineticParameters& p) {
    if (nu <= loose || nu >= p.nu_max) return Number(1.0);
    const double e_eff = dissipation_restitution(p);
    if (!(e_eff < 1)) return Number(1.0);
    const Number law = unbounded(nu, Number(nu * radial_distribution(nu, p)), p.e_p, e_eff, p.nu_max);
    const Number ratio = rounded_maximum(law, 1, correlation_rounding);
    if (nu >= freezing) return ratio;
    const Number t = (nu - loose) / (freezing - loose);
    return 1.0 + t * t * (3.0 - 2.0 * t) * (ratio - 1.0);
  }

  /// What max{1, .} takes, of G = nu g0.
  template <class Number>
  static Number unbounded(const Number& nu, const Number& G, double e, double e_eff, double nu_rcp) {
    const double scale = std::sqrt(2 / (15 * (1 - e_eff * e_eff)));
    const Number chain = 1.0 + (26 * (1 - e_eff) / 15) * (nu - freezing) / (nu_rcp - nu);
    return scale * sqrt(shear_stress_factor(G, e)) * chain * sqrt(chain);
  }

  /// J of the shear stress 8 J nu G/(5 sqrt(pi)) rho_s d sqrt(T) gdot, Garzo & Dufty (1999).
  template <class Number>
  static Number shear_stress_factor(const Number& G, double e) {
    const Number kinetic = (5.0 + 2 * (1 + e) * (3 * e - 1) * G) * (5.0 + 4 * (1 + e) * G) / (G * G);
    return (1 + e) / 2 + pi / 32 / (24 - 6 * (1 - e) * (1 - e) - 5 * (1 - e * e)) * kinetic;
  }
};

}  // namespace scree
