/// A model as the sum of its kernels: one sweep over the grid, seen by visitors that make residual, Jacobian or
/// pattern. What runs once is marked cold: compilers take a third of their time for it otherwise.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "scree/assembly/assembly.hpp"
#include "scree/kernels/carried_scalar.hpp"
#include "scree/kernels/cell_balances.hpp"
#include "scree/kernels/edge_stress.hpp"
#include "scree/kernels/face_forces.hpp"
#include "scree/kernels/gas_forces.hpp"
#include "scree/kernels/gas_viscosity.hpp"
#include "scree/kernels/gas_volume_flux.hpp"
#include "scree/kernels/momentum_fluxes.hpp"
#include "scree/kernels/scalar_fluxes.hpp"
#include "scree/kernels/surface_stress.hpp"
#include "scree/kernels/wall_laws.hpp"
#include "scree/model/derived_fields.hpp"
#include "scree/model/model.hpp"

namespace scree {

template <class L, bool SecondOrder>
class AssembledModel final : public Model {
 public:
  explicit AssembledModel(const ModelSetup& setup)
      : setup_(setup),
        assembly_{Scene(setup.lattice, setup.barriers, setup_.model, setup_.solids), L::count, {}, {}, {}, {}},
        fields_(L::fields(setup.scales)) {
    static_assert(L::nu == solids_fraction, "nu stands first in every node");
    static_assert(L::count <= most_unknowns, "more unknowns a node than there are bits for their rows");
    for (const Field& field : fields_) {
      assembly_.scale[field.component] = field.scale;
      assembly_.row_scale[field.component] = field.unknown->row_scale(setup_.scales, setup_.solids.kinetic.rho_s);
    }
    mark_balances();
    assembly_.mark_plain();
  }

  int unknowns() const override { return L::count; }
  const std::vector<Field>& fields() const override { return fields_; }
  double continuity_scale() const override { return assembly_.row_scale[L::nu]; }
  bool is_balance(int component, const Index& I) const override {
    return (assembly_.balance[setup_.lattice.ghosted(I)] >> component & 1) != 0;
  }

  void set_mean_pressure_gradient(const std::array<double, max_dim>& gradient) override {
    setup_.model.mean_pressure_gradient = gradient;
  }

  void residual(double time, const double* state, const double* rate, double* residual) const override {
    Scene scene = assembly_.scene.at(time);
    scene.step = step_;
    std::fill_n(residual, L::count * setup_.lattice.owned_size(), 0.0);
    Assembly::ResidualVisitor visitor(assembly_, scene, state, rate, residual);
    sweep(visitor);
    each_constraint(scene, [&](const Constraint& c) {
      const int row = assembly_.owned_unknown(c.component, c.node);
      residual[row] = constraint_value(c, state, rate);
    });
  }

  void sparsity(EntrySink& sink) const override {
    Assembly::PatternVisitor visitor(assembly_, sink);
    sweep(visitor);
    each_constraint(assembly_.scene, [&](const Constraint& c) {
      const int row = assembly_.owned_unknown(c.component, c.node);
      sink.entry(row, assembly_.ghosted_unknown(c.component, c.node));
      if (c.kind != Constraint::superficial) return;
      for (const Index& cell : c.cells) sink.entry(row, assembly_.ghosted_unknown(L::nu, cell));
    });
    each_pressure_row([&](int row, const Index& I) { sink.entry(row, assembly_.ghosted_unknown(L::p, I)); });
  }

  void jacobian(double time, const double* state, const double* rate, double shift, const EntryPlaces& places,
                double* diagonal, double* off_diagonal) const override {
    Scene scene = assembly_.scene.at(time);
    scene.step = step_;
    scene.tangent = tangent_.get();
    if (tangent_) tangent_->next();
    Assembly::JacobianVisitor visitor(assembly_, scene, state, rate, shift, places, diagonal, off_diagonal);
    sweep(visitor);
    each_constraint(scene, [&](const Constraint& c) {
      if (c.kind == Constraint::superficial) {
        const SideFraction side = solids_fraction_at_side(c, state);
        visitor.put(1 - side.value);
        for (const double slope : side.slopes)
          visitor.put(-slope * state[assembly_.ghosted_unknown(c.component, c.node)]);
        return;
      }
      visitor.put(c.kind == Constraint::freeze ? shift * assembly_.row_scale[L::nu] : 1.0);
    });
    each_pressure_row([&](int, const Index&) { visitor.put(pressure_hold); });
  }

