/// A balance from outside: a tracer c on the particles, which spreads and decays,
///
///     nu (dc/dt + v.grad c) = div(nu D grad c) - nu r c
///
/// with its unknown, initial value, inlet value, options and output.
#pragma once

#include "scree/kernels/carried_scalar.hpp"

struct Tracer {
  static inline double diffusivity = 0;  ///< D, set by the option tracer_diffusivity [m2/s]
  static inline double decay = 0;        ///< r, set by the option tracer_decay [1/s]

  static double scale(const scree::Scales&) { return 1; }
  static double row_scale(const scree::Scales& s, double) { return s.time; }

  static constexpr scree::Unknown unknown{"tracer",
                                          "c",
                                          "1",
                                          "tracer on the particles",
                                          scree::Place::cell,
                                          scale,
                                          row_scale,
                                          scree::ErrorNorm::with_particles,
                                          scree::unbounded,
                                          {"tracer in the region", scree::Allowed::non_negative},
                                          {"tracer on what an inlet brings", scree::Allowed::non_negative}};

  static double capacity(const scree::Scene&) { return 1; }
  template <class Number>
  static Number conductivity(const scree::Scene&, const Number& nu, const Number&) {
    return diffusivity * nu;
  }
  template <class Number>
  static Number source(const scree::Scene&, const scree::ScalarPoint<Number>& at) {
    return -decay * (at.nu * at.phi);
  }
};
