/// Strain rate of the particles in a cell: normal components from the faces of the cell, shear components from its
/// edges. The deviator is three-dimensional in plane flow too: S:S = D:D - (div v)^2/3 with the missing D_aa zero.
#pragma once

#include "scree/kernels/gas_slip.hpp"

namespace scree {

/// Inputs of cell_strain: the face velocities of the cell and those beside them.
template <class L>
constexpr void add_cell_strain_inputs(StencilBuilder& s) {
  for (int a = 0; a < L::dim; ++a)
    for (int face = 0; face < 2; ++face) {
      s.add(L::v(a), face * unit(a));
      for (int b = 0; b < L::dim; ++b)
        for (int side = -1; side <= 1; side += 2)
          if (b != a) s.add(L::v(a), face * unit(a) + side * unit(b));
    }
}

/// The stencil of kernels that evaluate the closures of their anchor cell.
template <class L>
constexpr StencilBuilder cell_stencil() {
  StencilBuilder s;
  s.add(L::nu, {});
  s.add(L::T, {});
  s.add(L::chi, {});
  s.add(L::g_f, {});
  add_cell_strain_inputs<L>(s);
  add_cell_slip_inputs<L>(s);
  return s;
}

/// Weights of the four edges of cell I about axes a, b, [side along a][side along b], in the mean of D_ab^2.
/// At a wall with slip the velocity beyond is unknown: the edge takes the shear rate of the opposite edge of the cell.
/// Where there is no shear by the condition (symmetry, free slip), and between barriers one cell apart, the edge counts
/// with zero.
[[gnu::noinline]] inline std::array<std::array<double, 2>, 2> edge_weights(const Scene& scene, const Index& I, int a,
                                                                           int b) {
  std::array<std::array<double, 2>, 2> weights{{{0, 0}, {0, 0}}};
  for (int side_a = 0; side_a < 2; ++side_a)
    for (int side_b = 0; side_b < 2; ++side_b) {
      int from_a = side_a, from_b = side_b;
      bool free = false;
      const auto look = [&](int axis, int side, int& from) {
        const Index face = I + side * unit(axis);
        if (!scene.barrier(axis, face)) return;
        const bool between = scene.barrier(axis, I + (1 - side) * unit(axis));
        free = free || between || scene.kind(axis, face).solids_tangential == SolidsTangential::free;
        from = 1 - side;
      };
      look(a, side_a, from_a);
      look(b, side_b, from_b);
      if (!free) weights[from_a][from_b] += 0.25;
    }
  return weights;
}

/// D_ab at edge I + at [1/s].
template <class L, class Q>
[[gnu::always_inline]] inline auto shear_rate(const Scene& scene, const Index& I, const Q& q, int a, int b,
                                              const Index& at) {
  const Index edge = I + at;
  return 0.5 * (difference_at_face(scene, b, edge, q(L::v(a), at - unit(b)), q(L::v(a), at)) +
                difference_at_face(scene, a, edge, q(L::v(b), at - unit(a)), q(L::v(b), at)));
}

/// T, chi or g_f among the inputs, or a constant where it is no unknown: `through` does not differentiate a double.
template <class L, class Q>
[[gnu::always_inline]] inline auto temperature_input(const Q& q, const Index& at = {}) {
  if constexpr (L::has_T)
    return q(L::T, at);
  else
    return 0.0;
}
template <class L, class Q>
[[gnu::always_inline]] inline auto chi_input(const Q& q, const Index& at = {}) {
  if constexpr (L::has_chi)
    return q(L::chi, at);
  else
    return 1.0;
}
template <class L, class Q>
[[gnu::always_inline]] inline auto fluidity_input(const Q& q, const Index& at = {}) {
  if constexpr (L::has_g_f)
    return q(L::g_f, at);
  else
    return 1.0;
}

/// S:S of the components of S at a place with anchor I, with the derivative that the tangent asked for has. T is the
/// granular temperature where it is an unknown; `kind` gives the directions of the places of this kind.
template <class Number, std::size_t capacity, std::size_t most_terms, class Temperature, class Kind>
[[gnu::always_inline]] inline Number square_of_strain(const Scene& scene,
                                                      const StrainComponents<Number, capacity, most_terms>& S,
                                                      [[maybe_unused]] const Temperature& T,
                                                      [[maybe_unused]] const Index& I, [[maybe_unused]] Kind&& kind) {
  if constexpr (IsDual<Number>::value)
    if (scene.tangent) {
      const double gamma = fluctuating_strain_rate(S.square_value(), value_of(T), scene.solids.friction);
      return kind(*scene.tangent)->square(static_cast<std::size_t>(scene.lattice.ghosted(I)), S, gamma);
    }
  return S.square();
}

template <class Q, int dim>
struct CellStrain {
  using Number = typename Q::Number;
  std::array<typename Q::template Few<2>, dim> D;  ///< normal components D_aa [1/s]
  typename Q::template Few<2 * dim> div_v;         ///< [1/s]
  Number S_S;                                      ///< S:S [1/s2]

