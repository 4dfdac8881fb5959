/// The model of a scene as the solver sees it: its unknowns, its residual, its Jacobian. Which balances it is made of
/// is decided once, in make_model.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "scree/assembly/entries.hpp"
#include "scree/assembly/newton_tangent.hpp"
#include "scree/assembly/parameters.hpp"
#include "scree/boundary/barriers.hpp"
#include "scree/grid/metrics.hpp"
#include "scree/grid/unknown.hpp"

namespace scree {

/// All balances of a scene on the nodes of one rank. States and rates are arrays over ghosted nodes, residuals over
/// owned ones, interlaced by component; all are dimensionless (SI = scale * stored).
class Model {
 public:
  virtual ~Model() = default;

  static constexpr int solids_fraction = 0;  ///< component of nu, the first in every layout
  virtual int unknowns() const = 0;          ///< per node
  virtual const std::vector<Field>& fields() const = 0;

  /// Residual F(t, U, dU/dt) at `time` [s], every owned row set. Row scales: (1) and (23) by the time scale; (3) by
  /// rho_s g.
  virtual void residual(double time, const double* state, const double* rate, double* residual) const = 0;
  /// The entries that `jacobian` produces.
  virtual void sparsity(EntrySink& sink) const = 0;
  /// Adds dF/dU + shift dF/d(dU/dt) into the arrays of the two blocks, zeroed by the caller.
  virtual void jacobian(double time, const double* state, const double* rate, double shift, const EntryPlaces& places,
                        double* diagonal, double* off_diagonal) const = 0;

  /// Newton's method begins anew, with this tangent: see assembly/newton_tangent.hpp. `step`: that of backward Euler, 0
  /// for other schemes [s].
  virtual void begin_newton(TangentKind tangent, double step) const = 0;
  /// Changes what ModelParameters gave [Pa/m].
  virtual void set_mean_pressure_gradient(const std::array<double, max_dim>& gradient) = 0;

  /// The residual of (1) at an owned cell is rate - divergence in units of 1/time scale; this is that factor.
  virtual double continuity_scale() const = 0;
  /// Volume flux of solids nu v at the lower `axis` face of an owned node, SI, as in the balances [m/s].
  virtual double solids_flux(const double* state, int axis, const Index& I) const = 0;
  /// Volume flux of gas (1-nu) u there at `time`, on which inlets depend [m/s]; 0 without gas.
  virtual double gas_flux(double time, const double* state, int axis, const Index& I) const = 0;
  /// Force of the particles in one of the two cells at the lower `axis` face of I, a wall, on an area of it at `time`
  /// [Pa]: pressure and impact along the axis, shear along the others. `cells`: whether the upper or the lower cell.
  virtual std::array<double, max_dim> wall_traction(double time, const double* state, int axis, const Index& I,
                                                    End cells) const = 0;
  /// Sets u on sides and plates to what their conditions say at `time` for the nu of `state`; `owned` is the same state
  /// without ghosts.
  virtual void impose_gas(double time, const double* state, double* owned) const = 0;
  /// Moves chi in `owned`, the same state without ghosts, by `share` of its way to chi* (21) of `state`, where it is an
  /// unknown.
  virtual void relax_chi(const double* state, double share, double* owned) const = 0;
  /// First guess of a step of dt: raises T of `owned` where it is far below what a step from `state` would give. From
  /// there Newton's method would find T < 0, which production ~ sqrt(T) makes a second way to a small residual.
  /// Cells below `least_nu` are left alone.
  virtual void raise_temperature(const double* state, double dt, double least_nu, double* owned) const = 0;
  /// Values of derived_fields at the owned nodes in SI, one array a field in the order of Lattice::owned, 0 outside of
  /// the box.
  virtual std::vector<std::vector<double>> derived_values(const double* state) const = 0;
  /// Component of an unknown in a node, of a vector along `axis`; -1 where the scene has no such unknown.
  template <class Balance>
  int component(int axis = 0) const {
    for (const Field& field : fields())
      if (field.is<Balance>()) return field.component + axis;
    return -1;
  }
  /// Whether row `component` of node I is a balance (and not a constraint of a side, or padding).
  virtual bool is_balance(int component, const Index& I) const = 0;
};

/// Everything a model is made of. The referenced objects must outlive it.
struct ModelSetup {
  const Lattice& lattice;
  const Barriers& barriers;
  ModelParameters model;
  SolidsParameters solids;
  Scales scales;
};

/// What makes the models of a program: the balances of the paper, or these and more (kernels/carried_scalar.hpp).
struct ModelFactory {
  std::unique_ptr<Model> (*make)(const ModelSetup&);
  std::vector<const Unknown*> further;  ///< unknowns beyond those of the standard models, in their order

  /// The number of unknowns a node and the stencil width of the model for these parameters.
  std::pair<int, int> extent(int dim, const ModelParameters& model, const SolidsParameters& solids) const;
  /// The unknowns that its models have, as Model::fields gives them.
  std::vector<Field> fields(int dim, const ModelParameters& model, const SolidsParameters& solids,
                            const Scales& scales) const;
};

/// The paper's balances in one to three dimensions.
std::unique_ptr<Model> make_model(const ModelSetup& setup);

}  // namespace scree
