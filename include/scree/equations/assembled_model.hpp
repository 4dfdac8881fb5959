/// A model as the sum of its kernels: one sweep over the grid, seen by visitors that make residual, Jacobian or
/// pattern.
#pragma once

#include <algorithm>
#include <utility>

#include "scree/equations/cell_balances.hpp"
#include "scree/equations/edge_stress.hpp"
#include "scree/equations/face_forces.hpp"
#include "scree/equations/model.hpp"
#include "scree/equations/momentum_fluxes.hpp"
#include "scree/equations/scalar_fluxes.hpp"
#include "scree/equations/wall_laws.hpp"

namespace scree {

template <class L, bool SecondOrder>
class AssembledModel final : public Model {
 public:
  explicit AssembledModel(const ModelSetup& setup)
      : setup_(setup),
        scene_{setup.lattice, setup.barriers, setup_.model, setup_.solids},
        fields_(fields_of<L>(setup.scales)) {
    const double rho_s = setup_.solids.kinetic.rho_s, V = setup_.scales.velocity, t = setup_.scales.time;
    scale_[L::nu] = 1;
    row_scale_[L::nu] = t;
    for (int axis = 0; axis < L::dim; ++axis) {
      scale_[L::v(axis)] = V;
      row_scale_[L::v(axis)] = t / (rho_s * V);
    }
    if constexpr (L::has_T) {
      scale_[L::T] = V * V;
      row_scale_[L::T] = t / (rho_s * V * V);
    }
    if constexpr (L::has_chi) {
      scale_[L::chi] = 1;
      row_scale_[L::chi] = t;
    }
    mark_balances();
  }

  int unknowns() const override { return L::count; }
  const std::vector<Field>& fields() const override { return fields_; }
  double continuity_scale() const override { return row_scale_[L::nu]; }
  bool is_balance(int component, const Index& I) const override {
    return (balance_[setup_.lattice.ghosted(I)] >> component & 1) != 0;
  }

  void residual(const double* state, const double* rate, double* residual) const override {
    std::fill_n(residual, L::count * setup_.lattice.owned_size(), 0.0);
    ResidualVisitor visitor{*this, state, rate, residual};
    sweep(visitor);
    each_constraint([&](const Constraint& c) {
      const int row = owned_unknown(c.component, c.node);
      residual[row] = constraint_value(c, state, rate);
    });
  }

  void sparsity(EntrySink& sink) const override {
    PatternVisitor visitor{*this, sink};
    sweep(visitor);
    each_constraint([&](const Constraint& c) {
      const int row = owned_unknown(c.component, c.node);
      sink.entry(row, ghosted_unknown(c.component, c.node));
      if (c.kind == Constraint::follow) sink.entry(row, ghosted_unknown(c.component, c.neighbour));
    });
  }

  void jacobian(const double* state, const double* rate, double shift, const EntryPlaces& places, double* diagonal,
                double* off_diagonal) const override {
    JacobianVisitor visitor{*this, state, rate, shift, places.data(), diagonal, off_diagonal};
    sweep(visitor);
    each_constraint([&](const Constraint& c) {
      visitor.put(c.kind == Constraint::freeze ? shift * row_scale_[L::nu] : 1.0);
      if (c.kind == Constraint::follow) visitor.put(-1.0);
    });
  }

  double solids_flux(const double* state, int axis, const Index& I) const override {
    double flux = 0;
    static_for<L::dim>([&](auto a) {
      using Kernel = ScalarFluxes<L, SecondOrder, a()>;
      if (a() != axis || !Kernel::active(scene_, I)) return;
      Local<Kernel, double> q;
      gather(state, state, 0, I, q);
      flux = mass_flux<L, SecondOrder>(scene_, I, q, axis, {});
    });
    return flux;
  }

 private:
  /// A row that is no balance: a velocity on a side or plate, a frozen unknown, or padding.
  struct Constraint {
    enum Kind { fix, follow, freeze } kind;
    int component;
    Index node;
    double value = 0;   ///< fix: the stored value
    Index neighbour{};  ///< follow: zero gradient towards this node
  };

  template <int count, class Work>
  static void static_for(Work&& work) {
    static_for_each(work, std::make_integer_sequence<int, count>{});
  }
  template <class Work, int... i>
  static void static_for_each(Work& work, std::integer_sequence<int, i...>) {
    (work(std::integral_constant<int, i>{}), ...);
  }

