/// The viscous part of the gas stress (5), with mu_g: on both phases by their volume fractions. Only where the case
/// asks for it; the paper's cases do without.
#pragma once

#include "scree/kernels/gas_slip.hpp"

namespace scree {

/// The four rows of a gas stress across a face that u and v of one axis share: u and v before it, u and v behind it.
template <class L>
constexpr std::array<Output, 4> gas_stress_rows(int axis, const Index& before, const Index& behind) {
  return {{{L::u(axis), before}, {L::v(axis), before}, {L::u(axis), behind}, {L::v(axis), behind}}};
}

/// Adds the divergence of a stress to the balances of u and v at one place.
template <class Number>
void add_gas_stress(const Number& nu, const Number& divergence, Number& gas, Number& particles) {
  gas += GasMomentum::viscous_stress(nu, divergence);
  particles += SolidsMomentum::gas_stress(nu, divergence);
}

/// Normal stress along `axis`. Anchor I: cell I.
template <class L, int axis>
struct GasNormalStress {
  static constexpr Index e = unit(axis);
  static constexpr StencilBuilder make_stencil() {
    StencilBuilder s;
    for (int a = 0; a < L::dim; ++a)
      for (int side = 0; side < 2; ++side) s.add(L::u(a), side * unit(a));
    for (int reach = -1; reach <= 1; ++reach) s.add(L::nu, reach * e);
    return s;
  }
  static constexpr StencilBuilder stencil = make_stencil();
  static constexpr std::array<Output, 4> rows = gas_stress_rows<L>(axis, Index{}, e);
  static constexpr bool depends(int, const Input&) { return true; }

  static bool active(const Scene& scene, const Index& I) { return scene.model.gas_viscous_stress && scene.inside(I); }
  static Reference resolve(const Scene& scene, const Index& I, const Input& input) {
    const int reach = L::is_u(input.component) ? 0 : input.offset[axis];
    if (reach == -1 && scene.barrier(axis, I)) return {Index{}, 1};
    if (reach == 1 && scene.barrier(axis, I + e)) return {Index{}, 1};
    return {input.offset, 1};
  }

  template <class Number, std::size_t count>
  static void evaluate(const Scene& scene, const Index& I, const Local<GasNormalStress, Number>& q,
                       std::array<Number, count>& r) {
    Number div_u(0.0), D(0.0);
    for (int a = 0; a < L::dim; ++a) {
      const Number D_aa = difference_in_cell(scene, a, I, q(L::u(a)), q(L::u(a), unit(a)));
      div_u += D_aa;
      if (a == axis) D = D_aa;
    }
    const Number sigma = -2.0 * scene.gas().mu_g * (D - div_u / 3.0);
    const Number below = face_mean(scene, axis, I, q(L::nu, -1 * e), q(L::nu));
    const Number above = face_mean(scene, axis, I + e, q(L::nu), q(L::nu, e));
    add_gas_stress(below, out_of_control_volume(scene, axis, I, End::upper, sigma), r[0], r[1]);
    add_gas_stress(above, out_of_control_volume(scene, axis, I + e, End::lower, Number(-sigma)), r[2], r[3]);
  }
};

/// Shear stress on momentum `axis` across the lower `across` faces about edge I, where no barrier is; no-slip walls
/// have theirs below. Nothing changes across open sides of the box: on one normal to `axis` only the half inside is
/// there, and on one normal to `across` only the other component shears.
template <class L, int axis, int across>
struct GasShearStress {
  static constexpr Index a = unit(axis), b = unit(across);
  static constexpr StencilBuilder make_stencil() {
    StencilBuilder s;
    for (const Index& back : {Index{}, b}) s.add(L::u(axis), -1 * back);
    for (const Index& back : {Index{}, a}) s.add(L::u(across), -1 * back);
    for (const Index& cell : {-1 * a - b, Index{} - b, Index{} - a, Index{}}) s.add(L::nu, cell);
    return s;
  }
  static constexpr StencilBuilder stencil = make_stencil();
  static constexpr std::array<Output, 4> rows = gas_stress_rows<L>(axis, -1 * b, Index{});
  static constexpr bool depends(int, const Input&) { return true; }

  static bool active(const Scene& scene, const Index& I) {
    return scene.model.gas_viscous_stress && share(scene, I - a) + share(scene, I) > 0;
  }
  static Reference resolve(const Scene& scene, const Index& I, const Input& input) {
    if (L::is_u(input.component)) return {input.offset, 1};
    Index at = input.offset;  // beyond a side: the cell before it
    for (const int normal : {axis, across})
      if (on_side_of_axis(scene, normal, I)) at[normal] = I[normal] == 0 ? 0 : -1;
    return {at, 1};
  }

