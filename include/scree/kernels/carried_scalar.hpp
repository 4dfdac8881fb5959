/// A further scalar of the particles with a balance of the form
///
///     c nu (d(phi)/dt + v.grad phi) = div(k grad phi) + source
///
/// e.g. a tracer, a temperature, a fluidity: what a model needs beyond the paper's. `Scalar` is its balance, a type
/// with
///     static constexpr Unknown unknown
///     static double capacity(const Scene&)                                       c
///     static Number conductivity(const Scene&, const Number& nu, const Number& phi)   k, at faces
///     static Number source(const Scene&, const ScalarPoint<Number>& at)          source per volume, at cells
/// Units: those of phi times c per time and volume.
#pragma once

#include "scree/kernels/cell_strain.hpp"
#include "scree/kernels/scalar_fluxes.hpp"

namespace scree {

/// What the source of a scalar may depend on.
template <class Number>
struct ScalarPoint {
  Number phi, nu;
  Number T, chi;  ///< of the models of the scene; 0 and 1 where they are no unknowns
  Number div_v, S_S;
};

/// Advection and conduction. Anchor I: the lower `axis` face of cell I.
template <class L, bool SecondOrder, class Scalar, int axis>
struct CarriedScalarFlux {
  static constexpr Index e = unit(axis);
  static constexpr int phi = L::template first<Scalar>();
  static constexpr StencilBuilder make_stencil() {
    StencilBuilder s;
    add_solids_flux_inputs<L, SecondOrder>(s, axis, {});
    for (int reach = SecondOrder ? -2 : -1; reach <= (SecondOrder ? 1 : 0); ++reach) s.add(phi, reach * e);
    return s;
  }
  static constexpr StencilBuilder stencil = make_stencil();
  static constexpr std::array<Output, 2> rows{{{phi, -1 * e}, {phi, Index{}}}};
  static constexpr bool depends(int, const Input&) { return true; }

  static bool active(const Scene& scene, const Index& I) { return scene.is_face(axis, I) && !scene.wall(axis, I); }
  static Reference resolve(const Scene& scene, const Index& I, const Input& input) {
    if (L::is_velocity(input.component)) return {input.offset, 1};
    return cell_before_barrier(scene, I, axis, {}, input.offset[axis]);
  }

  template <class Number, std::size_t count>
  [[gnu::flatten]] static void evaluate(const Scene& scene, const Index& I, const Local<CarriedScalarFlux, Number>& q,
                                        std::array<Number, count>& r) {
    const Number F = scree::solids_flux<L, SecondOrder>(scene, I, q, axis, {});
    const Number value = carried<L, SecondOrder, Scalar>(scene, I, q, axis, F);
    const auto below = q(phi, -1 * e), above = q(phi);
    Number conducted(0.0);
    if (!scene.barrier(axis, I)) {
      const Number nu = face_mean(scene, axis, I, q(L::nu, -1 * e), q(L::nu));
      const Number k = Scalar::conductivity(scene, nu, Number(face_mean(scene, axis, I, below, above)));
      conducted = -k * difference_at_face(scene, axis, I, below, above);
    }
    const double c = Scalar::capacity(scene);
    r[0] += out_of_cell(scene, axis, I - e, End::upper, Number(c * F * (value - below) + conducted));
    r[1] -= out_of_cell(scene, axis, I, End::lower, Number(c * F * (value - above) + conducted));
  }
};

/// Storage and source. Anchor I: cell I.
template <class L, class Scalar>
struct CarriedScalarSource {
  static constexpr int phi = L::template first<Scalar>();
  static constexpr StencilBuilder make_stencil() {
    StencilBuilder s;
    s.add(phi, {});
    s.add(L::nu, {});
    s.add(L::T, {});
    s.add(L::chi, {});
    add_cell_strain_inputs<L>(s);
    return s;
  }
  static constexpr StencilBuilder stencil = make_stencil();
  static constexpr std::array<Output, 1> rows{{{phi, Index{}}}};
  static constexpr bool has_rates = true;
  static constexpr bool depends(int, const Input&) { return true; }

  static bool active(const Scene& scene, const Index& I) { return scene.inside(I); }
  static Reference resolve(const Scene&, const Index&, const Input& input) { return {input.offset, 1}; }

  template <class Number, std::size_t count>
  [[gnu::flatten]] static void evaluate(const Scene& scene, const Index& I, const Local<CarriedScalarSource, Number>& q,
                                        std::array<Number, count>& r) {
    const auto strain = cell_strain<L>(scene, I, q);
    const auto nu = q(L::nu);
    const auto stored = nu + added_in_voids(scene, nu);
    const ScalarPoint<Number> at{q(phi),       nu,        Number(temperature_input<L>(q)), Number(chi_input<L>(q)),
                                 strain.div_v, strain.S_S};
    r[0] += Scalar::capacity(scene) * stored * q.dot(phi) - Scalar::source(scene, at);
  }
};

}  // namespace scree
