/// Options in PETSc's database for as long as they are needed.
#pragma once

#include <petscsys.h>

#include <string>
#include <utility>
#include <vector>

namespace scree {

using PetscOptionList = std::vector<std::pair<std::string, std::string>>;

/// The one place where options of our own enter PETSc's database, which is how solvers inside of solvers get theirs:
/// they are made, and look there, when the solver around them is set up.
class ScopedOptions {
 public:
  ScopedOptions() = default;
  ~ScopedOptions();
  ScopedOptions(const ScopedOptions&) = delete;
  ScopedOptions& operator=(const ScopedOptions&) = delete;

  /// Takes out what this object has put in before, and puts in the options of `list`, names without "-", for the solver
  /// with this prefix. Those that are set already, by the user, stay as they are.
  PetscErrorCode set(const std::string& prefix, const PetscOptionList& list);
  PetscErrorCode clear();

 private:
  std::vector<std::string> names_;  ///< of the options put in, with "-" and prefix
};

}  // namespace scree
