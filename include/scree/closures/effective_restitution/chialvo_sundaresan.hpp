/// Effective restitution of Chialvo & Sundaresan (2013), fitted to discrete elements.
#pragma once

#include <cmath>

namespace scree {

/// e - 3/2 mu exp(-3 mu), their eqs. (22), (23). Least at mu = 1/3; goes back to e for large mu, where grains roll.
struct ChialvoSundaresan {
  static constexpr const char *name = "chialvo_sundaresan",
                              *source = "Chialvo & Sundaresan (2013), Phys. Fluids 25, 070603, eqs. (22), (23)";

  static double e_eff(double e, double mu) { return e - 1.5 * mu * std::exp(-3 * mu); }
};

}  // namespace scree
