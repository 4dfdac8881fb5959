/// Relaxation of the scaled frictional pressure, eq. (23), row of chi = p_f/p_c at cell centres, times nu [1/s]:
///
///     d(chi)/dt + v.grad(chi) = (chi* - chi)/tau
///
///     term                        function        kernel that evaluates it
///     nu d(chi)/dt                storage         CellBalances (cell_balances.hpp)
///     nu v.grad(chi)              advection       ScalarFluxes (scalar_fluxes.hpp)
///     nu (chi* - chi)/tau         chi_source      CellBalances, chi* of (21) from closures/friction.hpp
///
/// Multiplied by nu, so that it is carried by the same flux as (1), and says nothing where no particles are.
#pragma once

#include "scree/grid/unknown.hpp"

namespace scree {

/// chi, where friction relaxes.
struct FrictionRelaxation {
  static double scale(const Scales&) { return 1; }
  static double row_scale(const Scales& s, double) { return s.time; }
  /// Keeps 10 % of its value and stays below the tip of the yield surface.
  static NewtonBounds bounds(double chi, const NewtonContext& c) { return {0.1 * chi, c.chi_max}; }

  static constexpr Unknown unknown{"frictional_pressure_ratio",
                                   "chi",
                                   "1",
                                   "p_f/p_c, (23)",
                                   Place::cell,
                                   scale,
                                   row_scale,
                                   ErrorNorm::with_particles,
                                   bounds,
                                   {"scaled frictional pressure", Allowed::non_negative, 1},
                                   {"of what an inlet brings", Allowed::non_negative, 1},
                                   true};

  /// nu (d(chi)/dt - source), source = (chi* - chi)/tau [1/s].
  template <class X, class Y, class Z>
  static auto storage_less_source(const X& nu, const Y& chi_dot, const Z& source) {
    return nu * (chi_dot - source);
  }
  /// chi that the volume flux F = nu v carries through a face, beyond that of `own` [m/s].
  template <class X, class Y, class Z>
  static auto advection(const X& F, const Y& carried, const Z& own) {
    return F * (carried - own);
  }
};

}  // namespace scree
