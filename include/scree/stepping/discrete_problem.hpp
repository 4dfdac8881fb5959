/// The model of a scene on PETSc: grid, matrix with the model's sparsity, and the callbacks of TS.
#pragma once

#include <petscts.h>

#include <memory>

#include "scree/equations/model.hpp"
#include "scree/stepping/gas_projection.hpp"

namespace scree {

/// What a problem is made of.
struct ProblemSetup {
  Box box;
  std::vector<Segment> segments;
  std::vector<Plate> plates;
  ModelParameters model;
  SolidsParameters solids;
  Scales scales;
};

enum class Phase { solids, gas };

/// Rate of change of the volume of each phase in the box plus its outflow through the sides [m^dim/s].
struct VolumeImbalance {
  double solids = 0, gas = 0;
};

/// What a residual leaves undone, beside its norm. All in units of the scales.
struct Remainder {
  double nu_change;  ///< root mean square of what DiscreteProblem::correct_continuity would do to nu
  double least_nu;   ///< nu of the emptiest cell afterwards
  double dilute;     ///< the largest change in storage that would balance a row of v, T or chi where nu < .1
};

/// Owns the DMDA, the model on this rank and the Jacobian matrix.
class DiscreteProblem {
 public:
  explicit DiscreteProblem(ProblemSetup setup) : setup_(std::move(setup)) {}
  ~DiscreteProblem();
  DiscreteProblem(const DiscreteProblem&) = delete;
  DiscreteProblem& operator=(const DiscreteProblem&) = delete;

  /// Collective: grid, model and matrix for the conditions that hold at `time`.
  PetscErrorCode create(MPI_Comm comm, double time);
  /// Conditions at `time`: the model and, since constraints may move, the matrix are made anew.
  PetscErrorCode update_conditions(double time);
  /// Gives `ts` the residual, the Jacobian and the grid.
  PetscErrorCode attach(TS ts);

  const ProblemSetup& setup() const { return setup_; }
  const Box& box() const { return setup_.box; }
  const Lattice& lattice() const { return *lattice_; }
  const Barriers& barriers() const { return *barriers_; }
  const Model& model() const { return *model_; }
  DM dm() const { return dm_; }
  /// While on, a Jacobian asked for is the last one: for the end of Newton's method.
  void keep_jacobian(bool on) { keeps_jacobian_ = on; }
  double last_shift() const { return last_shift_; }  ///< of the last Jacobian [1/s]
  Mat matrix() const { return matrix_; }

  /// F(t, U, dU/dt) into a global vector.
  PetscErrorCode residual(Vec state, Vec rate, Vec residual) const;

  /// Renews nu from continuity, and u so that the gas makes room: `residual` belongs to `state` and to the last
  /// evaluation by TS. The imbalances are zero but for rounding; where u is no unknown (gas darcy) that of the gas is
  /// what Newton's method leaves. u goes with nu as it was before, as in the fluxes of the step.
  PetscErrorCode correct_continuity(Vec state, Vec residual, VolumeImbalance* imbalance) const;
  /// How far off the state is that Newton's method has come to, by the residual that is left.
  PetscErrorCode remainder(Vec state, Vec residual, Remainder* remainder) const;
  /// Friction lagged by a step: chi of `state` after a step of dt of (23) without advection, or chi* itself.
  PetscErrorCode lag_friction(Vec state, double dt) const;
  /// Raises T of a first guess where it is too cold for a step of dt, see Model::raise_temperature.
  PetscErrorCode raise_temperature(Vec guess, double dt) const;
  /// Makes u obey the conditions on sides and plates, where u is an unknown.
  PetscErrorCode impose_gas(Vec state) const;
  /// Makes div(nu v + (1-nu) u) vanish by changing u inside and on open sides, where u is an unknown.
  PetscErrorCode project_gas(Vec state) const;
  /// Makes the mean of p_g zero where no side is open, i.e. where (2) and (4) leave it undetermined.
  PetscErrorCode settle_pressure(Vec state) const;
  /// Solids volume in the box [m^dim].
  PetscErrorCode solids_volume(Vec state, double* volume) const;
  /// Outflow of solids or gas through all sides of the box [m^dim/s].
  PetscErrorCode outflow(Vec state, Phase phase, double* flux) const;
  /// Flux of solids or gas along +axis through the faces nearest to `position` whose centres lie in `patch` [m^dim/s].
  PetscErrorCode plane_flux(Vec state, Phase phase, int axis, double position, const Patch& patch, double* flux) const;

 private:
  double flux(Phase phase, const double* state, int axis, const Index& I) const {
    return phase == Phase::solids ? model_->solids_flux(state, axis, I) : model_->gas_flux(state, axis, I);
  }
  static PetscErrorCode ifunction(TS, PetscReal, Vec state, Vec rate, Vec residual, void* problem);
  static PetscErrorCode ijacobian(TS, PetscReal, Vec state, Vec rate, PetscReal shift, Mat A, Mat P, void* problem);
  PetscErrorCode create_matrix();
  PetscErrorCode find_places();

  ProblemSetup setup_;
  DM dm_ = nullptr;
  Mat matrix_ = nullptr;
  std::unique_ptr<Lattice> lattice_;
  std::unique_ptr<Barriers> barriers_;
  std::unique_ptr<Model> model_;
  std::unique_ptr<GasProjection> gas_projection_;  ///< where u is an unknown
  EntryPlaces places_;
  std::vector<Field> stored_with_nu_;  ///< v, T, chi
  mutable Vec last_rate_ = nullptr;    ///< dU/dt of the last residual that TS asked for; not owned
  bool keeps_jacobian_ = false;
  double last_shift_ = 0;  ///< of the last Jacobian
};

/// Read access to the ghosted values of a global vector, for as long as it lives.
class GhostedArray {
 public:
  PetscErrorCode open(DM dm, Vec global);
  PetscErrorCode close();
  const double* data() const { return data_; }

 private:
  DM dm_ = nullptr;
  Vec local_ = nullptr;
  const double* data_ = nullptr;
};

}  // namespace scree
