/// Correlation length L of extended kinetic theory, as a choice of the case: in dense shear particles move in chains of
/// that length, and J_coll of (1.4) is divided by L/d. A variant is a type with name, source and
///     template <class Number> static Number ratio(const Number& nu, const KineticParameters& p);
/// L/d, at least 1, finite for nu < nu_max and 1 where nu is small or a rounding below 0.
/// correlation_lengths().push_back(&correlation_length_entry<Variant>) offers it, before the case is read.
#pragma once

#include "scree/closures/variants.hpp"

namespace scree {

struct KineticParameters;

/// L/d of (nu, p).
template <class Number>
using CorrelationLengthFunction = Number (*)(const Number&, const KineticParameters&);

/// An L that a case can choose.
struct CorrelationLength {
  const char *name, *source;
  PerNumber<CorrelationLengthFunction, double, Dual<1>> ratio;
};

/// The L that options offer beside none: jenkins, berzi_vescovi and what was appended.
Variants<CorrelationLength>& correlation_lengths();

template <class Variant, class Number>
Number correlation_length_by(const Number& nu, const KineticParameters& p) {
  return Variant::ratio(nu, p);
}

/// The entry of a variant.
template <class Variant>
inline constexpr CorrelationLength correlation_length_entry{
    Variant::name,
    Variant::source,
    {&correlation_length_by<Variant, double>, &correlation_length_by<Variant, Dual<1>>}};

/// Half the width over which max(1, .) of L/d is rounded.
inline constexpr double correlation_rounding = 1e-2;

}  // namespace scree