  /// S:S of the normal components alone [1/s2].
  Number normal_square() const {
    Number sum = -square(div_v) / 3.0;
    for (const auto& component : D) sum += square(component);
    return sum;
  }
  /// S_aa [1/s].
  auto S(int a) const { return D[a] - div_v / 3.0; }
};

template <class L, class Q>
auto cell_strain(const Scene& scene, const Index& I, const Q& q) {
  constexpr std::size_t edges = 2 * L::dim * (L::dim - 1);
  CellStrain<Q, L::dim> strain;
  StrainComponents<typename Q::Number, L::dim + 1 + edges, 4 * L::dim + 4 * edges> S;
  for (int a = 0; a < L::dim; ++a) {
    strain.D[a] = difference_in_cell(scene, a, I, q(L::v(a)), q(L::v(a), unit(a)));
    S.add(strain.D[a], 1);
  }
  strain.div_v = sum(strain.D);
  S.add(strain.div_v, -1.0 / 3);

  const bool near = scene.near;
  for (int a = 0; a < L::dim; ++a)
    for (int b = a + 1; b < L::dim; ++b) {
      const auto weights =
          near ? edge_weights(scene, I, a, b) : std::array<std::array<double, 2>, 2>{{{0.25, 0.25}, {0.25, 0.25}}};
      for (int side_a = 0; side_a < 2; ++side_a)
        for (int side_b = 0; side_b < 2; ++side_b) {
          if (weights[side_a][side_b] == 0) continue;
          S.add(shear_rate<L>(scene, I, q, a, b, side_a * unit(a) + side_b * unit(b)), 2 * weights[side_a][side_b]);
        }
    }
  strain.S_S = square_of_strain(scene, S, temperature_input<L>(q), I, [](NewtonTangent& t) { return &t.cells; });
  return strain;
}

/// The chosen entries of the closures of cell I, e.g. closures<L, CellClosure::pressure>(...)[0].
template <class L, CellClosure::Entry... entries, class Q, class Strain>
auto cell_closures(const Scene& scene, const Index& I, const Q& q, const Strain& strain) {
  return through(
      [&](const auto& nu, const auto& T, const auto& chi, const auto& div_v, const auto& S_S, const auto& slip_squared,
          const auto& g_f) {
        const auto all = cell_closure(nu, T, chi, div_v, S_S, slip_squared, g_f, scene.solids);
        return std::array<std::decay_t<decltype(nu)>, sizeof...(entries)>{all[entries]...};
      },
      q(L::nu), temperature_input<L>(q), chi_input<L>(q), strain.div_v, strain.S_S, cell_slip_squared<L>(scene, I, q),
      fluidity_input<L>(q));
}

}  // namespace scree
