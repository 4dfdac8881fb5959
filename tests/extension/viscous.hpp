/// A rheology from outside: a bed that carries its weight like the paper's, p_f = p_c, and shears like a liquid whose
/// viscosity is p_c times a time.
#pragma once

#include "scree/closures/solids_closures.hpp"

struct Viscous {
  static constexpr const char *name = "viscous", *source = "made up for this test";
  static constexpr bool has_friction = true, has_unknown = false, uses_flow_rule = false;
  static inline double time = 1e-2;  ///< set by the option viscous_time [s]

  template <class Number>
  static scree::FrictionalStress<Number> stress(const scree::FrictionalPoint<Number>& q,
                                                const scree::FrictionParameters&) {
    return {q.p_c, time * q.p_c};
  }
  template <class Number>
  static Number steady(const scree::FrictionalPoint<Number>&, const scree::FrictionParameters&) {
    return Number(1.0);
  }
};
