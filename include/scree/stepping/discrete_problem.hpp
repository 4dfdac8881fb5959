/// The model of a scene on PETSc: grid, residual, and the matrix with the model's sparsity.
#pragma once

#include <petscdmda.h>

#include <memory>

#include "scree/grid/ghosted.hpp"
#include "scree/model/model.hpp"
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
  ModelFactory models{make_model, {}};
};

enum class Phase { solids, gas };

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

  /// The constant part of grad p_g along periodic axes, from now on [Pa/m].
  void set_mean_pressure_gradient(const std::array<double, max_dim>& gradient) {
    setup_.model.mean_pressure_gradient = gradient;
    model_->set_mean_pressure_gradient(gradient);
  }

  const ProblemSetup& setup() const { return setup_; }
  const Box& box() const { return setup_.box; }
  const Lattice& lattice() const { return *lattice_; }
  const Barriers& barriers() const { return *barriers_; }
  const Model& model() const { return *model_; }
  DM dm() const { return dm_; }
  Mat matrix() const { return matrix_; }
  /// nullptr where u is no unknown. Its solver works in place: problems are not for several threads.
  GasProjection* gas_projection() const { return gas_projection_.get(); }

  /// F(time, U, dU/dt) into a global vector. Collective, like all below.
  PetscErrorCode residual(double time, Vec state, Vec rate, Vec residual) const;
  /// dF/dU + shift dF/d(dU/dt) into a matrix of the pattern of matrix().
  PetscErrorCode jacobian(double time, Vec state, Vec rate, double shift, Mat jacobian) const;

  /// Solids volume in the box [m^dim].
  PetscErrorCode solids_volume(Vec state, double* volume) const;
  /// Outflow of solids or gas through all sides of the box [m^dim/s].
  PetscErrorCode outflow(double time, Vec state, Phase phase, double* flux) const;
  /// Flux of solids or gas along +axis through the faces nearest to `position` whose centres lie in `patch` [m^dim/s].
  PetscErrorCode plane_flux(double time, Vec state, Phase phase, int axis, double position, const Patch& patch,
                            double* flux) const;

 private:
  double flux(double time, Phase phase, const double* state, int axis, const Index& I) const {
    return phase == Phase::solids ? model_->solids_flux(state, axis, I) : model_->gas_flux(time, state, axis, I);
  }
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
};

}  // namespace scree
