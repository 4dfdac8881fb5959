#include "scree/stepping/condensed_preconditioner.hpp"

#include <petscksp.h>

#include <memory>

#include "scree/stepping/condensation.hpp"
#include "scree/stepping/grid_of_nodes.hpp"
#include "scree/stepping/shell_preconditioner.hpp"
#include "scree/stepping/staggered_multigrid.hpp"

namespace scree {

namespace {

class CondensedPreconditioner {
 public:
  static constexpr const char* name = "condensed";

  CondensedPreconditioner() = default;
  ~CondensedPreconditioner() { PetscCallAbort(PETSC_COMM_SELF, clear()); }
  CondensedPreconditioner(const CondensedPreconditioner&) = delete;
  CondensedPreconditioner& operator=(const CondensedPreconditioner&) = delete;

  /// For the matrix of `pc`, whose pattern may be another than before.
  PetscErrorCode set_up(PC pc) {
    PetscFunctionBeginUser;
    Mat matrix;
    bool other = true, regular = false;
    PetscCall(PCGetOperators(pc, nullptr, &matrix));
    PetscCall(pattern_.take(matrix, &other));
    if (other) PetscCall(create(pc, matrix));
    PetscCall(condensation_->update(matrix, &regular));
    PetscCall(PCSetFailedReason(pc, regular ? PC_NOERROR : PC_FACTOR_NUMERIC_ZEROPIVOT));
    if (!regular) PetscFunctionReturn(0);
    for (KSP solver : {core_, rest_}) {
      PetscCall(KSPSetUp(solver));
      PetscCall(KSPSetUpOnBlocks(solver));
    }
    PetscFunctionReturn(0);
  }

  PetscErrorCode apply(PC pc, Vec x, Vec y) {
    PetscFunctionBeginUser;
    PetscCall(condensation_->split(x, x_core_, x_rest_));
    PetscCall(condensation_->solve_nodes(x_rest_, y_rest_));
    PetscCall(MatMult(condensation_->core_rest(), y_rest_, y_core_));
    PetscCall(VecAYPX(y_core_, -1, x_core_));
    PetscCall(KSPSolve(core_, y_core_, x_core_));
    PetscCall(KSPCheckSolve(core_, pc, x_core_));
    PetscCall(MatMult(condensation_->rest_core(), x_core_, y_rest_));
    PetscCall(VecAXPY(x_rest_, -1, y_rest_));
    PetscCall(KSPSolve(rest_, x_rest_, y_rest_));
    PetscCall(KSPCheckSolve(rest_, pc, y_rest_));
    PetscCall(condensation_->join(x_core_, y_rest_, y));
    PetscFunctionReturn(0);
  }

  PetscErrorCode view(PetscViewer viewer) const {
    PetscFunctionBeginUser;
    if (!core_) PetscFunctionReturn(0);
    PetscCall(PetscViewerASCIIPushTab(viewer));
    PetscCall(PetscViewerASCIIPrintf(viewer, "solver of the core\n"));
    PetscCall(KSPView(core_, viewer));
    PetscCall(PetscViewerASCIIPrintf(viewer, "solver of the eliminated unknowns\n"));
    PetscCall(KSPView(rest_, viewer));
    PetscCall(PetscViewerASCIIPopTab(viewer));
    PetscFunctionReturn(0);
  }

 private:
  PetscErrorCode clear() {
    PetscFunctionBeginUser;
    for (KSP* solver : {&core_, &rest_}) PetscCall(KSPDestroy(solver));
    for (Vec* vector : {&x_core_, &y_core_, &x_rest_, &y_rest_}) PetscCall(VecDestroy(vector));
    condensation_.reset();
    PetscFunctionReturn(0);
  }

  PetscErrorCode create(PC pc, Mat matrix) {
    PetscFunctionBeginUser;
    PetscCall(clear());
    const char* prefix;
    PetscInt unknowns, count;
    PetscCall(PCGetOptionsPrefix(pc, &prefix));
    PetscCall(MatGetBlockSize(matrix, &unknowns));
    count = unknowns;
    std::vector<PetscInt> eliminated(static_cast<std::size_t>(unknowns));
    PetscCall(PetscOptionsGetIntArray(nullptr, prefix, "-pc_condensed_eliminated", eliminated.data(), &count, nullptr));
    eliminated.resize(static_cast<std::size_t>(count));
    condensation_ = std::make_unique<Condensation>();
    PetscCall(condensation_->create(matrix, eliminated));
    PetscCall(give_grid(pc));
    PetscCall(create_solver(pc, prefix, "condensed_core_", condensation_->core(), &core_));
    PetscCall(create_solver(pc, prefix, "condensed_rest_", condensation_->rest(), &rest_));
    PetscCall(MatCreateVecs(condensation_->core(), &x_core_, &y_core_));
    PetscCall(MatCreateVecs(condensation_->rest(), &x_rest_, &y_rest_));
    PetscFunctionReturn(0);
  }

  static PetscErrorCode create_solver(PC pc, const char* outer, const char* own, Mat matrix, KSP* solver) {
    PetscFunctionBeginUser;
    PetscCall(KSPCreate(PetscObjectComm(reinterpret_cast<PetscObject>(pc)), solver));
    PetscCall(
        PetscObjectIncrementTabLevel(reinterpret_cast<PetscObject>(*solver), reinterpret_cast<PetscObject>(pc), 1));
    PetscCall(KSPSetErrorIfNotConverged(*solver, PETSC_FALSE));
    PetscCall(KSPSetType(*solver, KSPPREONLY));
    PetscCall(KSPSetOptionsPrefix(*solver, outer));
    PetscCall(KSPAppendOptionsPrefix(*solver, own));
    PetscCall(KSPSetOperators(*solver, matrix, matrix));
    PetscCall(KSPSetFromOptions(*solver));
    PetscFunctionReturn(0);
  }

  /// For preconditioners that need to know the nodes. The solver itself is not told: multigrid of PETSc's would take
  /// the grid, which has more unknowns, for that of its matrix.
  PetscErrorCode give_grid(PC pc) {
    PetscFunctionBeginUser;
    DM dm;
    PetscCall(PCGetDM(pc, &dm));
    if (!dm) PetscFunctionReturn(0);
    for (Mat block : {condensation_->core(), condensation_->rest()}) PetscCall(set_grid_of_nodes(block, dm));
    PetscFunctionReturn(0);
  }

  std::unique_ptr<Condensation> condensation_;
  KnownPattern pattern_;  ///< that the condensation has
  KSP core_ = nullptr, rest_ = nullptr;
  Vec x_core_ = nullptr, y_core_ = nullptr, x_rest_ = nullptr, y_rest_ = nullptr;
};

}  // namespace

PetscErrorCode register_condensed_preconditioner() {
  PetscFunctionBeginUser;
  PetscCall(PCRegister(CondensedPreconditioner::name, ShellPreconditioner<CondensedPreconditioner>::make));
  PetscFunctionReturn(0);
}

}  // namespace scree
