/// The form of a kernel: a small piece of the residual about an anchor cell, with a fixed list of unknowns that it
/// reads and of equations that it adds to. One source gives the residual (Number = double), the dense block of the
/// Jacobian (Number = Dual<inputs>) and the sparsity pattern (the lists alone).
///
/// A kernel is a type with
///   static constexpr auto stencil      its inputs, a StencilBuilder
///   static constexpr std::array rows   its outputs, Output{component, offset of the cell from the anchor}
///   static constexpr bool depends(int row, const Input&)         which input a row can depend on
///   static bool active(const Scene&, const Index& I)             whether it exists at anchor I
///   static Reference resolve(const Scene&, const Index& I, const Input&)   where an input is read near barriers
///   static constexpr bool has_rates = true                       if it asks for time derivatives
///   static void evaluate(const Scene&, const Index& I, const Local<Kernel, Number>& q, std::array<Number, rows>& r)
///
/// An input is a number of one term, and what is made of few inputs one of few terms (math/sparse_dual.hpp): `auto`
/// keeps it so, `Number` makes it one that may depend on all. Where an input stands is known when a kernel is compiled,
/// provided that all of evaluate is inlined: that of kernels at every cell is marked [[gnu::flatten]], and what happens
/// beside barriers alone is a function of its own, [[gnu::noinline]].
#pragma once

#include <algorithm>
#include <cstdint>

#include "scree/grid/index.hpp"
#include "scree/math/sparse_dual.hpp"

namespace scree {

/// The most unknowns that a node may have: rows that are balances are bits of 16.
inline constexpr int most_unknowns = 16;

/// An unknown that a kernel reads: component and cell relative to the anchor.
struct Input {
  int component = 0;
  Index offset;
};

/// An equation that a kernel adds to.
struct Output {
  int component = 0;
  Index offset;
};

/// Where the value of an input comes from: factor times the component at anchor + offset.
struct Reference {
  Index offset;
  double factor = 1;
};

/// A list of inputs without duplicates, made at compile time.
struct StencilBuilder {
  static constexpr int capacity = 127;
  std::array<Input, capacity> inputs{};
  int size = 0;

  constexpr int find(int component, const Index& offset) const {
    for (int k = 0; k < size; ++k)
      if (inputs[static_cast<std::size_t>(k)].component == component &&
          inputs[static_cast<std::size_t>(k)].offset == offset)
        return k;
    return -1;
  }
  /// Negative components are absent unknowns.
  constexpr void add(int component, const Index& offset) {
    if (component >= 0 && find(component, offset) < 0)
      inputs[static_cast<std::size_t>(size++)] = Input{component, offset};
  }
};

/// Position of each (component, offset) in a stencil, as a table no larger than the stencil: compilers fill it for
/// every kernel.
template <class Kernel>
struct StencilTable {
  /// The least (sign -1) or greatest (sign 1) offset of an input along each axis.
  static constexpr Index bound(int sign) {
    Index result;
    for (int k = 0; k < Kernel::stencil.size; ++k)
      for (int axis = 0; axis < max_dim; ++axis) {
        const int at = Kernel::stencil.inputs[static_cast<std::size_t>(k)].offset[axis];
        if (sign * at > sign * result[axis]) result[axis] = at;
      }
    return result;
  }
  static constexpr int count_components() {
    int count = 0;
    for (int k = 0; k < Kernel::stencil.size; ++k)
      count = std::max(count, Kernel::stencil.inputs[static_cast<std::size_t>(k)].component + 1);
    return count;
  }
  static constexpr Index low = bound(-1), high = bound(1);
  static constexpr int width_0 = high[0] - low[0] + 1, width_1 = high[1] - low[1] + 1, width_2 = high[2] - low[2] + 1;
  std::array<std::int8_t, static_cast<std::size_t>(count_components() * width_2 * width_1 * width_0)> position{};

  static constexpr std::size_t code(int component, const Index& offset) {
    return static_cast<std::size_t>(
        ((component * width_2 + offset[2] - low[2]) * width_1 + offset[1] - low[1]) * width_0 + offset[0] - low[0]);
  }
  constexpr StencilTable() {
    for (auto& entry : position) entry = -1;
    for (int k = 0; k < Kernel::stencil.size; ++k) {
      const Input& input = Kernel::stencil.inputs[static_cast<std::size_t>(k)];
      position[code(input.component, input.offset)] = static_cast<std::int8_t>(k);
    }
  }
};
template <class Kernel>
inline constexpr StencilTable<Kernel> stencil_table{};

/// Whether a kernel asks for time derivatives: others need not be given any.
template <class Kernel, class = void>
struct HasRates : std::false_type {};
template <class Kernel>
struct HasRates<Kernel, std::enable_if_t<Kernel::has_rates>> : std::true_type {};

/// Number, or what is left of it where it depends on k inputs alone.
template <class Number, int k>
struct FewOf {
  using Type = Number;
};
template <int n, int k>
struct FewOf<Dual<n>, k> {
  using Type = SparseDual<n, k>;
};

/// The unknowns about an anchor, and their rates, as a kernel sees them (SI).
template <class Kernel, class Number_>
struct Local {
  using Number = Number_;
  static constexpr std::size_t size = Kernel::stencil.size, rates = HasRates<Kernel>::value ? size : 0;

  /// A number that depends on k of the inputs, an input being one of itself. Number is one that may depend on all.
  template <int k>
  using Few = typename FewOf<Number, k>::Type;

  std::array<double, size> value;
  std::array<double, IsDual<Number>::value ? size : 0> slope;  ///< d value/d stored unknown, its scale
  std::array<double, rates> rate;                              ///< time derivatives
  std::array<double, rates> rate_slope;                        ///< d rate/d stored unknown, shift times scale

  [[gnu::always_inline]] static int position(int component, const Index& offset) {
    return stencil_table<Kernel>.position[StencilTable<Kernel>::code(component, offset)];
  }
  [[gnu::always_inline]] Few<1> operator()(int component, const Index& offset = {}) const {
    const int k = position(component, offset);
    if constexpr (IsDual<Number>::value)
      return Few<1>(value[static_cast<std::size_t>(k)], k, slope[static_cast<std::size_t>(k)]);
    else
      return value[static_cast<std::size_t>(k)];
  }
  /// Time derivative of an input.
  [[gnu::always_inline]] Few<1> dot(int component, const Index& offset = {}) const {
    static_assert(rates > 0, "a kernel that asks for rates says so by has_rates");
    const int k = position(component, offset);
    if constexpr (IsDual<Number>::value)
      return Few<1>(rate[static_cast<std::size_t>(k)], k, rate_slope[static_cast<std::size_t>(k)]);
    else
      return rate[static_cast<std::size_t>(k)];
  }
};

}  // namespace scree
