#include "scree/stepping/grid_of_nodes.hpp"

namespace scree {

static constexpr const char* key = "scree_grid_of_nodes";

PetscErrorCode set_grid_of_nodes(Mat matrix, DM dm) {
  PetscFunctionBeginUser;
  Mat own;
  PetscCall(MatGetDiagonalBlock(matrix, &own));
  for (Mat m : {matrix, own})
    PetscCall(PetscObjectCompose(reinterpret_cast<PetscObject>(m), key, reinterpret_cast<PetscObject>(dm)));
  PetscFunctionReturn(0);
}

PetscErrorCode get_grid_of_nodes(Mat matrix, DM* dm) {
  PetscFunctionBeginUser;
  PetscCall(PetscObjectQuery(reinterpret_cast<PetscObject>(matrix), key, reinterpret_cast<PetscObject*>(dm)));
  PetscFunctionReturn(0);
}

}  // namespace scree
