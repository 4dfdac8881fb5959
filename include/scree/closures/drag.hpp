/// Drag of the gas on the particles by the law of the case, and the slip of a gas without inertia that follows.
/// beta [kg/(m3 s)] is that of (1-nu) grad p_g = beta (v - u) in a bed without shear of the gas, eq. (6).
#pragma once

#include <array>

#include "scree/closures/gas.hpp"
#include "scree/closures/variants.hpp"

namespace scree {

/// beta/nu of (nu, |u - v|^2, d, gas).
template <class Number>
using DragFunction = Number (*)(const Number&, const Number&, double, const GasParameters&);

/// {mobility, |u - v|^2} of (nu, |grad p_g|^2, solids fraction floor, d, gas).
template <class Number>
using DarcyFunction = std::array<Number, 2> (*)(const Number&, const Number&, double, double, const GasParameters&);

/// A drag law that a case can choose. drag_law<Law> of drag/drag_law.hpp makes one from a type Law.
struct DragLaw {
  const char *name, *source;
  PerNumber<DragFunction, double, Dual<1>, Dual<2>> over_nu;
  PerNumber<DarcyFunction, double, Dual<1>, Dual<2>> darcy;
};

/// The drag laws that options offer: wen_yu, gidaspow, syamlal_obrien, beetstra, ergun and what was appended.
Variants<DragLaw>& drag_laws();

/// beta/nu [kg/(m3 s)], finite and positive at nu = 0 and at zero slip; slip_squared = |u - v|^2 >= 0. nu < 1.
template <class Number>
Number drag_over_nu(const Number& nu, const Number& slip_squared, double d, const GasParameters& gas) {
  return through(
      [&](const auto& x, const auto& w2) {
        return std::get<DragFunction<std::decay_t<decltype(x)>>>(gas.drag_law->over_nu)(x, w2, d, gas);
      },
      nu, slip_squared);
}

/// beta [kg/(m3 s)].
template <class Number>
Number drag_coefficient(const Number& nu, const Number& slip_squared, double d, const GasParameters& gas) {
  return nu * drag_over_nu(nu, slip_squared, d, gas);
}

/// {mobility [m3 s/kg], |u - v|^2 [m2/s2]} of a gas without inertia, (1-nu) grad p_g = beta (v - u), such that
///     u - v = -mobility grad p_g,  mobility = (1-nu)/beta.
/// gradient_squared = |grad p_g|^2 >= 0 [Pa2/m2]. In beta the solids fraction is sqrt(nu^2 + floor^2), which keeps the
/// mobility finite in voids.
template <class Number>
std::array<Number, 2> darcy_flow(const Number& nu, const Number& gradient_squared, double solids_fraction_floor,
                                 double d, const GasParameters& gas) {
  return through(
      [&](const auto& x, const auto& gradient2) {
        return std::get<DarcyFunction<std::decay_t<decltype(x)>>>(gas.drag_law->darcy)(x, gradient2,
                                                                                       solids_fraction_floor, d, gas);
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
