#include "scree/stepping/scoped_options.hpp"

namespace scree {

ScopedOptions::~ScopedOptions() { PetscCallAbort(PETSC_COMM_SELF, clear()); }

PetscErrorCode ScopedOptions::set(const std::string& prefix, const PetscOptionList& list) {
  PetscFunctionBeginUser;
  PetscCall(clear());
  for (const auto& [name, value] : list) {
    const std::string option = "-" + prefix + name;
    PetscBool given;
    PetscCall(PetscOptionsHasName(nullptr, nullptr, option.c_str(), &given));
    if (given) continue;
    PetscCall(PetscOptionsSetValue(nullptr, option.c_str(), value.c_str()));
    names_.push_back(option);
  }
  PetscFunctionReturn(0);
}

PetscErrorCode ScopedOptions::clear() {
  PetscFunctionBeginUser;
  for (const std::string& name : names_) PetscCall(PetscOptionsClearValue(nullptr, name.c_str()));
  names_.clear();
  PetscFunctionReturn(0);
}

}  // namespace scree