  /// All kernels at all anchors that touch an owned row, always in the same order.
  template <class Visitor>
  void sweep(Visitor& visitor) const {
    Index first = setup_.lattice.owned_first, count = setup_.lattice.owned_count;
    for (int axis = 0; axis < L::dim; ++axis) {
      first[axis] -= 1;
      count[axis] += 2;
    }
    for_each_node(first, count, [&](const Index& I) {
      static_for<L::dim>([&](auto a) {
        visitor.template visit<ScalarFluxes<L, SecondOrder, a()>>(I);
        visitor.template visit<NormalMomentumFlux<L, SecondOrder, a()>>(I);
        visitor.template visit<FaceForces<L, a()>>(I);
        static_for<L::dim>([&](auto b) {
          if constexpr (a() != b()) visitor.template visit<CrossMomentumFlux<L, SecondOrder, a(), b()>>(I);
          if constexpr (a() < b()) visitor.template visit<EdgeStress<L, a(), b()>>(I);
        });
        if constexpr (L::dim > 1 || L::has_T) {
          visitor.template visit<WallLaws<L, a(), false>>(I);
          visitor.template visit<WallLaws<L, a(), true>>(I);
        }
      });
      visitor.template visit<CellBalances<L>>(I);
    });
  }

  int ghosted_unknown(int component, const Index& I) const { return setup_.lattice.ghosted(I) * L::count + component; }
  int owned_unknown(int component, const Index& I) const { return setup_.lattice.owned(I) * L::count + component; }

  /// The rows of a kernel that are balances of this rank, as bits; 0 if the kernel has nothing to do at I. Nodes of
  /// other ranks have no bits set in balance_.
  template <class Kernel>
  unsigned rows_at(const Index& I) const {
    const int base = setup_.lattice.ghosted(I);
    unsigned rows = 0;
    for (std::size_t k = 0; k < Kernel::rows.size(); ++k) {
      const int node = base + setup_.lattice.ghosted_stride(Kernel::rows[k].offset);
      rows |= (balance_[static_cast<std::size_t>(node)] >> Kernel::rows[k].component & 1U) << k;
    }
    return rows != 0 && Kernel::active(scene_, I) ? rows : 0;
  }

  /// Calls work(k, ghosted unknown, factor) for each input k of a kernel at anchor I.
  template <class Kernel, class Work>
  void each_source(const Index& I, Work&& work) const {
    const int base = setup_.lattice.ghosted(I);
    const bool near = scene_.barriers.near(I);
    for (std::size_t k = 0; k < static_cast<std::size_t>(Kernel::stencil.size); ++k) {
      const Input& input = Kernel::stencil.inputs[k];
      Reference from{input.offset, 1};
      if (near) from = Kernel::resolve(scene_, I, input);
      work(k, (base + setup_.lattice.ghosted_stride(from.offset)) * L::count + input.component, from.factor);
    }
  }

  template <class Kernel, class Number>
  void gather(const double* state, const double* rate, double shift, const Index& I, Local<Kernel, Number>& q) const {
    each_source<Kernel>(I, [&](std::size_t k, int unknown, double factor) {
      const double scale = factor * scale_[Kernel::stencil.inputs[k].component];
      q.value[k] = Number(scale * state[unknown]);
      q.rate[k] = scale * rate[unknown];
      if constexpr (IsDual<Number>::value) {
        q.value[k].derivative[k] = scale;
        q.rate_slope[k] = shift * scale;
      }
    });
  }

  struct ResidualVisitor {
    const AssembledModel& model;
    const double *state, *rate;
    double* residual;

    template <class Kernel>
    void visit(const Index& I) {
      const unsigned rows = model.template rows_at<Kernel>(I);
      if (rows == 0) return;
      Local<Kernel, double> q;
      model.gather(state, rate, 0, I, q);
      std::array<double, Kernel::rows.size()> r{};
      Kernel::evaluate(model.scene_, I, q, r);
      for (std::size_t k = 0; k < r.size(); ++k) {
        if ((rows >> k & 1) == 0) continue;
        const Output& row = Kernel::rows[k];
        residual[model.owned_unknown(row.component, I + row.offset)] += model.row_scale_[row.component] * r[k];
      }
    }
  };

  struct PatternVisitor {
    const AssembledModel& model;
    EntrySink& sink;

    template <class Kernel>
    void visit(const Index& I) {
      const unsigned rows = model.template rows_at<Kernel>(I);
      if (rows == 0) return;
      std::array<int, Kernel::stencil.size> columns;
      model.template each_source<Kernel>(I, [&](std::size_t j, int unknown, double) { columns[j] = unknown; });
      for (std::size_t k = 0; k < Kernel::rows.size(); ++k) {
        if ((rows >> k & 1) == 0) continue;
        const Output& row = Kernel::rows[k];
        const int at = model.owned_unknown(row.component, I + row.offset);
        for (std::size_t j = 0; j < columns.size(); ++j)
          if (Kernel::depends(static_cast<int>(k), Kernel::stencil.inputs[j])) sink.entry(at, columns[j]);
      }
    }
  };

