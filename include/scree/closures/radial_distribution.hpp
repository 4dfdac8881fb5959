/// Radial distribution at contact, g0(nu), as a choice of the case. A variant is a type with name, source and
///     template <class Number> static Number g0(const Number& nu, double nu_max);
/// smooth and positive for nu < nu_max, also for nu a rounding below 0. radial_distributions().push_back(
/// &radial_distribution_entry<Variant>) offers it, before the case is read.
#pragma once

#include "scree/closures/variants.hpp"

namespace scree {

/// g0 of (nu, nu_max).
template <class Number>
using RadialDistributionFunction = Number (*)(const Number&, const double&);

/// A g0 that a case can choose.
struct RadialDistribution {
  const char *name, *source;
  PerNumber<RadialDistributionFunction, double, Dual<1>> g0;
};

/// The g0 that options offer: lun_savage, carnahan_starling, ma_ahmadi and what was appended.
Variants<RadialDistribution>& radial_distributions();

/// lun_savage, eq. (1.7).
const RadialDistribution* default_radial_distribution();

template <class Variant, class Number>
Number radial_distribution_by(const Number& nu, const double& nu_max) {
  return Variant::g0(nu, nu_max);
}

/// The entry of a variant.
template <class Variant>
inline constexpr RadialDistribution radial_distribution_entry{
    Variant::name,
    Variant::source,
    {&radial_distribution_by<Variant, double>, &radial_distribution_by<Variant, Dual<1>>}};

}  // namespace scree
