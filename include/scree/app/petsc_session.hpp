/// PETSc from its start to its end, with the options that are its own.
#pragma once

#include <string>
#include <vector>

#include "scree/config/case.hpp"

namespace scree {

/// Options of case files yield to PETSC_OPTIONS and ~/.petscrc, those to the command line. MPI runs before and after.
class PetscSession {
 public:
  /// Throws std::runtime_error if PETSc does not start.
  PetscSession(const char* program, const std::vector<PetscOption>& options);
  ~PetscSession();
  PetscSession(const PetscSession&) = delete;
  PetscSession& operator=(const PetscSession&) = delete;

  /// Throws InputError if PETSc got an option that is ours to know, from the environment or a file of its own.
  void check_options() const;

  /// The options that look like those of PETSc's solvers, but no solver has asked for: misspelt, or of another solver.
  std::vector<std::string> unused() const;

 private:
  std::vector<PetscOption> options_;
};

}  // namespace scree
