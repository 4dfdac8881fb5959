/// Read access to a global vector with the values of neighbouring ranks.
#pragma once

#include <petscdm.h>

namespace scree {

/// The ghosted values of a global vector, from open to close. Nodes beyond the box hold zero: kernels read them with
/// weight zero.
class GhostedArray {
 public:
  PetscErrorCode open(DM dm, Vec global);  ///< collective
  PetscErrorCode close();
  const double* data() const { return data_; }

 private:
  DM dm_ = nullptr;
  Vec local_ = nullptr;
  const double* data_ = nullptr;
};

}  // namespace scree
