#include "scree/stepping/gas_projection.hpp"

#include <algorithm>
#include <cmath>

#include "scree/balances/layout.hpp"
#include "scree/grid/ghosted.hpp"
#include "scree/stepping/petsc_versions.hpp"

namespace scree {

namespace {

/// Imbalance of a cell, as a share of the greatest flow through a cell, that is rounding.
constexpr double rounding = 1e-15;
/// Each pass takes some eight digits off the imbalance.
constexpr int most_passes = 3;

/// Conductance of a face: area over the distance between the potentials; that of an open side lies on the face.
double conductance(const Lattice& grid, int axis, const Index& I) {
  return grid.face_area(axis, I) / grid.control_length(axis, I);
}

}  // namespace

GasProjection::~GasProjection() {
  PetscCallAbort(PETSC_COMM_SELF, KSPDestroy(&ksp_));
  PetscCallAbort(PETSC_COMM_SELF, VecDestroy(&source_));
  PetscCallAbort(PETSC_COMM_SELF, VecDestroy(&potential_));
  PetscCallAbort(PETSC_COMM_SELF, DMDestroy(&scalars_));
}

bool GasProjection::passes(int axis, const Index& I) const {
  if (!lattice_.is_face(axis, I)) return false;
  return !barriers_.at(axis, I) || barriers_.condition(axis, I).kind.open_to_gas();
}

PetscErrorCode GasProjection::create(DM dm) {
  PetscFunctionBeginUser;
  states_ = dm;
  PetscCall(DMDACreateCompatibleDMDA(dm, 1, &scalars_));
  PetscCall(DMSetMatType(scalars_, MATAIJ));
  Mat matrix;
  PetscCall(DMCreateMatrix(scalars_, &matrix));
  PetscCall(assemble(matrix));
  PetscCall(DMCreateGlobalVector(scalars_, &source_));
  PetscCall(VecDuplicate(source_, &potential_));

  PetscCall(KSPCreate(PetscObjectComm(reinterpret_cast<PetscObject>(dm)), &ksp_));
  PetscCall(KSPSetOptionsPrefix(ksp_, "gas_projection_"));
  PetscCall(KSPSetOperators(ksp_, matrix, matrix));
  PetscCall(KSPSetType(ksp_, KSPCG));
  PetscCall(KSPSetNormType(ksp_, KSP_NORM_UNPRECONDITIONED));
  PetscCall(KSPSetTolerances(ksp_, 1e-8, petsc_unchanged, petsc_unchanged, 50));
  PetscCall(set_preconditioner());
  PetscCall(KSPSetFromOptions(ksp_));
  PetscCall(MatDestroy(&matrix));
  PetscFunctionReturn(0);
}

/// The matrix stays, so that one factorisation serves for the whole run: each rank keeps the whole factor, which it
/// applies in less time than messages would take. BoomerAMG would take some sixteen iterations a step; it is left to
/// grids whose factor would be large.
PetscErrorCode GasProjection::set_preconditioner() {
  PetscFunctionBeginUser;
  const int dim = lattice_.dim, most_cells = dim < 3 ? 100000 : 20000;
  int cells = 1;
  for (int axis = 0; axis < dim; ++axis) cells *= lattice_.axes[axis].cells();
  PC pc;
  PetscCall(KSPGetPC(ksp_, &pc));
  if (cells > most_cells) {
    PetscCall(PCSetType(pc, PCHYPRE));
    PetscCall(PCHYPRESetType(pc, "boomeramg"));
    PetscFunctionReturn(0);
  }
  KSP whole;
  PC factor;
  PetscCall(PCSetType(pc, PCREDUNDANT));
  PetscCall(PCRedundantGetKSP(pc, &whole));
  PetscCall(KSPGetPC(whole, &factor));
  PetscCall(PCSetType(factor, PCCHOLESKY));
  PetscCall(PCFactorSetMatOrderingType(factor, MATORDERINGND));
  PetscFunctionReturn(0);
}

PetscErrorCode GasProjection::assemble(Mat matrix) const {
  PetscFunctionBeginUser;
  constexpr double hold = 1e-12;  // settles the potential where no side is open
  const auto stencil = [](const Index& I) {
    MatStencil at{};
    at.i = I[0];
    at.j = I[1];
    at.k = I[2];
    return at;
  };
  PetscErrorCode error = 0;
  for_each_node(lattice_.owned_first, lattice_.owned_count, [&](const Index& I) {
    const MatStencil row = stencil(I);
    double diagonal = 0, all = 0;
    const auto set = [&](const MatStencil& column, double value) {
      if (error == 0) error = MatSetValuesStencil(matrix, 1, &row, 1, &column, &value, INSERT_VALUES);
    };
    for (int axis = 0; axis < lattice_.dim && lattice_.inside(I); ++axis)
      for (int side = 0; side < 2; ++side) {
        const Index face = I + side * unit(axis), neighbour = I + (2 * side - 1) * unit(axis);
        const double c = conductance(lattice_, axis, face);
        all += c;
        if (!passes(axis, face)) continue;
        diagonal += c;
        if (lattice_.inside(neighbour)) set(stencil(neighbour), -c);
      }
    set(row, lattice_.inside(I) ? diagonal + hold * all : 1.0);
  });
  PetscCall(error);
  PetscCall(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
  PetscCall(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
  PetscCall(MatSetOption(matrix, MAT_SPD, PETSC_TRUE));
  PetscFunctionReturn(0);
}

/// Volume that the fluxes of `state` at `time` take out of each cell in unit time, its greatest value, and the greatest
/// flow through a face [m^dim/s].
PetscErrorCode GasProjection::divergence(double time, Vec state, Vec volume_rate, double* greatest,
                                         double* flow) const {
  PetscFunctionBeginUser;
  GhostedArray u;
  PetscCall(u.open(states_, state));
  double* rate;
  PetscCall(VecGetArrayWrite(volume_rate, &rate));
  double most[2] = {0, 0};
  for_each_node(lattice_.owned_first, lattice_.owned_count, [&](const Index& I) {
    double sum = 0;
    for (int axis = 0; axis < lattice_.dim && lattice_.inside(I); ++axis)
      for (int side = 0; side < 2; ++side) {
        const Index face = I + side * unit(axis);
        const double out = lattice_.face_area(axis, face) *
                           (model_.solids_flux(u.data(), axis, face) + model_.gas_flux(time, u.data(), axis, face));
        sum += side == 0 ? -out : out;
        most[1] = std::max(most[1], std::abs(out));
      }
    rate[lattice_.owned(I)] = sum;
    most[0] = std::max(most[0], std::abs(sum));
  });
  PetscCall(VecRestoreArrayWrite(volume_rate, &rate));
  PetscCall(u.close());
  PetscCallMPI(MPI_Allreduce(MPI_IN_PLACE, most, 2, MPI_DOUBLE, MPI_MAX,
                             PetscObjectComm(reinterpret_cast<PetscObject>(states_))));
  *greatest = most[0];
  *flow = most[1];
  PetscFunctionReturn(0);
}

PetscErrorCode GasProjection::apply(double time, Vec state) {
  PetscFunctionBeginUser;
  double greatest, flow;
  for (int pass = 0; pass < most_passes; ++pass) {
    PetscCall(divergence(time, state, source_, &greatest, &flow));
    if (!(greatest > rounding * flow)) PetscFunctionReturn(0);
    PetscCall(KSPSolve(ksp_, source_, potential_));
    PetscCall(correct(state));
  }
  PetscFunctionReturn(0);
}

/// Adds the fluxes that the potential drives to those of u.
PetscErrorCode GasProjection::correct(Vec state) const {
  PetscFunctionBeginUser;
  GhostedArray phi, old;
  PetscCall(phi.open(scalars_, potential_));
  PetscCall(old.open(states_, state));
  double* x;
  PetscCall(VecGetArray(state, &x));
  const int unknowns = model_.unknowns();
  for_each_node(lattice_.owned_first, lattice_.owned_count, [&](const Index& I) {
    for (int axis = 0; axis < lattice_.dim; ++axis) {
      if (!passes(axis, I)) continue;
      const Index below = I - unit(axis);
      const double nu[2] = {old.data()[lattice_.ghosted(below) * unknowns + Model::solids_fraction],
                            old.data()[lattice_.ghosted(I) * unknowns + Model::solids_fraction]};
      const bool has_below = lattice_.inside(below), has_above = lattice_.inside(I);
      const double difference =
          (has_below ? phi.data()[lattice_.ghosted(below)] : 0) - (has_above ? phi.data()[lattice_.ghosted(I)] : 0);
      const double share = lattice_.axes[axis].lower_share(I[axis]);
      const double nu_face = !has_below ? nu[1] : !has_above ? nu[0] : share * nu[0] + (1 - share) * nu[1];
      const int component = model_.component<GasMomentum>(axis);
      x[lattice_.owned(I) * unknowns + component] -= difference / lattice_.control_length(axis, I) / (1 - nu_face) /
                                                     model_.fields()[static_cast<std::size_t>(component)].scale;
    }
  });
  PetscCall(VecRestoreArray(state, &x));
  PetscCall(old.close());
  PetscCall(phi.close());
  PetscFunctionReturn(0);
}

}  // namespace scree
