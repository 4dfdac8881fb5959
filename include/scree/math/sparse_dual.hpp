/// Dual numbers of which it is known, when a kernel is compiled, that they depend on few of the unknowns: inputs, and
/// what is made of some of them. Sums and products of these cost as many operations as there are derivatives.
#pragma once

#include "scree/math/dual.hpp"

namespace scree {

/// Unit vector k of n stands at `stored - k` of 0 ... 0 1 0 ... 0.
template <int n>
struct UnitVectors {
  static constexpr int stored = Dual<n>::stored;
  std::array<double, 2 * stored> row{};
  constexpr UnitVectors() { row[stored] = 1; }
};
template <int n>
inline constexpr UnitVectors<n> unit_vectors{};

/// Adds `slope` to derivative k. As a sum of vectors: those that a single number was written to could not be read as a
/// whole until that has reached the cache.
template <int n>
[[gnu::always_inline]] inline void add_derivative(Dual<n>& a, int k, double slope) {
  const double* unit = unit_vectors<n>.row.data() + Dual<n>::stored - k;
  for (int j = 0; j < Dual<n>::stored; ++j) a.derivative[j] += slope * unit[j];
}

/// A value and its derivatives `slope` by the unknowns `at`, k of n; an unknown that is there twice has the sum.
/// Becomes a Dual<n> where one is asked for, or a number of more terms.
template <int n, int k>
struct SparseDual {
  double value;
  std::array<int, k> at;
  std::array<double, k> slope;

  SparseDual() = default;
  SparseDual(double constant) : value(constant), at{}, slope{} {}  // implicit on purpose
  SparseDual(double value_, int unknown, double derivative) : value(value_), at{unknown}, slope{derivative} {
    static_assert(k == 1, "an unknown is one term");
  }
  template <int few, std::enable_if_t<(few < k), int> = 0>
  SparseDual(const SparseDual<n, few>& b) : value(b.value), at{}, slope{} {
    for (int i = 0; i < few; ++i) at[i] = b.at[i], slope[i] = b.slope[i];
  }

