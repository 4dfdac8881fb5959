/// What turns kernels into residual, Jacobian and pattern, whatever the layout: each kernel is compiled once for all
/// layouts that use it.
#pragma once

#include <utility>

#include "scree/assembly/entries.hpp"
#include "scree/assembly/kernel.hpp"
#include "scree/assembly/scene.hpp"

namespace scree {

/// Which inputs the rows of a kernel depend on, listed row by row at compile time.
template <class Kernel>
struct Dependences {
  static constexpr std::size_t rows = Kernel::rows.size(), inputs = Kernel::stencil.size;
  std::array<std::size_t, rows> count{};
  std::array<std::array<std::uint8_t, inputs>, rows> input{};

  constexpr Dependences() {
    for (std::size_t k = 0; k < rows; ++k)
      for (std::size_t j = 0; j < inputs; ++j)
        if (Kernel::depends(static_cast<int>(k), Kernel::stencil.inputs[j]))
          input[k][count[k]++] = static_cast<std::uint8_t>(j);
  }
};

/// The place of unknowns, their scales and the rows that are balances, and the visitors of kernels.
struct Assembly {
  Scene scene;                                         ///< at whatever time: visitors are given one at theirs
  int unknowns;                                        ///< a node
  std::array<double, most_unknowns> scale, row_scale;  ///< of unknowns and of rows, one a component
  std::vector<std::uint16_t> balance;                  ///< bits of the rows that are balances, over ghosted nodes
  std::vector<std::uint8_t> plain;                     ///< whether nothing is special about an anchor, over the same

  int ghosted_unknown(int component, const Index& I) const { return scene.lattice.ghosted(I) * unknowns + component; }
  int owned_unknown(int component, const Index& I) const { return scene.lattice.owned(I) * unknowns + component; }

  /// Marks the anchors that are far from barriers and from other ranks, and about which every row is a balance: all
  /// that a kernel touches lies within the width of the ghost layer.
  void mark_plain() {
    const Lattice& grid = scene.lattice;
    const auto all = static_cast<std::uint16_t>((1U << unknowns) - 1);
    plain.assign(static_cast<std::size_t>(grid.ghosted_size()), 0);
    for_each_node(grid.owned_first, grid.owned_count, [&](const Index& I) {
      bool special = scene.barriers.near(I);
      for_each_offset(grid, [&](const Index& offset) {
        special = special || !grid.is_owned(I + offset) || balance[grid.ghosted(I + offset)] != all;
      });
      plain[grid.ghosted(I)] = !special;
    });
  }

  /// The rows of a kernel that are balances of this rank, as bits; 0 if the kernel has nothing to do at I. Nodes of
  /// other ranks have no bits set in balance.
  template <class Kernel>
  unsigned rows_at(const Scene& here, const Index& I) const {
    const int base = scene.lattice.ghosted(I);
    if (plain[static_cast<std::size_t>(base)]) return Kernel::active(here, I) ? (1U << Kernel::rows.size()) - 1 : 0;
    unsigned rows = 0;
    for (std::size_t k = 0; k < Kernel::rows.size(); ++k) {
      const int node = base + scene.lattice.ghosted_stride(Kernel::rows[k].offset);
      rows |= (balance[static_cast<std::size_t>(node)] >> Kernel::rows[k].component & 1U) << k;
    }
    return rows != 0 && Kernel::active(here, I) ? rows : 0;
  }

  /// Where the inputs of a kernel are read: ghosted unknowns, and what they are to be multiplied by.
  template <class Kernel>
  struct Sources {
    static constexpr std::size_t size = Kernel::stencil.size;
    std::array<int, size> unknown;
    std::array<double, size> factor;
  };

