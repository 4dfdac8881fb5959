/// `through`: differentiates an expensive function with respect to its few arguments, and chains the result to the many
/// unknowns that these depend on.
#pragma once

#include <tuple>
#include <utility>

#include "scree/math/sparse_dual.hpp"

namespace scree {

/// What an expression of all Z is a number of: double, SparseDual of as many terms as all have together, or Dual.
template <class... Z>
struct Joint {
  using Type = double;  ///< of the function of all
};
template <int n, int k>
struct Joint<SparseDual<n, k>> {
  using Type = SparseDual<n, k>;
};
template <int n>
struct Joint<Dual<n>> {
  using Type = Dual<n>;
};
template <class... Rest>
struct Joint<double, Rest...> : Joint<Rest...> {};
template <int n, int k, class... Rest>
struct Joint<SparseDual<n, k>, double, Rest...> : Joint<SparseDual<n, k>, Rest...> {};
template <int n, int k, int m, class... Rest>
struct Joint<SparseDual<n, k>, SparseDual<n, m>, Rest...> : Joint<SparseDual<n, k + m>, Rest...> {};
template <int n, int k, class... Rest>
struct Joint<SparseDual<n, k>, Dual<n>, Rest...> : Joint<Dual<n>, Rest...> {};
template <int n, class Second, class... Rest>
struct Joint<Dual<n>, Second, Rest...> : Joint<Dual<n>, Rest...> {
  static_assert(std::is_same_v<Second, double> || std::is_same_v<Second, Dual<n>> || IsSparse<Second>::value,
                "arguments with different unknowns");
};

/// Adds slope times the derivatives of an argument to those of a result, whose next free term is `term`.
template <int N, int k, int m>
[[gnu::always_inline]] inline void add_terms(SparseDual<N, k>& result, int& term, double slope,
                                             const SparseDual<N, m>& z) {
  for (int i = 0; i < m; ++i, ++term) result.at[term] = z.at[i], result.slope[term] = slope * z.slope[i];
}
template <int N, int m>
[[gnu::always_inline]] inline void add_terms(Dual<N>& result, int&, double slope, const SparseDual<N, m>& z) {
  for (int i = 0; i < m; ++i) add_derivative(result, z.at[i], slope * z.slope[i]);
}

/// The chain rule: `inner`, a function of numbers of which all but the doubles among z are arguments.
template <class Number>
struct Chain;
template <int N, int k>
struct Chain<SparseDual<N, k>> {
  template <int m, class... Z>
  static SparseDual<N, k> rule(const Dual<m>& inner, const Z&... z) {
    SparseDual<N, k> result;
    result.value = inner.value;
    int argument = 0, term = 0;
    const auto add = [&](const auto& x) {
      if constexpr (IsSparse<std::decay_t<decltype(x)>>::value)
        add_terms(result, term, inner.derivative[argument++], x);
    };
    (add(z), ...);
    return result;
  }
};
template <int N>
struct Chain<Dual<N>> {
  template <int m, class... Z>
  static Dual<N> rule(const Dual<m>& inner, const Z&... z) {
    constexpr int stored = Dual<N>::stored, dense = (0 + ... + int{IsDual<Z>::value});
    // The dense ones together: one pass over the derivatives.
    std::array<const Dual<N>*, dense> outer;
    std::array<double, dense> slope;
    int argument = 0, next = 0;
    const auto list = [&](const auto& x) {
      using X = std::decay_t<decltype(x)>;
      if constexpr (IsDual<X>::value) outer[next] = &x, slope[next++] = inner.derivative[argument];
      if constexpr (!std::is_same_v<X, double>) ++argument;
    };
    (list(z), ...);
    Dual<N> result;
    result.value = inner.value;
    std::array<double, stored> sum;  // local: the compiler need not fear that it overlaps with *outer
    for (int j = 0; j < stored; ++j) {
      double derivative = slope[0] * outer[0]->derivative[j];
      for (int i = 1; i < dense; ++i) derivative += slope[i] * outer[i]->derivative[j];
      sum[j] = derivative;
    }
    result.derivative = sum;
    int term = 0;
    argument = 0;
    const auto add = [&](const auto& x) {
      using X = std::decay_t<decltype(x)>;
      if constexpr (IsSparse<X>::value) add_terms(result, term, inner.derivative[argument], x);
      if constexpr (!std::is_same_v<X, double>) ++argument;
    };
    (add(z), ...);
    return result;
  }
};

template <class Number, int m, class... Z>
Number chain(const Dual<m>& inner, const Z&... z) {
  return Chain<Number>::rule(inner, z...);
}
template <class Number, int m, std::size_t count, class... Z>
std::array<Number, count> chain(const std::array<Dual<m>, count>& inner, const Z&... z) {
  std::array<Number, count> result;
  for (std::size_t i = 0; i < count; ++i) result[i] = Chain<Number>::rule(inner[i], z...);
  return result;
}

/// f(z...) with derivatives, f being evaluated with as many derivatives as there are dual numbers among its arguments
/// and not with as many as there are unknowns. f takes one number type and returns a number or a std::array of numbers,
/// e.g.
///     auto [pressure, viscosity] = through([&](const auto& nu, const auto& T) { return f(nu, T, parameters); }, nu,
///     T);
/// Plain doubles among the arguments are constants; if all are, this is f(z...).
template <class Function, class... Z>
auto through(Function&& f, const Z&... z) {
  using Number = typename Joint<Z...>::Type;
  if constexpr (std::is_same_v<Number, double>) {
    return f(static_cast<double>(z)...);
  } else {
    constexpr int m = (0 + ... + int{!std::is_same_v<Z, double>});
    int next = 0;
    const auto seed = [&](const auto& x) {
      if constexpr (std::is_same_v<std::decay_t<decltype(x)>, double>)
        return Dual<m>(x);
      else
        return Dual<m>::variable(x.value, next++);
    };
    const std::array<Dual<m>, sizeof...(Z)> inner{seed(z)...};  // braces: in the order of the arguments
    return chain<Number>(std::apply(f, inner), z...);
  }
}

}  // namespace scree
