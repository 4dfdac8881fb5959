/// What turns kernels into residual, Jacobian and pattern, whatever the layout: each kernel is compiled once for all
/// layouts that use it.
#pragma once

#include "scree/equations/kernel.hpp"
#include "scree/equations/model.hpp"
#include "scree/equations/scene.hpp"

namespace scree {

/// The place of unknowns, their scales and the rows that are balances, and the visitors of kernels.
struct Assembly {
  Scene scene;
  int unknowns;                          ///< a node
  std::vector<double> scale, row_scale;  ///< of unknowns and of rows, one a component
  std::vector<std::uint16_t> balance;    ///< bits of the rows that are balances, over ghosted nodes

  int ghosted_unknown(int component, const Index& I) const { return scene.lattice.ghosted(I) * unknowns + component; }
  int owned_unknown(int component, const Index& I) const { return scene.lattice.owned(I) * unknowns + component; }

  /// The rows of a kernel that are balances of this rank, as bits; 0 if the kernel has nothing to do at I. Nodes of
  /// other ranks have no bits set in balance_.
  template <class Kernel>
  unsigned rows_at(const Index& I) const {
    const int base = scene.lattice.ghosted(I);
    unsigned rows = 0;
    for (std::size_t k = 0; k < Kernel::rows.size(); ++k) {
      const int node = base + scene.lattice.ghosted_stride(Kernel::rows[k].offset);
      rows |= (balance[static_cast<std::size_t>(node)] >> Kernel::rows[k].component & 1U) << k;
    }
    return rows != 0 && Kernel::active(scene, I) ? rows : 0;
  }

  /// Calls work(k, ghosted unknown, factor) for each input k of a kernel at anchor I.
  template <class Kernel, class Work>
  void each_source(const Index& I, Work&& work) const {
    const int base = scene.lattice.ghosted(I);
    const bool near = scene.barriers.near(I);
    for (std::size_t k = 0; k < static_cast<std::size_t>(Kernel::stencil.size); ++k) {
      const Input& input = Kernel::stencil.inputs[k];
      Reference from{input.offset, 1};
      if (near) from = Kernel::resolve(scene, I, input);
      work(k, (base + scene.lattice.ghosted_stride(from.offset)) * unknowns + input.component, from.factor);
    }
  }

  template <class Kernel, class Number>
  void gather(const double* state, const double* rate, double shift, const Index& I, Local<Kernel, Number>& q) const {
    each_source<Kernel>(I, [&](std::size_t k, int unknown, double factor) {
      const double si = factor * scale[Kernel::stencil.inputs[k].component];
      q.value[k] = Number(si * state[unknown]);
      q.rate[k] = si * rate[unknown];
      if constexpr (IsDual<Number>::value) {
        q.value[k].derivative[k] = si;
        q.rate_slope[k] = shift * si;
      }
    });
  }

  struct ResidualVisitor {
    const Assembly& assembly;
    const double *state, *rate;
    double* residual;

    template <class Kernel>
    [[gnu::noinline]] void visit(const Index& I) {
      const unsigned rows = assembly.rows_at<Kernel>(I);
      if (rows == 0) return;
      Local<Kernel, double> q;
      assembly.gather(state, rate, 0, I, q);
      std::array<double, Kernel::rows.size()> r{};
      Kernel::evaluate(assembly.scene, I, q, r);
      for (std::size_t k = 0; k < r.size(); ++k) {
        if ((rows >> k & 1) == 0) continue;
        const Output& row = Kernel::rows[k];
        residual[assembly.owned_unknown(row.component, I + row.offset)] += assembly.row_scale[row.component] * r[k];
      }
    }
  };

  struct PatternVisitor {
    const Assembly& assembly;
    EntrySink& sink;

    template <class Kernel>
    [[gnu::noinline]] void visit(const Index& I) {
      const unsigned rows = assembly.rows_at<Kernel>(I);
      if (rows == 0) return;
      std::array<int, Kernel::stencil.size> columns;
      assembly.each_source<Kernel>(I, [&](std::size_t j, int unknown, double) { columns[j] = unknown; });
      for (std::size_t k = 0; k < Kernel::rows.size(); ++k) {
        if ((rows >> k & 1) == 0) continue;
        const Output& row = Kernel::rows[k];
        const int at = assembly.owned_unknown(row.component, I + row.offset);
        for (std::size_t j = 0; j < columns.size(); ++j)
          if (Kernel::depends(static_cast<int>(k), Kernel::stencil.inputs[j])) sink.entry(at, columns[j]);
      }
    }
  };

  struct JacobianVisitor {
    const Assembly& assembly;
    const double *state, *rate;
    double shift;
    const std::int32_t* place;
    double *diagonal, *off_diagonal;

    void put(double value) {
      const std::int32_t at = *place++;
      if (at >= 0)
        diagonal[at] += value;
      else if (at != -1)
        off_diagonal[-2 - at] += value;
    }

    template <class Kernel>
    [[gnu::noinline]] void visit(const Index& I) {
      const unsigned rows = assembly.rows_at<Kernel>(I);
      if (rows == 0) return;
      using Number = Dual<Kernel::stencil.size>;
      Local<Kernel, Number> q;
      assembly.gather(state, rate, shift, I, q);
      std::array<Number, Kernel::rows.size()> r{};
      Kernel::evaluate(assembly.scene, I, q, r);
      for (std::size_t k = 0; k < r.size(); ++k) {
        if ((rows >> k & 1) == 0) continue;
        const double row_unit = assembly.row_scale[Kernel::rows[k].component];
        for (std::size_t j = 0; j < static_cast<std::size_t>(Kernel::stencil.size); ++j)
          if (Kernel::depends(static_cast<int>(k), Kernel::stencil.inputs[j])) put(row_unit * r[k].derivative[j]);
      }
    }
  };
};

}  // namespace scree
