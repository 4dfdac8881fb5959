/// Effective restitution: what friction between particles takes out of a collision beyond e, as a choice of the case.
/// It replaces e where energy is lost, (1.4) and (26), and nowhere else: stress and conduction keep e. A variant is a
/// type with name, source and
///     static double e_eff(double e, double mu);
/// e for mu = 0. effective_restitutions().push_back(&effective_restitution_entry<Variant>) offers it, before the case
/// is read.
#pragma once

#include "scree/closures/variants.hpp"

namespace scree {

/// An effective restitution that a case can choose.
struct EffectiveRestitution {
  const char *name, *source;
  double (*e_eff)(double e, double mu);  ///< of restitution and coefficient of friction [-]
};

/// The forms that options offer: chialvo_sundaresan, jenkins_zhang and what was appended.
Variants<EffectiveRestitution>& effective_restitutions();

/// chialvo_sundaresan.
const EffectiveRestitution* default_effective_restitution();

/// The entry of a variant.
template <class Variant>
inline constexpr EffectiveRestitution effective_restitution_entry{Variant::name, Variant::source, &Variant::e_eff};

}  // namespace scree
