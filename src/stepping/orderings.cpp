#include "scree/stepping/orderings.hpp"

namespace scree {

namespace {

PetscErrorCode last_node_first(Mat A, MatOrderingType, IS* rows, IS* columns) {
  PetscFunctionBeginUser;
  PetscInt size, unknowns;
  PetscInt* order;
  PetscCall(MatGetLocalSize(A, &size, nullptr));
  PetscCall(MatGetBlockSize(A, &unknowns));
  PetscCall(PetscMalloc1(size, &order));
  for (PetscInt k = 0; k < size; ++k) order[k] = size - unknowns - k / unknowns * unknowns + k % unknowns;
  PetscCall(ISCreateGeneral(PETSC_COMM_SELF, size, order, PETSC_OWN_POINTER, rows));
  PetscCall(ISSetPermutation(*rows));
  PetscCall(ISDuplicate(*rows, columns));
  PetscCall(ISSetPermutation(*columns));
  PetscFunctionReturn(0);
}

}  // namespace

PetscErrorCode register_orderings() {
  PetscFunctionBeginUser;
  PetscCall(MatOrderingRegister("last_node_first", last_node_first));
  PetscFunctionReturn(0);
}

}  // namespace scree