  void begin_newton(TangentKind kind, double step) const override {
    step_ = step;
    if (kind == TangentKind::exact || !setup_.solids.friction.model->has_friction || L::has_g_f) {
      tangent_.reset();
    } else if (tangent_) {
      tangent_->restart();
    } else {
      tangent_ =
          std::make_unique<NewtonTangent>(setup_.lattice.ghosted_size(), L::dim, setup_.solids.friction.fluctuation);
    }
  }

  [[gnu::cold]] void impose_gas(double time, const double* state, double* owned) const override {
    each_constraint(assembly_.scene.at(time), [&](const Constraint& c) {
      if (!L::is_u(c.component)) return;
      const bool superficial = c.kind == Constraint::superficial;
      const double share = superficial ? 1 - solids_fraction_at_side(c, state).value : 1;
      owned[assembly_.owned_unknown(c.component, c.node)] = c.value / share;
    });
  }

  [[gnu::cold]] void relax_chi([[maybe_unused]] const double* state, [[maybe_unused]] double share,
                               [[maybe_unused]] double* owned) const override {
    if constexpr (L::has_chi) {
      for_each_node(setup_.lattice.owned_first, setup_.lattice.owned_count, [&](const Index& I) {
        if (!setup_.lattice.inside(I)) return;
        Local<CellBalances<L>, double> q;
        assembly_.gather(state, I, q);
        const auto strain = cell_strain<L>(assembly_.scene, I, q);
        const double steady = cell_closures<L, CellClosure::chi_star>(assembly_.scene, I, q, strain)[0];
        double& chi = owned[assembly_.owned_unknown(L::chi, I)];
        chi += share * (steady - chi);
      });
    }
  }

  [[gnu::cold]] void raise_temperature([[maybe_unused]] const double* state, [[maybe_unused]] double dt,
                                       [[maybe_unused]] double least_nu,
                                       [[maybe_unused]] double* owned) const override {
    if constexpr (L::has_T) {
      for_each_node(setup_.lattice.owned_first, setup_.lattice.owned_count, [&](const Index& I) {
        if (!is_balance(L::T, I)) return;
        Local<CellBalances<L>, double> q;
        assembly_.gather(state, I, q);
        if (!(q(L::nu) > least_nu)) return;
        const auto strain = cell_strain<L>(assembly_.scene, I, q);
        double& T = owned[assembly_.owned_unknown(L::T, I)];
        const double scale = assembly_.scale[L::T];
        T = raised_temperature(q(L::nu), T * scale, strain.div_v, strain.S_S, dt, setup_.solids) / scale;
      });
    }
  }

  [[gnu::cold]] std::vector<std::vector<double>> derived_values(const double* state) const override {
    const Lattice& grid = setup_.lattice;
    const auto wanted = derived_entries(setup_.model, setup_.solids);
    std::vector<std::vector<double>> result(wanted.size(),
                                            std::vector<double>(static_cast<std::size_t>(grid.owned_size()), 0.0));
    for_each_node(grid.owned_first, grid.owned_count, [&](const Index& I) {
      if (!grid.inside(I)) return;
      Local<CellBalances<L>, double> q;
      assembly_.gather(state, I, q);
      const auto [T, p_f] = cell_closures<L, CellClosure::temperature, CellClosure::frictional_pressure>(
          assembly_.scene, I, q, cell_strain<L>(assembly_.scene, I, q));
      for (std::size_t k = 0; k < wanted.size(); ++k)
        result[k][static_cast<std::size_t>(grid.owned(I))] = wanted[k] == CellClosure::temperature ? T : p_f;
    });
    return result;
  }

  [[gnu::cold]] double solids_flux(const double* state, int axis, const Index& I) const override {
    double flux = 0;
    static_for<L::dim>([&](auto a) {
      using Kernel = ScalarFluxes<L, SecondOrder, a()>;
      if (a() != axis || !Kernel::active(assembly_.scene, I)) return;
      Local<Kernel, double> q;
      assembly_.gather(state, I, q);
      flux = scree::solids_flux<L, SecondOrder>(assembly_.scene, I, q, axis, {});
    });
    return flux;
  }

