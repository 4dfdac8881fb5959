/// Values of a state on the nodes of this rank and on those about them.
#pragma once

#include <petscdmda.h>

namespace scree {

/// Read access to the ghosted values of a global vector, from open() to close() or to the end of its life. Values of
/// node I stand at Lattice::ghosted(I) * unknowns; nodes beyond the box hold zero.
class GhostedArray {
 public:
  GhostedArray() = default;
  ~GhostedArray() { (void)close(); }
  GhostedArray(const GhostedArray&) = delete;
  GhostedArray& operator=(const GhostedArray&) = delete;

  /// Collective.
  PetscErrorCode open(DM dm, Vec global);
  PetscErrorCode close();
  const double* data() const { return data_; }

 private:
  DM dm_ = nullptr;
  Vec local_ = nullptr;
  const double* data_ = nullptr;
};

}  // namespace scree