  template <class Number, std::size_t count>
  static void evaluate(const Scene& scene, const Index& I, const Local<GasShearStress, Number>& q,
                       std::array<Number, count>& r) {
    const bool side = on_side_of_axis(scene, axis, I);
    const double below = side ? (I[axis] == 0 ? 0 : 1) : scene.lower_share(axis, I);
    const double open = below * share(scene, I - a) + (1 - below) * share(scene, I);
    Number rate(0.0);
    if (!on_side_of_axis(scene, across, I))
      rate += difference_at_face(scene, across, I, q(L::u(axis), -1 * b), q(L::u(axis)));
    if (!side) rate += difference_at_face(scene, axis, I, q(L::u(across), -1 * a), q(L::u(across)));
    const Number sigma = -scene.gas().mu_g * open * rate;
    const Number before = face_mean(scene, axis, I, q(L::nu, -1 * a - b), q(L::nu, -1 * b));
    const Number behind = face_mean(scene, axis, I, q(L::nu, -1 * a), q(L::nu));
    add_gas_stress(before, out_of_cell(scene, across, I - b, End::upper, sigma), r[0], r[1]);
    add_gas_stress(behind, out_of_cell(scene, across, I, End::lower, Number(-sigma)), r[2], r[3]);
  }

 private:
  /// Whether stress acts between cells J - e_across and J.
  static int share(const Scene& scene, const Index& J) {
    const bool above = scene.inside(J), below = scene.inside(J - b);
    if (above == below) return above && !scene.barrier(across, J) ? 1 : 0;
    return scene.barrier(across, J) && scene.kind(across, J).open_to_gas() ? 1 : 0;
  }
};

/// Shear stress of walls to which gas sticks, on u of axis `along`. Anchor I: a cell with such a wall.
template <class L, int along>
struct GasWallStress {
  static constexpr Index t = unit(along);
  static constexpr StencilBuilder make_stencil() {
    StencilBuilder s;
    for (int reach = -1; reach <= 1; ++reach) {
      s.add(L::nu, reach * t);
      if (reach >= 0) s.add(L::u(along), reach * t);
    }
    return s;
  }
  static constexpr StencilBuilder stencil = make_stencil();
  static constexpr std::array<Output, 4> rows = gas_stress_rows<L>(along, Index{}, t);
  static constexpr bool depends(int row, const Input& input) {
    return input.component == L::nu || input.offset == rows[row].offset;
  }

  static bool active(const Scene& scene, const Index& I) {
    if (!scene.model.gas_viscous_stress || !scene.near || !scene.inside(I)) return false;
    for (int normal = 0; normal < L::dim; ++normal)
      for (int side = 0; side < 2; ++side)
        if (sticks(scene, normal, I + side * unit(normal))) return true;
    return false;
  }
  static Reference resolve(const Scene& scene, const Index& I, const Input& input) {
    if (input.component != L::nu) return {input.offset, 1};
    if (input.offset == -1 * t && scene.barrier(along, I)) return {Index{}, 1};
    if (input.offset == t && scene.barrier(along, I + t)) return {Index{}, 1};
    return {input.offset, 1};
  }

  template <class Number, std::size_t count>
  static void evaluate(const Scene& scene, const Index& I, const Local<GasWallStress, Number>& q,
                       std::array<Number, count>& r) {
    for (int normal = 0; normal < L::dim; ++normal) {
      for (int side = 0; side < 2 && normal != along; ++side) {
        const Index face = I + side * unit(normal);
        if (sticks(scene, normal, face)) add(scene, I, q, normal, end_of(side), scene.condition(normal, face), r);
      }
    }
  }

 private:
  static bool sticks(const Scene& scene, int normal, const Index& face) {
    if (normal == along || !closed_to_gas(scene, normal, face)) return false;
    const Condition& condition = scene.condition(normal, face);
    return condition.kind.gas_tangential == GasTangential::wall && condition.gas_no_slip;
  }

  /// The stress of a wall at an end along `normal` on the halves of the control volumes of u that lie in this cell.
  template <class Number, std::size_t count>
  static void add(const Scene& scene, const Index& I, const Local<GasWallStress, Number>& q, int normal, End end,
                  const Condition& wall, std::array<Number, count>& r) {
    for (int side = 0; side < 2; ++side) {
      const Index at = side * t;
      const Number nu = face_mean(scene, along, I + at, q(L::nu, at - t), q(L::nu, at));
      const Number stress =
          scene.gas().mu_g * difference_to_face(scene, normal, I, Number(wall.velocity[along]), q(L::u(along), at));
      const Number share = share_of_cell(scene, along, I, side) * stress;
      add_gas_stress(nu, out_of_cell(scene, normal, I, end, share), r[2 * side], r[2 * side + 1]);
    }
  }
};

}  // namespace scree
