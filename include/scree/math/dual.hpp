/// Forward-mode dual numbers.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace scree {

// Kernels call sqrt(x) unqualified for double and Dual alike; the overloads below would hide the standard ones.
using std::cbrt;
using std::exp;
using std::log;
using std::pow;
using std::sqrt;
using std::tanh;

/// A value and its derivatives with respect to n unknowns. A double converts to a constant.
/// `Dual<n> x;` is uninitialised as `double x;` is, `Dual<n> x{};` is zero: the same kernel runs with both types.
template <int n>
struct Dual {
  static_assert(n > 0, "a Dual has at least one derivative");
  /// Derivatives are stored, and computed, in whole vector registers: those beyond n say nothing.
  static constexpr int stored = n < 3 ? n : (n + 3) / 4 * 4;
  double value;
  // A cache line where there are many: a quarter to a half less time, and the same wherever the stack happens to lie.
  alignas(n < 8 ? 8 : 64) std::array<double, stored> derivative;

  Dual() = default;
  // Member by member: the compiler's own copies take the value and what pads it in one register, which has to wait
  // until a value just computed has reached the cache.
  Dual(const Dual& b) : value(b.value), derivative(b.derivative) {}
  Dual& operator=(const Dual& b) {
    value = b.value;
    derivative = b.derivative;
    return *this;
  }
  Dual(double constant) : value(constant), derivative{} {}  // implicit on purpose

  /// Unknown number `index` (0 <= index < n) with derivative one.
  static Dual variable(double value, int index) {
    Dual x(value);
    x.derivative[static_cast<std::size_t>(index)] = 1;
    return x;
  }

  Dual& operator+=(const Dual& b) {
    value += b.value;
    for (int j = 0; j < stored; ++j) derivative[j] += b.derivative[j];
    return *this;
  }
  Dual& operator-=(const Dual& b) {
    value -= b.value;
    for (int j = 0; j < stored; ++j) derivative[j] -= b.derivative[j];
    return *this;
  }
  Dual& operator*=(const Dual& b) { return *this = *this * b; }
  Dual& operator/=(const Dual& b) { return *this = *this / b; }
  Dual& operator+=(double b) {
    value += b;
    return *this;
  }
  Dual& operator-=(double b) {
    value -= b;
    return *this;
  }
  Dual& operator*=(double b) {
    value *= b;
    for (int j = 0; j < stored; ++j) derivative[j] *= b;
    return *this;
  }
  Dual& operator/=(double b) {
    const double inverse = 1 / b;
    value /= b;
    for (int j = 0; j < stored; ++j) derivative[j] *= inverse;
    return *this;
  }

  /// A function of one argument: its value and its slope at `x`.
  static Dual compose(double value, double slope, const Dual& x) {
    Dual result;
    result.value = value;
    for (int j = 0; j < stored; ++j) result.derivative[j] = slope * x.derivative[j];
    return result;
  }
};

template <int n>
Dual<n> operator+(const Dual<n>& a) {
  return a;
}
template <int n>
Dual<n> operator-(const Dual<n>& a) {
  return Dual<n>::compose(-a.value, -1, a);
}

template <int n>
Dual<n> operator+(const Dual<n>& a, const Dual<n>& b) {
  Dual<n> c;
  c.value = a.value + b.value;
  for (int j = 0; j < Dual<n>::stored; ++j) c.derivative[j] = a.derivative[j] + b.derivative[j];
  return c;
}
template <int n>
Dual<n> operator-(const Dual<n>& a, const Dual<n>& b) {
  Dual<n> c;
  c.value = a.value - b.value;
  for (int j = 0; j < Dual<n>::stored; ++j) c.derivative[j] = a.derivative[j] - b.derivative[j];
  return c;
}
template <int n>
Dual<n> operator*(const Dual<n>& a, const Dual<n>& b) {
  Dual<n> c;
  c.value = a.value * b.value;
  for (int j = 0; j < Dual<n>::stored; ++j) c.derivative[j] = a.derivative[j] * b.value + a.value * b.derivative[j];
  return c;
}
template <int n>
Dual<n> operator/(const Dual<n>& a, const Dual<n>& b) {
  Dual<n> c;
  const double inverse = 1 / b.value;
  c.value = a.value / b.value;  // not a * inverse: the value shall be the one of plain doubles
  for (int j = 0; j < Dual<n>::stored; ++j) c.derivative[j] = (a.derivative[j] - c.value * b.derivative[j]) * inverse;
  return c;
}

