/// Correlation length of Jenkins (2006, 2007) in steady shear.
#pragma once

#include "scree/closures/kinetic.hpp"
#include "scree/math/rounded.hpp"

namespace scree {

/// L = (c/2) (nu g0)^(1/3) d^2 gdot/sqrt(T), where production and dissipation in simple shear give gdot: with
/// (d gdot)^2 = T J/(mu_s L/d) by the factors J of (1.4) and mu_s of (1.1) it is
///     L/d = max{1, [(c/2)^2 (nu g0)^(2/3) J/mu_s]^(1/3)},
/// a function of state. In the dense limit this is [15 c^2/4 (1 - e)/J']^(1/3) (nu g0)^(2/9) with J' of Jenkins.
struct JenkinsLength {
  static constexpr const char *name = "jenkins",
                              *source = "Jenkins (2007), Granul. Matter 10, 47, with the gdot of steady shear";

  template <class Number>
  static Number ratio(const Number& nu, const KineticParameters& p) {
    if (!(nu > 0.0) || nu >= p.nu_max) return Number(1.0);
    const Number g0 = radial_distribution(nu, p), G = nu * g0;
    const Number loss = collision_dissipation_factor(nu, g0, p) / shear_factor(nu, g0, p);
    if (!(loss > 0.0)) return Number(1.0);  // elastic
    const double half = p.length_constant / 2;
    const Number ratio = cbrt(half * half * loss) * pow(G, 2.0 / 9);
    return rounded_maximum(ratio, 1, correlation_rounding);
  }
};

}  // namespace scree
