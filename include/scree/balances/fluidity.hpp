/// Balance of the fluidity g_f of nonlocal friction, eq. (F), row of g_f at cell centres, times nu [1/s]:
///
///     t_0 nu (d(g_f)/dt + v.grad g_f) = div(nu A^2 d^2 grad g_f) + nu {-mu_s g_f + gdot (1 - b d sqrt(rho_s/p_f) g_f)}
///
///     term                              function       kernel that evaluates it
///     t_0 nu (d(g_f)/dt + v.grad g_f)   capacity       CarriedScalarSource, CarriedScalarFlux (carried_scalar.hpp)
///     div(nu A^2 d^2 grad g_f)          conductivity   CarriedScalarFlux
///                                       from_wall      at walls without slip: WallLaws (wall_laws.hpp)
///     nu {...}                          source         CarriedScalarSource, from closures/fluidity.hpp
///
/// Multiplied by nu, so that it says nothing where no particles are, and none spreads through a free surface.
#pragma once

#include "scree/assembly/scene.hpp"
#include "scree/grid/unknown.hpp"

namespace scree {

/// g_f, where the friction coefficient is `fluidity`.
struct Fluidity {
  static double scale(const Scales& s) { return 1 / s.time; }
  static double row_scale(const Scales& s, double) { return s.time; }
  /// Keeps 10 % of its value.
  static NewtonBounds bounds(double g_f, const NewtonContext&) {
    NewtonBounds b;
    b.lower = 0.1 * g_f;
    return b;
  }

  static constexpr Unknown unknown{"fluidity",
                                   "g_f",
                                   "1/s",
                                   "fluidity of nonlocal friction, (F)",
                                   Place::cell,
                                   scale,
                                   row_scale,
                                   ErrorNorm::with_particles,
                                   bounds,
                                   {"fluidity", Allowed::positive, 1e-2},
                                   {"of what an inlet brings", Allowed::positive, 1e-2},
                                   true};

  /// t_0 [s].
  static double capacity(const Scene& scene) { return scene.solids.friction.fluidity.t_0; }
  /// nu A^2 d^2 [m2].
  template <class Number>
  static Number conductivity(const Scene& scene, const Number& nu, const Number&) {
    return fluidity_spreading(scene.solids.friction.d, scene.solids.friction.fluidity) * nu;
  }
  /// nu {-mu_s g_f + gdot (1 - b d sqrt(rho_s/p_f) g_f)} at a ScalarPoint [1/s].
  template <class Point>
  static auto source(const Scene& scene, const Point& at) {
    using Number = std::decay_t<decltype(at.phi)>;
    const FrictionParameters& p = scene.solids.friction;
    return through(
        [&](const auto& g_f, const auto& nu, const auto& chi, const auto& S_S) {
          using Inner = std::decay_t<decltype(nu)>;
          const Inner p_f = chi * critical_pressure(nu, p);
          return Inner(nu * fluidity_source(g_f, p_f, S_S, std::sin(p.phi), p.rho_s, p.d, p.fluidity));
        },
        at.phi, at.nu, Number(at.chi), at.S_S);
  }
  /// What comes from a wall that holds g_f, at a distance from the centre of the cell [m/s].
  template <class Number>
  static Number from_wall(const Scene& scene, const Number& nu, const Number& g_f, double distance) {
    return conductivity(scene, nu, g_f) * (scene.solids.friction.fluidity.at_rough - g_f) / distance;
  }
};

}  // namespace scree
