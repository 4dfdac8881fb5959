/// Makes the balance of gas volume exact to rounding after Newton's method has met it to its tolerance.
#pragma once

#include <petscksp.h>

#include <vector>

#include "scree/model/model.hpp"

namespace scree {

/// The least change of the gas fluxes of a state that makes div(nu v + (1-nu) u) vanish in every cell: minus the
/// gradient of a potential, by Cholesky factorisation, on large grids by conjugate gradients with BoomerAMG (options
/// prefix "gas_projection_"). Its matrix is that of the grid and its barriers alone, set up once. For models in which u
/// is an unknown.
class GasProjection {
 public:
  /// The referenced objects must outlive it. Collective.
  GasProjection(const Lattice& lattice, const Barriers& barriers, const Model& model) noexcept
      : lattice_(lattice), barriers_(barriers), model_(model) {}
  ~GasProjection();
  GasProjection(const GasProjection&) = delete;
  GasProjection& operator=(const GasProjection&) = delete;

  /// Collective: `dm` is that of the states.
  PetscErrorCode create(DM dm);
  /// Changes u in `state` at `time` [s], nu and v staying as they are. Does nothing where the fluxes balance already.
  PetscErrorCode apply(double time, Vec state);

 private:
  bool passes(int axis, const Index& I) const;
  PetscErrorCode set_preconditioner();
  PetscErrorCode assemble(Mat matrix) const;
  PetscErrorCode divergence(double time, Vec state, Vec volume_rate, double* greatest, double* flow) const;
  PetscErrorCode correct(Vec state) const;

  const Lattice& lattice_;
  const Barriers& barriers_;
  const Model& model_;
  DM states_ = nullptr, scalars_ = nullptr;
  KSP ksp_ = nullptr;
  Vec source_ = nullptr, potential_ = nullptr;
};

}  // namespace scree
