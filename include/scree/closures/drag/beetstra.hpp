/// Drag of Beetstra, van der Hoef & Kuipers (2007), from lattice-Boltzmann simulations of random arrays of spheres.
#pragma once

#include "scree/math/dual.hpp"

namespace scree {

/// Equal spheres. The paper's F is the drag over 3 pi mu_g d (1-nu) |u - v|: beta = 18 mu_g nu (1-nu) F/d^2, so that
/// the factor here is (1-nu) F. Limits: 10 nu/(1-nu) + (1-nu)^3 (1 + 1.5 sqrt(nu)) as Re -> 0;
/// 0.413/24 Re (1/(1-nu) + 3 nu (1-nu))/(1-nu) as Re grows.
/// sqrt(nu) has an infinite slope at nu = 0, here limited as nu/sqrt(nu + 1e-7) (relative change of F: 6e-7 at
/// nu = 0.01, less above).
struct Beetstra {
  static constexpr const char *name = "beetstra",
                              *source = "Beetstra, van der Hoef & Kuipers (2007), AIChE J. 53, 489, equal spheres";

  template <class Number>
  static Number factor(const Number& nu, const Number& Re) {
    constexpr double void_width = 1e-7, log_10 = 2.302585092994045684;
    const Number gas = 1.0 - nu, root = nu / sqrt(nu + void_width), log_Re = log(Re);
    const Number creeping = 10.0 * nu / gas + gas * gas * gas * (1.0 + 1.5 * root);
    const Number inertial = (1.0 / gas + 3.0 * nu * gas + 8.4 * exp(-.343 * log_Re)) /
                            (1.0 + exp(3 * log_10 * nu - (.5 + 2.0 * nu) * log_Re));
    return creeping + .413 / 24 * Re / gas * inertial;
  }
};

}  // namespace scree
