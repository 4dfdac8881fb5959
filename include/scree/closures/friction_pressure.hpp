/// Critical-state pressure p_c(nu) as a choice of the case. A variant is a type with name, source and
///     template <class Number> static Number pressure(const Number& nu, const FrictionParameters& p);
/// [Pa], positive, growing and smooth for nu_min < nu < nu_max and 0 with its slope at nu_min.
/// friction_pressures().push_back(&friction_pressure_entry<Variant>) offers it, before the case is read.
#pragma once

#include "scree/closures/variants.hpp"

namespace scree {

struct FrictionParameters;

/// p_c of (nu, p).
template <class Number>
using FrictionPressureFunction = Number (*)(const Number&, const FrictionParameters&);

/// A p_c that a case can choose.
struct FrictionPressure {
  const char *name, *source;
  PerNumber<FrictionPressureFunction, double, Dual<1>> p_c;
};

/// The p_c that options offer: power, schaeffer and what was appended.
Variants<FrictionPressure>& friction_pressures();

/// power, eq. (18).
const FrictionPressure* default_friction_pressure();

template <class Variant, class Number>
Number friction_pressure_by(const Number& nu, const FrictionParameters& p) {
  return Variant::pressure(nu, p);
}

/// The entry of a variant.
template <class Variant>
inline constexpr FrictionPressure friction_pressure_entry{
    Variant::name, Variant::source, {&friction_pressure_by<Variant, double>, &friction_pressure_by<Variant, Dual<1>>}};

}  // namespace scree
