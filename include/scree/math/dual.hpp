/// Forward-mode dual numbers, and `through`, which differentiates an expensive function with respect to its few
/// arguments and chains the result to the many unknowns these depend on.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

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

/// The number type of an expression of all Z: the Dual among them, or double.
template <class... Z>
struct CommonNumber {
  using Type = double;
};
template <class First, class... Rest>
struct CommonNumber<First, Rest...> {
  using Type = std::conditional_t<IsDual<First>::value, First, typename CommonNumber<Rest...>::Type>;
};

/// Chain rule: `inner` as a function of m intermediate numbers `*outer[0..m-1]`, themselves functions of N unknowns.
template <int m, int N>
Dual<N> chain(const Dual<m>& inner, const Dual<N>* const* outer) {
  Dual<N> result;
  result.value = inner.value;
  constexpr int stored = Dual<N>::stored;
  std::array<double, stored> sum;  // local: the compiler need not fear that it overlaps with *outer
  for (int j = 0; j < stored; ++j) {
    double derivative = inner.derivative[0] * outer[0]->derivative[j];
    for (int i = 1; i < m; ++i) derivative += inner.derivative[i] * outer[i]->derivative[j];
    sum[j] = derivative;
  }
  result.derivative = sum;
  return result;
}
template <int m, int N, std::size_t count>
std::array<Dual<N>, count> chain(const std::array<Dual<m>, count>& inner, const Dual<N>* const* outer) {
  std::array<Dual<N>, count> result;
  for (std::size_t i = 0; i < count; ++i) result[i] = chain(inner[i], outer);
  return result;
}

/// f(z...) with derivatives, f being evaluated with as many derivatives as there are Duals among its arguments and not
/// with as many as there are unknowns. f takes one number type and returns a number or a std::array of numbers, e.g.
///     auto [pressure, viscosity] = through([&](const auto& nu, const auto& T) { return f(nu, T, parameters); }, nu,
///     T);
/// Plain doubles among the arguments are constants; if all are, this is f(z...).
template <class Function, class... Z>
auto through(Function&& f, const Z&... z) {
  using Number = typename CommonNumber<Z...>::Type;
  if constexpr (std::is_same_v<Number, double>) {
    return f(static_cast<double>(z)...);
  } else {
    constexpr int m = (0 + ... + int{IsDual<Z>::value});
    std::array<const Number*, m> outer;
    int next = 0;
    const auto seed = [&](const auto& x) {
      if constexpr (IsDual<std::decay_t<decltype(x)>>::value) {
        static_assert(std::is_same_v<std::decay_t<decltype(x)>, Number>, "arguments with different unknowns");
        outer[static_cast<std::size_t>(next)] = &x;
        return Dual<m>::variable(x.value, next++);
      } else {
        return Dual<m>(x);
      }
    };
    const std::array<Dual<m>, sizeof...(Z)> inner{seed(z)...};  // braces: in the order of the arguments
    return chain(std::apply(f, inner), outer.data());
  }
}

}  // namespace scree
