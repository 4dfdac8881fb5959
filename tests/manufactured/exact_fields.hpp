/// Exact fields of manufactured solutions: smooth, without extrema inside the box, dense, with div v of one sign; near
/// the side under test each takes the form that its condition asks for.
#pragma once

#include <string>

#include "jet.hpp"
#include "scree/boundary/barriers.hpp"

namespace scree::test {

/// All unknowns at a point.
struct Point {
  Jet nu, p, T, chi;
  std::array<Jet, max_dim> v{}, u{};

  /// That of an unknown by its symbol, along an axis if it is a velocity (otherwise any).
  double value(const std::string& symbol, int axis) const {
    if (symbol == "v") return v[axis].value;
    if (symbol == "u") return u[axis].value;
    return (symbol == "nu" ? nu : symbol == "p_g" ? p : symbol == "T" ? T : chi).value;
  }
};

/// How a field behaves at the side under test, s being the distance from it.
enum class Shape {
  plain,  ///< no condition
  even,   ///< in s: no normal gradient
  odd,    ///< in s
  held,   ///< constant along the side, with a gradient
  flat,   ///< constant along the side, without a gradient
};

/// What is chosen of a manufactured solution.
struct ExactFields {
  int dim = 2;
  double length = 0.02;  ///< of the box in each direction [m]
  bool dilating = true;  ///< sign of div v
  bool moving_in_time = false;
  /// Condition on the lower side of axis 1; none: no side is under test.
  bool tests_side = false;
  BoundaryKind kind = BoundaryKind::symmetry;
  double gas_inflow = 0.3;  ///< superficial velocity through that side, where it brings gas [m/s]
  /// Normal gradients on a wall of Johnson & Jackson, such that (25) and (26) hold there [1/s, m/s2].
  double shear_at_wall = 0, T_gradient_at_wall = 0;
  bool nu_varies_at_wall = false;  ///< whether nu and chi have a normal gradient there
  bool darcy = false;              ///< gas darcy: p_g has the normal gradient that the flow through the side asks for
  static constexpr double inlet_gradient = -500;  ///< of p_g there, where gas comes in [Pa/m]

  Point at(const std::array<double, max_dim>& x, double time) const {
    std::array<Jet, Jet::axes> X;
    for (int a = 0; a < dim; ++a) X[a] = Jet::coordinate(x[a], a) * Jet(1 / length);
    if (moving_in_time) X[3] = Jet::coordinate(time, 3) * Jet(1 / period);

    Point q;
    q.nu = field(X, {.5, .4, .3, .3}, .15, .565, .02, nu_shape());
    q.T = field(X, {.4, .5, -.3, .4}, .45, 1e-4, 1e-4, T_shape());
    q.chi = field(X, {-.4, .5, .4, .3}, .6, dilating ? .84 : 1.02, dilating ? .12 : .02, chi_shape());
    q.p = field(X, {.5, -.5, .4, .5}, .65, is(BoundaryKind::open) ? 0 : 5, 12, p_shape());
    const double V = dilating ? .03 : -.03;
    for (int a = 0; a < dim; ++a) {
      std::array<double, 4> wave{.25, .3, .2, .4};
      wave[a] = .7;
      const bool normal = tests_side && a == 1;
      const double base = v_base(a, normal);
      q.v[a] = field(X, wave, .1, base, V, v_shape(normal));
      wave[a] = .5;
      q.u[a] = field(X, wave, .15, u_base(a, normal), .06, u_shape(normal));
    }
    if (is(BoundaryKind::wall_johnson_jackson)) {
      const Jet distance = X[1] * Jet(length);
      q.T = q.T + Jet(T_gradient_at_wall) * distance;
      for (int a = 0; a < dim; ++a) q.v[a] = q.v[a] + Jet(a == 1 ? 1.5 * V / length : shear_at_wall) * distance;
    }
    if (tests_side && darcy && kind.brings_gas()) q.p = q.p + Jet(inlet_gradient * length) * X[1];
    if (is(BoundaryKind::gas_inlet)) q.u[1] = Jet(gas_inflow) * reciprocal(Jet(1) - q.nu) + q.u[1];
    return q;
  }

