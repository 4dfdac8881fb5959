/// Numbers that carry their first and second derivatives with respect to x, y, z, t: exact fields are written with
/// them, and the sources of all balances follow without a formula being differentiated by hand.
#pragma once

#include <array>
#include <cmath>

#include "scree/math/dual.hpp"

namespace scree::test {

/// Axes 0 ... 2 are space, 3 is time.
struct Jet {
  static constexpr int axes = 4;
  double value = 0;
  std::array<double, axes> first{};
  std::array<std::array<double, axes>, axes> second{};

  Jet() = default;
  Jet(double constant) : value(constant) {}  // implicit on purpose
  static Jet coordinate(double value, int axis) {
    Jet x(value);
    x.first[axis] = 1;
    return x;
  }

  /// f(x) from its value and first two derivatives.
  static Jet compose(double f, double slope, double curvature, const Jet& x) {
    Jet result(f);
    for (int i = 0; i < axes; ++i) {
      result.first[i] = slope * x.first[i];
      for (int j = 0; j < axes; ++j) result.second[i][j] = slope * x.second[i][j] + curvature * x.first[i] * x.first[j];
    }
    return result;
  }

  /// The value with its gradient.
  Dual<axes> number() const {
    Dual<axes> result(value);
    result.derivative = first;
    return result;
  }
  /// The derivative along an axis with its gradient.
  Dual<axes> slope(int axis) const {
    Dual<axes> result(first[axis]);
    result.derivative = second[axis];
    return result;
  }
};

inline Jet operator*(const Jet& a, const Jet& b) {
  Jet c(a.value * b.value);
  for (int i = 0; i < Jet::axes; ++i) {
    c.first[i] = a.first[i] * b.value + a.value * b.first[i];
    for (int j = 0; j < Jet::axes; ++j)
      c.second[i][j] =
          a.second[i][j] * b.value + a.first[i] * b.first[j] + a.first[j] * b.first[i] + a.value * b.second[i][j];
  }
  return c;
}
inline Jet operator+(const Jet& a, const Jet& b) {
  Jet c(a.value + b.value);
  for (int i = 0; i < Jet::axes; ++i) {
    c.first[i] = a.first[i] + b.first[i];
    for (int j = 0; j < Jet::axes; ++j) c.second[i][j] = a.second[i][j] + b.second[i][j];
  }
  return c;
}
inline Jet operator-(const Jet& a, const Jet& b) { return a + Jet(-1) * b; }
inline Jet sin(const Jet& x) { return Jet::compose(std::sin(x.value), std::cos(x.value), -std::sin(x.value), x); }
inline Jet reciprocal(const Jet& x) {
  const double r = 1 / x.value;
  return Jet::compose(r, -r * r, 2 * r * r * r, x);
}

}  // namespace scree::test
