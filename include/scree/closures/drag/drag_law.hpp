/// A drag law as a type, and the entry made from it. A law gives the dimensionless drag
///     F(nu, Re) = beta d^2/(18 mu_g nu) [-],   Re = rho_g (1-nu) d |u - v|/mu_g,
/// which is 1 for a lone sphere in creeping flow:
///
///     struct MyLaw {
///       static constexpr const char *name = "my_law", *source = "Author (year), journal, equation";
///       template <class Number>
///       static Number factor(const Number& nu, const Number& Re);
///     };
///     drag_laws().push_back(&drag_law<MyLaw>);  // before the case is read
///
/// factor is positive and smooth for 0 <= nu < 1 and Re > 0, also for nu a rounding below 0, and Re factor grows with
/// Re. Re is kept away from 0 by the caller.
#pragma once

#include <cmath>
#include <limits>

#include "scree/closures/drag.hpp"

namespace scree {

/// Re regularised as sqrt(Re^2 + 1e-16): finite derivatives by the squared slip at zero slip [-].
template <class Number>
Number regularised_reynolds(const Number& Re_squared) {
  return sqrt(Re_squared + 1e-16);
}

/// Re of (7), regularised [-].
template <class Number>
Number reynolds_number(const Number& nu, const Number& slip_squared, double d, const GasParameters& gas) {
  const Number per_slip = (gas.rho_g * d / gas.mu_g) * (1.0 - nu);
  return regularised_reynolds(Number(per_slip * per_slip * slip_squared));
}

/// beta/nu of a lone sphere in creeping flow [kg/(m3 s)].
inline double stokes_drag_over_nu(double d, const GasParameters& gas) { return 18 * gas.mu_g / (d * d); }

/// beta/nu by a law, see drag_over_nu [kg/(m3 s)].
template <class Law, class Number>
Number drag_over_nu_by(const Number& nu, const Number& slip_squared, double d, const GasParameters& gas) {
  return stokes_drag_over_nu(d, gas) * Law::factor(nu, reynolds_number(nu, slip_squared, d, gas));
}

/// F of a law where the drag is known instead of the slip: at the Re with Re F(nu, Re) = stokes_Re >= 0, the Re that
/// the slip would have were F = 1. Newton's method in logarithms, where Re F is nearly a power, within a bracket.
template <class Law>
double factor_of_drag(double nu, double stokes_Re) {
  const auto factor = [nu](const auto& Re) {
    using Number = std::decay_t<decltype(Re)>;
    return Law::factor(Number(nu), regularised_reynolds(Number(Re * Re)));
  };
  double lower = 0, upper = std::numeric_limits<double>::infinity(), Re = stokes_Re / factor(0.0);
  for (int iteration = 0; iteration < 100 && Re > 0; ++iteration) {
    const Dual<1> F = factor(Dual<1>::variable(Re, 0));
    const double excess = stokes_Re / (Re * F.value), power = 1 + Re * F.derivative[0] / F.value;
    (excess > 1 ? lower : upper) = Re;
    const bool near = std::abs(excess - 1) < 1e-4;
    double next = Re * (near ? 1 + (excess - 1) / power : std::pow(excess, 1 / power));
    if (!(next >= lower && next <= upper)) next = upper < 2 * Re ? (lower + upper) / 2 : 2 * Re;
    const double step = std::abs(next - Re);
    Re = next;
    if (!(step > 1e-7 * Re)) break;  // convergence is quadratic: that was the step to round-off
  }
  return factor(Re);
}

/// darcy_flow by a law. The slip is found in plain doubles to round-off; its derivatives are those of one more Newton
/// step.
template <class Law, class Number>
std::array<Number, 2> darcy_flow_by(const Number& nu, const Number& gradient_squared, double solids_fraction_floor,
                                    double d, const GasParameters& gas) {
  const Number solids = sqrt(nu * nu + solids_fraction_floor * solids_fraction_floor);
  const Number stokes_mobility = (1.0 - nu) / (solids * stokes_drag_over_nu(d, gas));
  const Number stokes_slip2 = stokes_mobility * stokes_mobility * gradient_squared;

  // slip2 F(slip2)^2 = stokes_slip2
  const double per_slip = gas.rho_g * d / gas.mu_g * (1 - value_of(solids));
  const double by_drag = factor_of_drag<Law>(value_of(solids), per_slip * std::sqrt(value_of(stokes_slip2)));
  const double root = value_of(stokes_slip2) / (by_drag * by_drag);
  const auto factor = [&](const auto& x, const auto& w2) { return Law::factor(x, reynolds_number(x, w2, d, gas)); };
  const Dual<1> w2 = Dual<1>::variable(root, 0), f = factor(Dual<1>(value_of(solids)), w2);
  const Number F = factor(solids, Number(root));
  const Number slip2 = root - (root * (F * F) - stokes_slip2) / (w2 * f * f).derivative[0];
  return {stokes_mobility / factor(solids, slip2), slip2};
}

/// The entry of a law.
template <class Law>
inline constexpr DragLaw drag_law{
    Law::name,
    Law::source,
    {&drag_over_nu_by<Law, double>, &drag_over_nu_by<Law, Dual<1>>, &drag_over_nu_by<Law, Dual<2>>},
    {&darcy_flow_by<Law, double>, &darcy_flow_by<Law, Dual<1>>, &darcy_flow_by<Law, Dual<2>>}};

}  // namespace scree
