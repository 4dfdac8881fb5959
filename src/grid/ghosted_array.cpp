#include "scree/grid/ghosted_array.hpp"

namespace scree {

PetscErrorCode GhostedArray::open(DM dm, Vec global) {
  PetscFunctionBeginUser;
  dm_ = dm;
  PetscCall(DMGetLocalVector(dm, &local_));
  PetscCall(VecZeroEntries(local_));
  PetscCall(DMGlobalToLocal(dm, global, INSERT_VALUES, local_));
  PetscCall(VecGetArrayRead(local_, &data_));
  PetscFunctionReturn(0);
}

PetscErrorCode GhostedArray::close() {
  PetscFunctionBeginUser;
  PetscCall(VecRestoreArrayRead(local_, &data_));
  PetscCall(DMRestoreLocalVector(dm_, &local_));
  PetscFunctionReturn(0);
}

}  // namespace scree
