/// Drag of the gas on the particles, eqs. (6) and (7) (Wen-Yu), and the slip of a gas without inertia that follows.
#pragma once

#include <array>
#include <cmath>
#include <type_traits>

#include "scree/closures/gas.hpp"
#include "scree/math/dual.hpp"

namespace scree {

/// Re of (7), regularised as sqrt(Re^2 + 1e-16): finite derivatives by the squared slip at zero slip [-].
template <class Number>
Number reynolds_number(const Number& nu, const Number& slip_squared, double d, const GasParameters& gas) {
  const Number per_slip = (gas.rho_g * d / gas.mu_g) * (1.0 - nu);
  return sqrt(per_slip * per_slip * slip_squared + 1e-16);
}

/// C_D Re/24 of (7): drag in units of its Stokes value [-].
/// (7) jumps by .4 % at Re = 1000; here a smoothstep joins its two forms over Re = 950 ... 1050, so that slopes are
/// continuous and factor times Re still grows with Re.
template <class Number>
Number wen_yu_factor(const Number& Re) {
  constexpr double lower = 950, upper = 1050;
  if (Re >= upper) return .44 / 24 * Re;
  const Number intermediate = 1.0 + .15 * pow(Re, .687);
  if (Re <= lower) return intermediate;
  const Number t = (Re - lower) / (upper - lower);
  return intermediate + t * t * (3.0 - 2.0 * t) * (.44 / 24 * Re - intermediate);
}

/// beta/nu of (6) at zero slip [kg/(m3 s)].
template <class Number>
Number stokes_drag_over_nu(const Number& nu, double d, const GasParameters& gas) {
  return 18 * gas.mu_g / (d * d) * pow(1.0 - nu, -2.65);
}

/// beta/nu of (6) [kg/(m3 s)], finite and positive at nu = 0 and at zero slip; slip_squared = |u - v|^2 >= 0.
/// (6) with C_D |u - v| = 24 mu_g/(rho_g (1-nu) d) times wen_yu_factor. nu < 1.
template <class Number>
Number drag_over_nu(const Number& nu, const Number& slip_squared, double d, const GasParameters& gas) {
  return through(
      [&](const auto& x, const auto& w2) {
        return stokes_drag_over_nu(x, d, gas) * wen_yu_factor(reynolds_number(x, w2, d, gas));
      },
      nu, slip_squared);
}

/// beta of (6) [kg/(m3 s)].
template <class Number>
Number drag_coefficient(const Number& nu, const Number& slip_squared, double d, const GasParameters& gas) {
  return nu * drag_over_nu(nu, slip_squared, d, gas);
}

/// wen_yu_factor where the drag is known instead of the slip: at the Re with Re wen_yu_factor(Re) = stokes >= 0, Re
/// regularised as above in the factor. `stokes` is the Re that the slip would have at Stokes drag.
/// Newton's method from above the root, where the left-hand side is convex, within a bracket.
inline double wen_yu_factor_of_drag(double stokes) {
  const auto factor = [](const auto& Re) { return wen_yu_factor(sqrt(Re * Re + 1e-16)); };
  double lower = 0, upper = stokes;
  double Re = std::sqrt(24 / .44 * stokes) < stokes ? std::sqrt(24 / .44 * stokes) : stokes;
  for (int iteration = 0; iteration < 100; ++iteration) {
    const Dual<1> x = Dual<1>::variable(Re, 0), excess = x * factor(x) - stokes;
    (excess.value > 0 ? upper : lower) = Re;
    double next = Re - excess.value / excess.derivative[0];
    if (!(next >= lower && next <= upper)) next = (lower + upper) / 2;
    const double step = std::abs(next - Re);
    Re = next;
    if (!(step > 1e-7 * Re)) break;  // convergence is quadratic: that was the step to round-off
  }
  return factor(Re);
}

/// {mobility [m3 s/kg], |u - v|^2 [m2/s2]} of a gas without inertia, (1-nu) grad p_g = beta (v - u), such that
///     u - v = -mobility grad p_g,  mobility = (1-nu)/beta.
/// gradient_squared = |grad p_g|^2 >= 0 [Pa2/m2]. In beta the solids fraction is sqrt(nu^2 + floor^2), which keeps the
/// mobility finite in voids. The slip is found in plain doubles to round-off; its derivatives are those of one more
/// Newton step.
template <class Number>
std::array<Number, 2> darcy_flow(const Number& nu, const Number& gradient_squared, double solids_fraction_floor,
                                 double d, const GasParameters& gas) {
  return through(
      [&](const auto& x, const auto& gradient2) {
        using Inner = std::decay_t<decltype(x)>;
        const Inner solids = sqrt(x * x + solids_fraction_floor * solids_fraction_floor);
        const Inner stokes_mobility = (1.0 - x) / (solids * stokes_drag_over_nu(solids, d, gas));
        const Inner stokes_slip2 = stokes_mobility * stokes_mobility * gradient2;

        // slip2 factor(slip2)^2 = stokes_slip2
        const double per_slip = gas.rho_g * d / gas.mu_g * (1 - value_of(solids));
        const double by_drag = wen_yu_factor_of_drag(per_slip * std::sqrt(value_of(stokes_slip2)));
        const double root = value_of(stokes_slip2) / (by_drag * by_drag);
        const Dual<1> w2 = Dual<1>::variable(root, 0);
        const Dual<1> f = wen_yu_factor(reynolds_number(Dual<1>(value_of(solids)), w2, d, gas));
        const Inner factor = wen_yu_factor(reynolds_number(solids, Inner(root), d, gas));
        const Inner slip2 = root - (root * (factor * factor) - stokes_slip2) / (w2 * f * f).derivative[0];
        return std::array<Inner, 2>{stokes_mobility / wen_yu_factor(reynolds_number(solids, slip2, d, gas)), slip2};
      },
      nu, gradient_squared);
}

/// (1-nu)/beta, see darcy_flow [m3 s/kg].
template <class Number>
Number darcy_mobility(const Number& nu, const Number& gradient_squared, double solids_fraction_floor, double d,
                      const GasParameters& gas) {
  return darcy_flow(nu, gradient_squared, solids_fraction_floor, d, gas)[0];
}

/// |u - v|^2 = mobility^2 |grad p_g|^2, see darcy_flow [m2/s2].
template <class Number>
Number darcy_slip_squared(const Number& nu, const Number& gradient_squared, double solids_fraction_floor, double d,
                          const GasParameters& gas) {
  return darcy_flow(nu, gradient_squared, solids_fraction_floor, d, gas)[1];
}

}  // namespace scree
