/// Effective restitution of Jenkins & Zhang (2002), from theory: the rotation of nearly elastic spheres in balance.
#pragma once

#include <cmath>

#include "scree/math/constants.hpp"

namespace scree {

/// e - (a1 - a2 b1/b2)/2 for a tangential restitution of 0, where mu0 = 7/2 mu (1 + e) bounds sliding contacts.
/// b1/b2 is the ratio of the rotational temperature to T.
struct JenkinsZhang {
  static constexpr const char *name = "jenkins_zhang",
                              *source = "Jenkins & Zhang (2002), Phys. Fluids 14, 1228, tangential restitution 0";

  static double e_eff(double e, double mu) {
    if (mu == 0) return e;
    const double mu0 = 3.5 * mu * (1 + e), ratio = mu / mu0, square = mu0 * mu0, one = 1 + square;
    const double sticking = pi / 2 * mu0 * (1 - 2 / pi * std::atan(mu0));
    const double a1 = ratio * (2 * sticking + 2 * square / one * (1 - 2 * ratio));
    const double a2 = 2.5 * ratio * (sticking + square * (1 - square) / (one * one));
    const double b1 = mu * mu / one, b2 = ratio / 2 * (sticking + square / one);
    return e - (a1 - a2 * b1 / b2) / 2;
  }
};

}  // namespace scree