  template <class Kernel>
  [[gnu::noinline]] void resolve(const Scene& here, const Index& I, Sources<Kernel>& from) const {
    const int base = scene.lattice.ghosted(I);
    for (std::size_t k = 0; k < Sources<Kernel>::size; ++k) {
      const Input& input = Kernel::stencil.inputs[k];
      const Reference source = here.near ? Kernel::resolve(here, I, input) : Reference{input.offset, 1};
      from.unknown[k] = (base + scene.lattice.ghosted_stride(source.offset)) * unknowns + input.component;
      from.factor[k] = source.factor * scale[input.component];
    }
  }

  template <class Kernel, class Number>
  void gather(const Scene& here, const double* state, const double* rate, double shift, const Index& I,
              Local<Kernel, Number>& q) const {
    constexpr bool has_rates = HasRates<Kernel>::value;
    const auto take = [&](std::size_t k, int unknown, double si) {
      q.value[k] = si * state[unknown];
      if constexpr (has_rates) q.rate[k] = si * rate[unknown];
      if constexpr (IsDual<Number>::value) {
        q.slope[k] = si;
        if constexpr (has_rates) q.rate_slope[k] = shift * si;
      }
    };
    if (here.near) {
      Sources<Kernel> from;
      resolve<Kernel>(here, I, from);
      for (std::size_t k = 0; k < Sources<Kernel>::size; ++k) take(k, from.unknown[k], from.factor[k]);
    } else {
      gather_here<Kernel>(take, scene.lattice.ghosted(I) * unknowns, std::make_index_sequence<Sources<Kernel>::size>{});
    }
  }
  /// Takes each input where its offset says, unrolled: what the offsets have in common is computed once.
  template <class Kernel, class Take, std::size_t... k>
  void gather_here(const Take& take, int base, std::index_sequence<k...>) const {
    const int along_1 = scene.lattice.ghosted_count[0] * unknowns, along_2 = along_1 * scene.lattice.ghosted_count[1];
    const auto place = [&](const Input& input) {
      return base + input.offset[2] * along_2 + input.offset[1] * along_1 + input.offset[0] * unknowns +
             input.component;
    };
    (take(k, place(Kernel::stencil.inputs[k]), scale[Kernel::stencil.inputs[k].component]), ...);
  }
  template <class Kernel, class Number>
  void gather(const double* state, const Index& I, Local<Kernel, Number>& q) const {
    gather(scene, state, state, 0, I, q);
  }

  /// What visitors of kernels have in common: the anchor that they are at.
  struct Visitor {
    const Assembly& assembly;
    Scene here;

    void enter(const Index& I) { here.near = assembly.scene.barriers.near(I); }
  };

  struct ResidualVisitor : Visitor {
    const double *state, *rate;
    double* residual;

    ResidualVisitor(const Assembly& a, const Scene& scene, const double* state_, const double* rate_, double* residual_)
        : Visitor{a, scene}, state(state_), rate(rate_), residual(residual_) {}

    template <class Kernel>
    [[gnu::noinline]] void visit(const Index& I) {
      const unsigned rows = assembly.rows_at<Kernel>(here, I);
      if (rows == 0) return;
      Local<Kernel, double> q;
      assembly.gather(here, state, rate, 0, I, q);
      std::array<double, Kernel::rows.size()> r{};
      Kernel::evaluate(here, I, q, r);
      for (std::size_t k = 0; k < r.size(); ++k) {
        if ((rows >> k & 1) == 0) continue;
        const Output& row = Kernel::rows[k];
        residual[assembly.owned_unknown(row.component, I + row.offset)] += assembly.row_scale[row.component] * r[k];
      }
    }
  };

  struct PatternVisitor : Visitor {
    EntrySink& sink;

    PatternVisitor(const Assembly& a, EntrySink& sink_) : Visitor{a, a.scene}, sink(sink_) {}

