/// What closures chosen at run time share: a variant is a type with one templated pure function, made into an entry
/// (name, source, pointers to the function for the number types that callers use) that a list of its idea holds.
#pragma once

#include <tuple>
#include <vector>

#include "scree/math/through.hpp"

namespace scree {

/// Pointers to one templated function for several number types; std::get<Pointer<Number>> picks.
template <template <class> class Pointer, class... Numbers>
using PerNumber = std::tuple<Pointer<Numbers>...>;

/// The entries that options offer, in this order. Those from outside are appended before a case is read.
template <class Entry>
using Variants = std::vector<const Entry*>;

/// f(nu) of a function known for double and Dual<1>: others go through the latter.
template <template <class> class Pointer, class Number, class... Rest>
Number by_one_argument(const PerNumber<Pointer, double, Dual<1>>& f, const Number& x, const Rest&... rest) {
  if constexpr (std::is_same_v<Number, double> || std::is_same_v<Number, Dual<1>>)
    return std::get<Pointer<Number>>(f)(x, rest...);
  else
    return through(
        [&](const auto& inner) { return std::get<Pointer<std::decay_t<decltype(inner)>>>(f)(inner, rest...); }, x);
}

}  // namespace scree
