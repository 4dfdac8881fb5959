/// What carries the particles of a partly filled cell at a free surface: an inner stress of that cell.
///
/// (3) at the face over such a cell D moves half of D's particles. Gravity's work is booked there as g nu_f v_f, with
/// the mean nu_f; the potential energy changes by what crosses the face, g nu_up v_f, which is nothing where the cell
/// above is empty. Without a stress that half of D would fall freely while no mass moves, and -p div v of D would hand
/// the work of that fall to the granular temperature, sum(v . grad p) = -sum(p div v) being exact here. So what of D's
/// upper half cannot fall into the cell above rests on the lower half, as by a contact:
///     sigma = m |g| surface_share closing,   m = rho_s (nu_D - nu_above) h/2,
/// where m fades with the square of nu_D below 1e-3. `closing` is 1.1 w/v_c - 0.1, v_c = 1e-4 sqrt(|g| d), w being the
/// speed at which the faces of D approach each other; a parabola rounds it off to 0 at w = 0, where every run from rest
/// begins, and it stays 0 where they part. Its work is >= 0 and goes to heat, as that of friction does. Momentum and
/// weight stay, since it is no outer force. Rigid fall, expansion and leading fronts do not feel it. At rest it carries
/// the weight m |g| while the face sinks with v_c, without a flux.
#pragma once

#include "scree/assembly/kernel.hpp"
#include "scree/assembly/scene.hpp"
#include "scree/balances/layout.hpp"
#include "scree/math/rounded.hpp"

namespace scree {

/// 1 at a free surface, 0 where what lies above is more than a twentieth of what lies below: c^64 with the contrast c
/// of the solids fractions [-]; 0.28 where the cell above holds a hundredth, 3e-6 where it holds a tenth, which is to
/// fall in.
template <class Number>
Number surface_share(const Number& below, const Number& above) {
  constexpr double nothing = 1e-9;  // voids may hold less than the root of the least number
  return integer_power(Number((below - above) / (below + above + nothing)), 64);
}

/// Weight of half of cell I along `axis` over the area below it [Pa].
template <class Number>
Number half_weight(const Scene& scene, const Index& I, int axis, const Number& nu) {
  return (0.5 * scene.solids.kinetic.rho_s * std::abs(scene.gravity[axis]) * scene.cell_length(axis, I)) * nu;
}

/// By how much a partly filled cell presses harder than by p_c on what it lies on [Pa], for friction on the edges
/// between the two: at rest it presses with half of its weight, which is sigma above. That it rests is told by the cell
/// below, whose p_c carries all of the upper cell and half of its own weight then. Weights are half of the cells'.
template <class Number>
Number resting_excess(const Number& p_c, const Number& weight, const Number& p_c_below, const Number& weight_below) {
  constexpr double soft = 0.1, nothing = 1e-9;  // Pa
  if (!(weight > nothing) || p_c > (1 + soft) * weight) return Number(0.0);
  const Number missing = 1.0 - p_c / weight;
  const Number carried = (p_c_below - weight_below - weight - p_c) / weight;
  const Number share = missing + rounded_minimum(Number(carried - missing), 0, soft);
  return weight * rounded_maximum(share, 0, soft);
}

/// What lies over cell I against gravity: what may fall in [-]. A wall over the cell leaves no surface.
template <class L, class Q>
auto solids_fraction_above(const Scene& scene, const Index& I, const Q& q, int axis) {
  using Number = decltype(q(L::nu));
  const Index e = unit(axis);
  const int up = scene.gravity[axis] < 0 ? 1 : -1;
  const Index face = up > 0 ? I + e : I;
  if (scene.barrier(axis, face)) {
    const Condition& condition = scene.condition(axis, face);
    if (condition.kind.stops_solids()) return q(L::nu);
    return Number(condition.kind.brings_solids() ? condition.brought(SolidsContinuity::unknown) : 0.0);
  }
  const Number above = q(L::nu, up * e);
  return above > 0.0 ? above : Number(0.0);
}

/// sigma of cell I along `axis` [Pa].
template <class L, class Q>
auto surface_stress(const Scene& scene, const Index& I, const Q& q, int axis) {
  const double g = scene.gravity[axis];
  const auto sigma = [&](const auto& compression, const auto& own, const auto& above) {
    using Number = std::decay_t<decltype(own)>;
    if (g == 0 || !(compression > 0.0) || !(own > above)) return Number(0.0);
    constexpr double dilute = 1e-3;  // solids fraction; voids and thin rain are no surfaces
    const Number dense = own * own / (own * own + dilute * dilute);
    const Number weight = half_weight(scene, I, axis, Number(dense * (own - above)));
    const double v_c = 1e-4 * std::sqrt(std::abs(g) * scene.solids.kinetic.d);
    constexpr double soft = 0.1;
    const Number closing = rounded_maximum(Number((1 + soft) / v_c * compression), soft, soft) - soft;
    return Number(weight * surface_share(own, above) * closing);
  };
  return through(sigma, q(L::v(axis)) - q(L::v(axis), unit(axis)), q(L::nu),
                 solids_fraction_above<L>(scene, I, q, axis));
}

/// Anchor I: cell I.
template <class L, int axis>
struct SurfaceStress {
  static constexpr Index e = unit(axis);
  static constexpr StencilBuilder make_stencil() {
    StencilBuilder s;
    for (int at = -1; at <= 1; ++at) s.add(L::nu, at * e);
    s.add(L::v(axis), {});
    s.add(L::v(axis), e);
    return s;
  }
  static constexpr StencilBuilder stencil = make_stencil();
  static constexpr std::array<Output, 2> rows{{{L::v(axis), Index{}}, {L::v(axis), e}}};
  static constexpr bool depends(int, const Input&) { return true; }

  static bool active(const Scene& scene, const Index& I) {
    const bool weight = scene.model.gravity[axis] != 0 || scene.model.vibration_amplitude[axis] != 0;
    return weight && scene.inside(I);
  }
  static Reference resolve(const Scene&, const Index&, const Input& input) { return {input.offset, 1}; }

  template <class Number, std::size_t count>
  [[gnu::flatten]] static void evaluate(const Scene& scene, const Index& I, const Local<SurfaceStress, Number>& q,
                                        std::array<Number, count>& r) {
    const auto sigma = surface_stress<L>(scene, I, q, axis);
    r[0] += out_of_control_volume(scene, axis, I, End::upper, sigma);
    r[1] -= out_of_control_volume(scene, axis, I + e, End::lower, sigma);
  }
};

}  // namespace scree