  /// What the balance of v has at the end of the half of a cell that lies before the wall: the stress in the middle of
  /// the cell, what the particles bring along, the weight of that half, and what walls beside it take.
  [[gnu::cold]] std::array<double, max_dim> wall_traction(double time, const double* state, int axis, const Index& I,
                                                          End cells) const override {
    const Scene scene = assembly_.scene.at(time);
    const bool above = cells == End::upper;
    const Index cell = above ? I : I - unit(axis);
    const int side = above ? 0 : 1;
    std::array<double, max_dim> traction{};
    Local<CellBalances<L>, double> q;
    assembly_.gather(state, cell, q);
    const auto strain = cell_strain<L>(scene, cell, q);
    const auto closures = cell_closures<L, CellClosure::pressure, CellClosure::viscosity>(scene, cell, q, strain);
    const double rho = setup_.solids.kinetic.rho_s - (L::has_gas ? setup_.solids.gas.rho_g : 0);
    const double weight =
        SolidsMomentum::weight(rho, scene.gravity[axis], q(L::nu)) * scene.distance_to_face(axis, cell);
    static_for<L::dim>([&](auto a) {
      if (a() != axis) return;
      using Kernel = NormalMomentumFlux<Particles, a()>;
      Local<Kernel, double> carrier;
      assembly_.gather(state, cell, carrier);
      std::array<double, 2> r{};
      Kernel::evaluate(scene, cell, carrier, r);
      const double carried = r[side] * scene.control_length(axis, I);
      const double stress = SolidsMomentum::normal_stress(closures[0], closures[1], strain.S(axis));
      traction[axis] = weight + (above ? -stress - carried : stress - carried);
    });
    Local<WallLaws<L>, double> at_wall;
    assembly_.gather(state, cell, at_wall);
    const auto shear = WallLaws<L>::wall_shear(scene, cell, at_wall, axis, end_of(side));
    for (int t = 0; t < L::dim; ++t) {
      if (t == axis) continue;
      traction[t] = 0.5 * (shear[t][0] + shear[t][1]);
      for (const End end : {End::lower, End::upper}) {  // walls beside it hold a part of the half of the cell
        const auto beside = WallLaws<L>::wall_shear(scene, cell, at_wall, t, end);
        traction[axis] -= beside[axis][side] * scene.distance_to_face(axis, cell) / scene.cell_length(t, cell);
      }
    }
    return traction;
  }

  [[gnu::cold]] double gas_flux(double time, const double* state, int axis, const Index& I) const override {
    const Scene scene = assembly_.scene.at(time);
    double flux = 0;
    static_for<L::dim>([&](auto a) {
      if constexpr (L::has_gas) {
        using Kernel = GasVolumeFlux<Core, SecondOrder, a()>;
        if (a() != axis || !Kernel::active(scene, I)) return;
        Local<Kernel, double> q;
        assembly_.gather(state, I, q);
        flux = scree::gas_flux<Core>(scene, I, q, axis, Index{});
      }
    });
    return flux;
  }

 private:
  using Core = typename L::Core;
  using Particles = ParticlePhase<Core, SecondOrder>;
  using Gas = GasPhase<Core, SecondOrder>;

  /// A row that is no balance: a velocity on a side or plate, a frozen unknown, or padding.
  struct Constraint {
    enum Kind { fix, freeze, superficial } kind;
    int component;
    Index node;
    double value = 0;                       ///< fix: the stored value; superficial: (1-nu) times it
    std::array<Index, 2> cells{};           ///< superficial: the two before the side, whose nu ...
    std::array<double, 2> weights{{1, 0}};  ///< ... with these weights is that at the side, ...
    double brought = 0;                     ///< ... together with this
  };

  /// nu at a side, and its derivatives by that of the two cells before it.
  struct SideFraction {
    double value;
    std::array<double, 2> slopes;
  };