    template <class Kernel>
    [[gnu::noinline, gnu::cold]] void visit(const Index& I) {
      const unsigned rows = assembly.rows_at<Kernel>(here, I);
      if (rows == 0) return;
      static constexpr Dependences<Kernel> on;
      Sources<Kernel> from;
      assembly.resolve<Kernel>(here, I, from);
      for (std::size_t k = 0; k < Kernel::rows.size(); ++k) {
        if ((rows >> k & 1) == 0) continue;
        const Output& row = Kernel::rows[k];
        const int at = assembly.owned_unknown(row.component, I + row.offset);
        for (std::size_t j = 0; j < on.count[k]; ++j) sink.entry(at, from.unknown[on.input[k][j]]);
      }
    }
  };

  struct JacobianVisitor : Visitor {
    const double *state, *rate;
    double shift;
    const std::int32_t *place, *end, *entered;
    std::ptrdiff_t anchor_entries = 0;  ///< of the anchor before
    double *diagonal, *off_diagonal;

    JacobianVisitor(const Assembly& a, const Scene& scene, const double* state_, const double* rate_, double shift_,
                    const EntryPlaces& places, double* diagonal_, double* off_diagonal_)
        : Visitor{a, scene},
          state(state_),
          rate(rate_),
          shift(shift_),
          place(places.data()),
          end(places.data() + places.size()),
          entered(place),
          diagonal(diagonal_),
          off_diagonal(off_diagonal_) {}

    void enter(const Index& I) {
      Visitor::enter(I);
      anchor_entries = place - entered;
      entered = place;
    }

    /// The matrix is larger than the caches, and the rows of one anchor lie far apart: asks for the part of a row,
    /// `count` entries from `at` on, that this kernel will want at the next anchor. Inlined by force: as a function
    /// without effect the compiler would drop it.
    [[gnu::always_inline]] void prefetch(const std::int32_t* at, std::size_t count) const {
      const std::int32_t* next = at + anchor_entries;
      if (next + count > end) return;
      for (const std::int32_t entry : {next[0], next[count / 2], next[count - 1]})
        if (entry >= 0) __builtin_prefetch(diagonal + entry, 1);
    }

    void put(double value) {
      const std::int32_t at = *place++;
      if (at >= 0)
        diagonal[at] += value;
      else if (at != -1)
        off_diagonal[-2 - at] += value;
    }

    template <class Kernel>
    [[gnu::noinline]] void visit(const Index& I) {
      const unsigned rows = assembly.rows_at<Kernel>(here, I);
      if (rows == 0) return;
      using Number = Dual<Kernel::stencil.size>;
      Local<Kernel, Number> q;
      assembly.gather(here, state, rate, shift, I, q);
      std::array<Number, Kernel::rows.size()> r{};
      Kernel::evaluate(here, I, q, r);
      if (assembly.plain[assembly.scene.lattice.ghosted(I)])
        add_plain<Kernel>(r);
      else
        add<Kernel>(rows, r);
    }

    /// Adds the derivatives of all rows of a plain anchor, which all have a place in the diagonal block.
    template <class Kernel, class Derivatives>
    void add_plain(const Derivatives& r) {
      static constexpr Dependences<Kernel> on;
      const std::int32_t* at = place;
      for (std::size_t k = 0; k < r.size(); ++k) {
        const double row_unit = assembly.row_scale[Kernel::rows[k].component];
        prefetch(at, on.count[k]);
        for (std::size_t j = 0; j < on.count[k]; ++j) diagonal[*at++] += row_unit * r[k].derivative[on.input[k][j]];
      }
      place = at;
    }

    template <class Kernel, class Derivatives>
    void add(unsigned rows, const Derivatives& r) {
      static constexpr Dependences<Kernel> on;
      for (std::size_t k = 0; k < r.size(); ++k) {
        if ((rows >> k & 1) == 0) continue;
        const double row_unit = assembly.row_scale[Kernel::rows[k].component];
        prefetch(place, on.count[k]);
        for (std::size_t j = 0; j < on.count[k]; ++j) put(row_unit * r[k].derivative[on.input[k][j]]);
      }
    }
  };
};

}  // namespace scree