  operator Dual<n>() const {
    Dual<n> result(value);
    for (int i = 0; i < k; ++i) add_derivative(result, at[i], slope[i]);
    return result;
  }
};

template <class T>
struct IsSparse : std::false_type {};
template <int n, int k>
struct IsSparse<SparseDual<n, k>> : std::true_type {};

template <int n, int k>
double value_of(const SparseDual<n, k>& x) {
  return x.value;
}

// ---- rules of differentiation: a function of value `value` and slopes f (and g) by its arguments ----

template <int n, int k>
[[gnu::always_inline]] inline SparseDual<n, k> differentiated(double value, double f, const SparseDual<n, k>& a) {
  SparseDual<n, k> c;
  c.value = value;
  for (int i = 0; i < k; ++i) c.at[i] = a.at[i], c.slope[i] = f * a.slope[i];
  return c;
}
template <int n, int k, int m>
[[gnu::always_inline]] inline SparseDual<n, k + m> differentiated(double value, double f, const SparseDual<n, k>& a,
                                                                  double g, const SparseDual<n, m>& b) {
  SparseDual<n, k + m> c;
  c.value = value;
  for (int i = 0; i < k; ++i) c.at[i] = a.at[i], c.slope[i] = f * a.slope[i];
  for (int i = 0; i < m; ++i) c.at[k + i] = b.at[i], c.slope[k + i] = g * b.slope[i];
  return c;
}
template <int n, int m>
[[gnu::always_inline]] inline Dual<n> differentiated(double value, double f, const Dual<n>& a, double g,
                                                     const SparseDual<n, m>& b) {
  Dual<n> c = Dual<n>::compose(value, f, a);
  for (int i = 0; i < m; ++i) add_derivative(c, b.at[i], g * b.slope[i]);
  return c;
}
template <int n, int m>
[[gnu::always_inline]] inline Dual<n> differentiated(double value, double f, const SparseDual<n, m>& a, double g,
                                                     const Dual<n>& b) {
  return differentiated(value, g, b, f, a);
}

// ---- arithmetic ----

template <class A, class B>
using IfSparse = std::enable_if_t<
    (IsSparse<A>::value && (IsSparse<B>::value || IsDual<B>::value)) || (IsDual<A>::value && IsSparse<B>::value), int>;

template <class A, class B, IfSparse<A, B> = 0>
[[gnu::always_inline]] inline auto operator+(const A& a, const B& b) {
  return differentiated(a.value + b.value, 1, a, 1, b);
}
template <class A, class B, IfSparse<A, B> = 0>
[[gnu::always_inline]] inline auto operator-(const A& a, const B& b) {
  return differentiated(a.value - b.value, 1, a, -1, b);
}
template <class A, class B, IfSparse<A, B> = 0>
[[gnu::always_inline]] inline auto operator*(const A& a, const B& b) {
  return differentiated(a.value * b.value, b.value, a, a.value, b);
}
template <class A, class B, IfSparse<A, B> = 0>
[[gnu::always_inline]] inline auto operator/(const A& a, const B& b) {
  const double quotient = a.value / b.value;
  return differentiated(quotient, 1 / b.value, a, -quotient / b.value, b);
}
template <int n, int k>
Dual<n>& operator+=(Dual<n>& a, const SparseDual<n, k>& b) {
  a.value += b.value;
  for (int i = 0; i < k; ++i) add_derivative(a, b.at[i], b.slope[i]);
  return a;
}
template <int n, int k>
Dual<n>& operator-=(Dual<n>& a, const SparseDual<n, k>& b) {
  a.value -= b.value;
  for (int i = 0; i < k; ++i) add_derivative(a, b.at[i], -b.slope[i]);
  return a;
}

/// a[0] + a[1] + ...
template <int n, int k, std::size_t count>
SparseDual<n, k* static_cast<int>(count)> sum(const std::array<SparseDual<n, k>, count>& a) {
  SparseDual<n, k* static_cast<int>(count)> c(0.0);
  int term = 0;
  for (const auto& x : a) {
    c.value += x.value;
    for (int i = 0; i < k; ++i, ++term) c.at[term] = x.at[i], c.slope[term] = x.slope[i];
  }
  return c;
}
template <std::size_t count>
double sum(const std::array<double, count>& a) {
  double c = 0;
  for (const double x : a) c += x;
  return c;
}

template <int n, int k>
SparseDual<n, k> operator-(const SparseDual<n, k>& a) {
  return differentiated(-a.value, -1, a);
}
template <int n, int k>
SparseDual<n, k> operator+(const SparseDual<n, k>& a, double b) {
  return differentiated(a.value + b, 1, a);
}
template <int n, int k>
SparseDual<n, k> operator+(double a, const SparseDual<n, k>& b) {
  return b + a;
}
template <int n, int k>
SparseDual<n, k> operator-(const SparseDual<n, k>& a, double b) {
  return differentiated(a.value - b, 1, a);
}
template <int n, int k>
SparseDual<n, k> operator-(double a, const SparseDual<n, k>& b) {
  return differentiated(a - b.value, -1, b);
}
template <int n, int k>
SparseDual<n, k> operator*(const SparseDual<n, k>& a, double b) {
  return differentiated(a.value * b, b, a);
}
template <int n, int k>
SparseDual<n, k> operator*(double a, const SparseDual<n, k>& b) {
  return differentiated(a * b.value, a, b);
}
template <int n, int k>
SparseDual<n, k> operator/(const SparseDual<n, k>& a, double b) {
  return differentiated(a.value / b, 1 / b, a);
}
template <int n, int k>
SparseDual<n, k> operator/(double a, const SparseDual<n, k>& b) {
  const double quotient = a / b.value;
  return differentiated(quotient, -quotient / b.value, b);
}

inline double square(double a) { return a * a; }
template <int n>
Dual<n> square(const Dual<n>& a) {
  return Dual<n>::compose(a.value * a.value, 2 * a.value, a);
}
template <int n, int k>
SparseDual<n, k> square(const SparseDual<n, k>& a) {
  return differentiated(a.value * a.value, 2 * a.value, a);
}

// Comparisons look at values only: a branch has no derivative.
template <class A, class B>
using IfSparseOrDouble =
    std::enable_if_t<(IsSparse<A>::value && !IsDual<B>::value) || (IsSparse<B>::value && !IsDual<A>::value), bool>;
template <class A, class B>
IfSparseOrDouble<A, B> operator<(const A& a, const B& b) {
  return value_of(a) < value_of(b);
}
template <class A, class B>
IfSparseOrDouble<A, B> operator>(const A& a, const B& b) {
  return value_of(a) > value_of(b);
}
template <class A, class B>
IfSparseOrDouble<A, B> operator<=(const A& a, const B& b) {
  return value_of(a) <= value_of(b);
}
template <class A, class B>
IfSparseOrDouble<A, B> operator>=(const A& a, const B& b) {
  return value_of(a) >= value_of(b);
}

}  // namespace scree
