#include "scree/grid/ghosted.hpp"

namespace scree {

PetscErrorCode GhostedArray::open(DM dm, Vec global) {
  PetscFunctionBeginUser;
  dm_ = dm;
  PetscCall(DMGetLocalVector(dm, &local_));
  PetscCall(VecZeroEntries(local_));  // nodes beyond the box: read by kernels with weight zero
  PetscCall(DMGlobalToLocal(dm, global, INSERT_VALUES, local_));
  PetscCall(VecGetArrayRead(local_, &data_));
  PetscFunctionReturn(0);
}

PetscErrorCode GhostedArray::close() {
  PetscFunctionBeginUser;
  if (data_) PetscCall(VecRestoreArrayRead(local_, &data_));
  if (local_) PetscCall(DMRestoreLocalVector(dm_, &local_));
  PetscFunctionReturn(0);
}

}  // namespace scree