  /// Stands as the diagonal of the rows of p_g in the Jacobian alone: factorisations want one, and where no side is
  /// open the level of p_g is undetermined (DiscreteProblem settles it). Too small to be noticed by Newton's method.
  static constexpr double pressure_hold = 1e-11;

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
      visitor.enter(I);
      static_for<L::dim>([&](auto a) {
        visitor.template visit<ScalarFluxes<L, SecondOrder, a()>>(I);
        visitor.template visit<NormalMomentumFlux<Particles, a()>>(I);
        visitor.template visit<FaceForces<Core, a()>>(I);
        visitor.template visit<SurfaceStress<Core, a()>>(I);
        static_for<L::dim>([&](auto b) {
          if constexpr (a() != b()) visitor.template visit<CrossMomentumFlux<Particles, a(), b()>>(I);
          if constexpr (a() < b()) visitor.template visit<EdgeStress<L, a(), b()>>(I);
        });
      });
      visitor.template visit<WallLaws<L>>(I);
      visitor.template visit<CellBalances<L>>(I);
      if constexpr (L::has_gas) sweep_gas(visitor, I);
      L::for_each_scalar([&](auto scalar) { sweep_scalar<decltype(scalar)>(visitor, I); });
    });
  }
  template <class Visitor>
  void sweep_gas(Visitor& visitor, const Index& I) const {
    static_for<L::dim>([&](auto a) {
      visitor.template visit<GasVolumeFlux<Core, SecondOrder, a()>>(I);
      visitor.template visit<GasForces<Core, a()>>(I);
      if constexpr (L::has_u) {
        visitor.template visit<NormalMomentumFlux<Gas, a()>>(I);
        visitor.template visit<GasNormalStress<Core, a()>>(I);
        static_for<L::dim>([&](auto b) {
          if constexpr (a() != b()) {
            visitor.template visit<CrossMomentumFlux<Gas, a(), b()>>(I);
            visitor.template visit<GasShearStress<Core, a(), b()>>(I);
          }
        });
        visitor.template visit<GasWallStress<Core, a()>>(I);
      }
    });
  }

  template <class Scalar, class Visitor>
  void sweep_scalar(Visitor& visitor, const Index& I) const {
    static_for<L::dim>([&](auto a) { visitor.template visit<CarriedScalarFlux<L, SecondOrder, Scalar, a()>>(I); });
    visitor.template visit<CarriedScalarSource<L, Scalar>>(I);
  }

  /// Bits of the rows that are balances; the others are constraints.
  [[gnu::noinline, gnu::cold]] void mark_balances() {
    const Lattice& grid = setup_.lattice;
    assembly_.balance.assign(grid.ghosted_size(), 0);
    for_each_node(grid.owned_first, grid.owned_count, [&](const Index& I) {
      unsigned rows = 0;
      if (grid.inside(I)) {
        if (setup_.model.solids_moving) rows |= 1U << L::nu;
        if constexpr (L::has_T) rows |= static_cast<unsigned>(!setup_.model.gas_alone) << L::T;
        if constexpr (L::has_chi)
          rows |= static_cast<unsigned>(!setup_.model.gas_alone && !setup_.solids.friction.lagged) << L::chi;
        if constexpr (L::has_gas) rows |= 1U << L::p;
        L::for_each_scalar([&](auto scalar) {
          rows |= static_cast<unsigned>(!setup_.model.gas_alone) << L::template first<decltype(scalar)>();
        });
      }
      for (int axis = 0; axis < L::dim; ++axis) {
        const bool barrier = setup_.barriers.at(axis, I);
        const bool between = grid.inside(I) && grid.inside(I - unit(axis)) && !barrier;
        const auto opens = [&](auto&& asks) { return barrier && asks(setup_.barriers.condition(axis, I).kind); };
        const bool lets_out = opens([](const BoundaryKind& kind) { return kind.lets_solids_out(); });
        if ((between || lets_out) && setup_.model.solids_moving) rows |= 1U << L::v(axis);
        if constexpr (L::has_u)
          if (between || opens([](const BoundaryKind& kind) { return kind.open_to_gas(); })) rows |= 1U << L::u(axis);
      }
      assembly_.balance[grid.ghosted(I)] = static_cast<std::uint16_t>(rows);
    });
  }

  /// Calls work(row, I) for each owned balance of gas volume.
  template <class Work>
  void each_pressure_row([[maybe_unused]] Work&& work) const {
    if constexpr (L::has_gas)
      for_each_node(setup_.lattice.owned_first, setup_.lattice.owned_count, [&](const Index& I) {
        if (is_balance(L::p, I)) work(assembly_.owned_unknown(L::p, I), I);
      });
  }

  /// Calls work(Constraint) for each owned row that is no balance, always in the same order, with the values that
  /// hold at the time of `scene`.
  template <class Work>
  void each_constraint(const Scene& scene, Work&& work) const {
    const Lattice& grid = setup_.lattice;
    for_each_node(grid.owned_first, grid.owned_count, [&](const Index& I) {
      for (int component = 0; component < L::count; ++component)
        if (!is_balance(component, I)) work(constraint(scene, component, I));
    });
  }

  [[gnu::noinline]] Constraint constraint(const Scene& scene, int component, const Index& I) const {
    const Lattice& grid = setup_.lattice;
    Constraint result{Constraint::fix, component, I};
    if (!L::is_velocity(component)) {
      if (grid.inside(I)) result.kind = Constraint::freeze;
      return result;
    }
    const int axis = L::axis_of(component);
    if (!grid.is_face(axis, I)) return result;
    if (L::is_u(component)) return gas_constraint(scene, result, axis);
    if (!setup_.model.solids_moving) {
      result.kind = Constraint::freeze;
      return result;
    }
    const Condition& condition = setup_.barriers.condition(axis, I);
    if (condition.kind.solids_normal != SolidsNormal::zero)
      result.value = prescribed_velocity(scene, axis, axis, I) / assembly_.scale[component];
    return result;
  }

  /// The constraint of u on a side or plate.
  Constraint gas_constraint(const Scene& scene, Constraint result, int axis) const {
    const Condition& condition = setup_.barriers.condition(axis, result.node);
    if (condition.kind.brings_gas()) {
      result.kind = Constraint::superficial;
      result.value = given_gas_flux(scene, axis, result.node) / assembly_.scale[result.component];
      put_solids_fraction(scene, condition, axis, result);
    } else if (condition.kind.gas_normal != GasNormal::zero) {
      result.value = condition.velocity[axis] / assembly_.scale[result.component];
    }
    return result;
  }

  /// nu at an inlet is what it brings; at a side that brings gas alone that of the cell before it, to second order on
  /// the line through the next one.
  void put_solids_fraction(const Scene& scene, const Condition& condition, int axis, Constraint& c) const {
    const bool above = box_above(scene, axis, c.node);
    const Index inwards = (above ? 1 : -1) * unit(axis), before = above ? c.node : c.node - unit(axis);
    c.cells = {before, before};
    if (condition.kind.brings_solids()) {
      c.weights = {0, 0};
      c.brought = condition.brought(SolidsContinuity::unknown);
    } else if (SecondOrder && scene.inside(before + inwards) &&
               !setup_.barriers.at(axis, above ? before + inwards : before)) {
      const double width = scene.axis(axis).width(before[axis]),
                   next = scene.axis(axis).width(before[axis] + inwards[axis]);
      c.cells[1] = before + inwards;
      c.weights = {1 + width / (width + next), -width / (width + next)};
    }
  }

  /// The line may lead to where no nu can be.
  SideFraction solids_fraction_at_side(const Constraint& c, const double* state) const {
    double nu = c.brought;
    for (std::size_t k = 0; k < 2; ++k) nu += c.weights[k] * state[assembly_.ghosted_unknown(L::nu, c.cells[k])];
    if (nu < 0) return {0, {0, 0}};
    if (nu > setup_.solids.kinetic.nu_max) return {setup_.solids.kinetic.nu_max, {0, 0}};
    return {nu, c.weights};
  }

  double constraint_value(const Constraint& c, const double* state, const double* rate) const {
    const double here = state[assembly_.ghosted_unknown(c.component, c.node)];
    if (c.kind == Constraint::freeze)
      return assembly_.row_scale[L::nu] * rate[assembly_.ghosted_unknown(c.component, c.node)];
    if (c.kind == Constraint::superficial) return (1 - solids_fraction_at_side(c, state).value) * here - c.value;
    return here - c.value;
  }

  ModelSetup setup_;
  mutable std::unique_ptr<NewtonTangent> tangent_;  ///< none: the exact one
  mutable double step_ = 0;                         ///< of backward Euler, 0 for other schemes [s]
  Assembly assembly_;
  std::vector<Field> fields_;
};

/// Turns the run-time choices into the type of the model, with further scalars of the particles.
template <int dim, GasModel gas, class... Scalars>
[[gnu::cold]] std::unique_ptr<Model> choose_model(const ModelSetup& setup) {
  if (has_fluidity(setup.solids.friction) && !(std::is_same_v<Scalars, Fluidity> || ...))
    throw std::runtime_error("this model has no balance of fluidity: friction_coefficient has to be another one");
  const auto with = [&](auto T, auto chi, auto second_order) -> std::unique_ptr<Model> {
    return std::make_unique<AssembledModel<Layout<dim, T(), chi(), gas, Scalars...>, second_order()>>(setup);
  };
  const auto with_chi = [&](auto T, auto chi) {
    return setup.model.advection == AdvectionScheme::upwind ? with(T, chi, std::false_type{})
                                                            : with(T, chi, std::true_type{});
  };
  const auto with_T = [&](auto T) {
    return setup.solids.friction.model->has_unknown ? with_chi(T, std::true_type{}) : with_chi(T, std::false_type{});
  };
  return setup.model.temperature == TemperatureModel::transport ? with_T(std::true_type{}) : with_T(std::false_type{});
}

}  // namespace scree