  static constexpr double fast = 2;      ///< [m/s]
  static constexpr double period = .02;  ///< of changes in time, over 2 pi [s]

 private:
  bool is(BoundaryKind k) const { return tests_side && kind == k; }

  Shape nu_shape() const {
    if (is(BoundaryKind::symmetry) || is(BoundaryKind::open)) return Shape::even;
    const bool constant =
        is(BoundaryKind::inlet) || is(BoundaryKind::wall_johnson_jackson) || (is(BoundaryKind::gas_inlet) && darcy);
    if (is(BoundaryKind::wall_johnson_jackson) && !nu_varies_at_wall) return Shape::flat;
    return constant ? Shape::held : Shape::plain;
  }
  Shape chi_shape() const { return nu_shape(); }
  Shape T_shape() const {
    if (is(BoundaryKind::inlet) || is(BoundaryKind::wall_johnson_jackson)) return Shape::flat;
    return tests_side ? Shape::even : Shape::plain;
  }
  Shape p_shape() const {
    if (is(BoundaryKind::symmetry)) return Shape::even;
    if (is(BoundaryKind::open)) return Shape::held;
    if (!tests_side || !darcy) return Shape::plain;
    return kind.brings_gas() ? Shape::flat : Shape::even;
  }
  Shape v_shape(bool normal) const {
    if (!tests_side) return Shape::plain;
    if (is(BoundaryKind::inlet)) return normal ? Shape::held : Shape::flat;
    if (is(BoundaryKind::open)) return normal ? Shape::flat : Shape::even;  // and so no shear
    if (is(BoundaryKind::wall_johnson_jackson)) return Shape::flat;
    if (normal) return Shape::odd;
    return is(BoundaryKind::wall_no_slip) ? Shape::held : Shape::even;
  }
  Shape u_shape(bool normal) const {
    if (!tests_side) return Shape::plain;
    if (is(BoundaryKind::open)) return normal ? Shape::flat : Shape::even;
    if (is(BoundaryKind::inlet) || is(BoundaryKind::gas_inlet)) return Shape::held;
    if (normal) return Shape::odd;
    return is(BoundaryKind::symmetry) ? Shape::even : Shape::plain;
  }
  double v_base(int axis, bool normal) const {
    if (is(BoundaryKind::wall_johnson_jackson))
      return normal ? 0 : .012;  // slip works about as much as collisions take
    if (normal && is(BoundaryKind::open)) return -fast;
    return axis == 0 ? .8 * fast : axis == 1 ? fast : -.5 * fast;
  }
  double u_base(int axis, bool normal) const {
    if (is(BoundaryKind::inlet)) return normal ? gas_inflow / (1 - .565) : 0;
    if (is(BoundaryKind::gas_inlet)) return 0;
    if (normal && is(BoundaryKind::open)) return -.3 - fast;
    return axis == 1 ? fast + .3 : .8 * fast + .15;
  }

  /// The angles stay between 0 and pi/2: no derivative vanishes, and errors have their orders on coarse grids already.
  Jet field(const std::array<Jet, Jet::axes>& X, std::array<double, 4> wave, double phase, double base,
            double amplitude, Shape shape) const {
    const Jet& s = X[1];
    const bool curved = shape == Shape::even || shape == Shape::odd;
    Jet angle(phase);
    for (int a = 0; a < Jet::axes; ++a) angle = angle + Jet(wave[a]) * (curved && a == 1 ? s * s : X[a]);
    const Jet wavy = sin(angle);
    switch (shape) {
      case Shape::odd:
        return Jet(amplitude) * s * (Jet(1.5) + wavy);
      case Shape::held:
        return Jet(base) + Jet(amplitude) * s * (Jet(1.2) + wavy);
      case Shape::flat:
        return Jet(base) + Jet(amplitude) * s * s * (Jet(1.2) + wavy);
      default:
        return Jet(base) + Jet(amplitude) * wavy;
    }
  }
};

}  // namespace scree::test