  struct JacobianVisitor {
    const AssembledModel& model;
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
    void visit(const Index& I) {
      const unsigned rows = model.template rows_at<Kernel>(I);
      if (rows == 0) return;
      using Number = Dual<Kernel::stencil.size>;
      Local<Kernel, Number> q;
      model.gather(state, rate, shift, I, q);
      std::array<Number, Kernel::rows.size()> r{};
      Kernel::evaluate(model.scene_, I, q, r);
      for (std::size_t k = 0; k < r.size(); ++k) {
        if ((rows >> k & 1) == 0) continue;
        const double scale = model.row_scale_[Kernel::rows[k].component];
        for (std::size_t j = 0; j < static_cast<std::size_t>(Kernel::stencil.size); ++j)
          if (Kernel::depends(static_cast<int>(k), Kernel::stencil.inputs[j])) put(scale * r[k].derivative[j]);
      }
    }
  };

  /// Bits of the rows that are balances; the others are constraints.
  void mark_balances() {
    const Lattice& grid = setup_.lattice;
    balance_.assign(grid.ghosted_size(), 0);
    for_each_node(grid.owned_first, grid.owned_count, [&](const Index& I) {
      unsigned rows = 0;
      if (grid.inside(I)) {
        if (setup_.model.solids_moving) rows |= 1U << L::nu;
        if constexpr (L::has_T) rows |= 1U << L::T;
        if constexpr (L::has_chi) rows |= 1U << L::chi;
      }
      for (int axis = 0; axis < L::dim; ++axis)
        if (setup_.model.solids_moving && grid.inside(I) && grid.inside(I - unit(axis)) && !setup_.barriers.at(axis, I))
          rows |= 1U << L::v(axis);
      balance_[grid.ghosted(I)] = static_cast<std::uint16_t>(rows);
    });
  }

  /// Calls work(Constraint) for each owned row that is no balance, always in the same order.
  template <class Work>
  void each_constraint(Work&& work) const {
    const Lattice& grid = setup_.lattice;
    for_each_node(grid.owned_first, grid.owned_count, [&](const Index& I) {
      for (int component = 0; component < L::count; ++component)
        if (!is_balance(component, I)) work(constraint(component, I));
    });
  }

  Constraint constraint(int component, const Index& I) const {
    const Lattice& grid = setup_.lattice;
    Constraint result{Constraint::fix, component, I};
    if (!L::is_velocity(component)) {
      if (grid.inside(I)) result.kind = Constraint::freeze;
      return result;
    }
    const int axis = L::axis_of(component);
    if (!grid.is_face(axis, I)) return result;
    if (!setup_.model.solids_moving) {
      result.kind = Constraint::freeze;
      return result;
    }
    const Condition& condition = setup_.barriers.condition(axis, I);
    if (condition.kind == BoundaryKind::open) {
      result.kind = Constraint::follow;
      result.neighbour = box_above(scene_, axis, I) ? I + unit(axis) : I - unit(axis);
    } else if (condition.kind != BoundaryKind::symmetry) {
      result.value = condition.velocity[axis] / scale_[component];
    }
    return result;
  }

  double constraint_value(const Constraint& c, const double* state, const double* rate) const {
    const double here = state[ghosted_unknown(c.component, c.node)];
    if (c.kind == Constraint::freeze) return row_scale_[L::nu] * rate[ghosted_unknown(c.component, c.node)];
    return here - (c.kind == Constraint::follow ? state[ghosted_unknown(c.component, c.neighbour)] : c.value);
  }

  ModelSetup setup_;
  Scene scene_;
  std::vector<Field> fields_;
  std::array<double, L::count> scale_, row_scale_;
  std::vector<std::uint16_t> balance_;
};

/// Explicitly instantiated, one dimension a file.
std::unique_ptr<Model> make_model_1d(const ModelSetup& setup);
std::unique_ptr<Model> make_model_2d(const ModelSetup& setup);
std::unique_ptr<Model> make_model_3d(const ModelSetup& setup);

/// Turns the run-time choices into the type of the model.
template <int dim>
std::unique_ptr<Model> choose_model(const ModelSetup& setup) {
  const auto with = [&](auto T, auto chi, auto second_order) -> std::unique_ptr<Model> {
    return std::make_unique<AssembledModel<Layout<dim, T(), chi()>, second_order()>>(setup);
  };
  const auto with_chi = [&](auto T, auto chi) {
    return setup.model.advection == AdvectionScheme::upwind ? with(T, chi, std::false_type{})
                                                            : with(T, chi, std::true_type{});
  };
  const auto with_T = [&](auto T) {
    return setup.solids.friction.model == FrictionModel::relaxed ? with_chi(T, std::true_type{})
                                                                 : with_chi(T, std::false_type{});
  };
  return setup.model.temperature == TemperatureModel::transport ? with_T(std::true_type{}) : with_T(std::false_type{});
}

}  // namespace scree