template <int n>
Dual<n> operator+(const Dual<n>& a, double b) {
  Dual<n> c = a;
  c.value += b;
  return c;
}
template <int n>
Dual<n> operator+(double a, const Dual<n>& b) {
  return b + a;
}
template <int n>
Dual<n> operator-(const Dual<n>& a, double b) {
  Dual<n> c = a;
  c.value -= b;
  return c;
}
template <int n>
Dual<n> operator-(double a, const Dual<n>& b) {
  return Dual<n>::compose(a - b.value, -1, b);
}
template <int n>
Dual<n> operator*(const Dual<n>& a, double b) {
  return Dual<n>::compose(a.value * b, b, a);
}
template <int n>
Dual<n> operator*(double a, const Dual<n>& b) {
  return Dual<n>::compose(a * b.value, a, b);
}
template <int n>
Dual<n> operator/(const Dual<n>& a, double b) {
  return Dual<n>::compose(a.value / b, 1 / b, a);
}
template <int n>
Dual<n> operator/(double a, const Dual<n>& b) {
  const double quotient = a / b.value;
  return Dual<n>::compose(quotient, -quotient / b.value, b);
}

/// The plain value of a number.
inline double value_of(double x) { return x; }
template <int n>
double value_of(const Dual<n>& x) {
  return x.value;
}

// Comparisons look at values only: a branch has no derivative.
#define SCREE_DUAL_COMPARISON(op)                        \
  template <int n>                                       \
  bool operator op(const Dual<n>& a, const Dual<n>& b) { \
    return a.value op b.value;                           \
  }                                                      \
  template <int n>                                       \
  bool operator op(const Dual<n>& a, double b) {         \
    return a.value op b;                                 \
  }                                                      \
  template <int n>                                       \
  bool operator op(double a, const Dual<n>& b) {         \
    return a op b.value;                                 \
  }
SCREE_DUAL_COMPARISON(<)
SCREE_DUAL_COMPARISON(<=)
SCREE_DUAL_COMPARISON(>)
SCREE_DUAL_COMPARISON(>=)
SCREE_DUAL_COMPARISON(==)
SCREE_DUAL_COMPARISON(!=)
#undef SCREE_DUAL_COMPARISON

/// Square root of x > 0 (x = 0: infinite derivative; closures add a floor).
template <int n>
Dual<n> sqrt(const Dual<n>& x) {
  const double root = std::sqrt(x.value);
  return Dual<n>::compose(root, 0.5 / root, x);
}
/// Cube root of x != 0.
template <int n>
Dual<n> cbrt(const Dual<n>& x) {
  const double root = std::cbrt(x.value);
  return Dual<n>::compose(root, root / (3 * x.value), x);
}
/// x^exponent for x > 0, and for x = 0 where the exponent is at least 1.
template <int n>
Dual<n> pow(const Dual<n>& x, double exponent) {
  const double power = std::pow(x.value, exponent);
  const double slope = x.value != 0 ? exponent * power / x.value : exponent * std::pow(x.value, exponent - 1);
  return Dual<n>::compose(power, slope, x);
}
template <int n>
Dual<n> exp(const Dual<n>& x) {
  const double e = std::exp(x.value);
  return Dual<n>::compose(e, e, x);
}
template <int n>
Dual<n> log(const Dual<n>& x) {
  return Dual<n>::compose(std::log(x.value), 1 / x.value, x);
}
template <int n>
Dual<n> tanh(const Dual<n>& x) {
  const double t = std::tanh(x.value);
  return Dual<n>::compose(t, 1 - t * t, x);
}

/// x^exponent for a small integer exponent >= 0, by multiplications.
template <class Number>
Number integer_power(const Number& x, int exponent) {
  Number result = 1.0, square = x;
  for (; exponent > 0; exponent /= 2) {
    if (exponent % 2 == 1) result = result * square;
    if (exponent > 1) square = square * square;
  }
  return result;
}

template <class T>
struct IsDual : std::false_type {};
template <int n>
struct IsDual<Dual<n>> : std::true_type {};

}  // namespace scree
