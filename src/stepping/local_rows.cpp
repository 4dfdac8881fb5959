#include "scree/stepping/local_rows.hpp"

namespace scree {

PetscErrorCode LocalRows::open(Mat A, bool changes) {
  PetscFunctionBeginUser;
  PetscCall(close());
  PetscInt end, last;
  PetscBool parallel, done;
  PetscCall(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(A), MATMPIAIJ, &parallel));
  changes_ = changes;
  parts = parallel ? 2 : 1;
  part[0].matrix = A;
  if (parallel) PetscCall(MatMPIAIJGetSeqAIJ(A, &part[0].matrix, &part[1].matrix, &ghosts));
  if (parallel) PetscCall(MatGetSize(part[1].matrix, nullptr, &ghost_count));
  PetscCall(MatGetOwnershipRange(A, &first_row, &end));
  PetscCall(MatGetOwnershipRangeColumn(A, &first_column, &last));
  rows = end - first_row;
  columns = last - first_column;
  for (int k = 0; k < parts; ++k) {
    PetscInt count;
    PetscCall(MatGetRowIJ(part[k].matrix, 0, PETSC_FALSE, PETSC_FALSE, &count, &part[k].row, &part[k].column, &done));
    PetscCheck(done, PETSC_COMM_SELF, PETSC_ERR_SUP, "the matrix has no compressed rows");
    const PetscScalar* value;
    if (changes) PetscCall(MatSeqAIJGetArray(part[k].matrix, &part[k].value));
    if (!changes) PetscCall(MatSeqAIJGetArrayRead(part[k].matrix, &value));
    if (!changes) part[k].value = const_cast<PetscScalar*>(value);
  }
  PetscFunctionReturn(0);
}

PetscErrorCode LocalRows::close() {
  PetscFunctionBeginUser;
  for (int k = 0; k < parts; ++k) {
    PetscInt count;
    PetscBool done;
    PetscCall(
        MatRestoreRowIJ(part[k].matrix, 0, PETSC_FALSE, PETSC_FALSE, &count, &part[k].row, &part[k].column, &done));
    const PetscScalar* value = part[k].value;
    if (changes_) PetscCall(MatSeqAIJRestoreArray(part[k].matrix, &part[k].value));
    if (!changes_) PetscCall(MatSeqAIJRestoreArrayRead(part[k].matrix, &value));
  }
  part = {};
  parts = 0;
  ghosts = nullptr;
  ghost_count = 0;
  PetscFunctionReturn(0);
}

}  // namespace scree
