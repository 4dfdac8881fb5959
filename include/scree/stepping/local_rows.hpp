/// The rows of an AIJ matrix on this rank as arrays.
#pragma once

#include <petscmat.h>

#include <array>

namespace scree {

/// Access from open() to close() or to the end of its life. Opened to be changed, entries may be, and PETSc takes them
/// for changed, which makes preconditioners anew; the pattern stays.
class LocalRows {
 public:
  /// Compressed rows; columns rise within each.
  struct Part {
    Mat matrix = nullptr;
    const PetscInt *row = nullptr, *column = nullptr;
    PetscScalar* value = nullptr;
  };

  LocalRows() = default;
  ~LocalRows() { (void)close(); }
  LocalRows(const LocalRows&) = delete;
  LocalRows& operator=(const LocalRows&) = delete;

  PetscErrorCode open(Mat A) { return open(A, false); }
  PetscErrorCode open_to_change(Mat A) { return open(A, true); }
  PetscErrorCode close();

  std::array<Part, 2> part;  ///< columns of this rank, from its first; columns of others, numbers in `ghosts`
  int parts = 0;             ///< 1 on one rank
  PetscInt rows = 0, first_row = 0, first_column = 0, columns = 0;  ///< of this rank; first ones global
  const PetscInt* ghosts = nullptr;                                 ///< global columns, rising
  PetscInt ghost_count = 0;

 private:
  PetscErrorCode open(Mat A, bool changes);

  bool changes_ = false;
};

}  // namespace scree
