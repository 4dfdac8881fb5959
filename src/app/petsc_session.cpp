#include "scree/app/petsc_session.hpp"

#include <petscsys.h>

#include <algorithm>
#include <stdexcept>

#include "scree/config/case_input.hpp"
#include "scree/config/input_error.hpp"

namespace scree {

PetscSession::PetscSession(const char* program, const std::vector<PetscOption>& options) : options_(options) {
  std::vector<std::string> words{program};
  for (const PetscOption& option : options) {
    const std::string name = "-" + option.key;
    if (option.on_command_line) {
      words.push_back(name);
      if (!option.value.empty()) words.push_back(option.value);
    } else if (PetscOptionsSetValue(nullptr, name.c_str(), option.value.empty() ? nullptr : option.value.c_str())) {
      throw std::runtime_error("PETSc refuses the option " + name);
    }
  }
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  int count = static_cast<int>(arguments.size());
  arguments.push_back(nullptr);
  char** pointer = arguments.data();
  if (PetscInitialize(&count, &pointer, nullptr, nullptr)) throw std::runtime_error("PETSc does not start");
}

PetscSession::~PetscSession() { (void)PetscFinalize(); }

void PetscSession::check_options() const {
  PetscInt count = 0;
  char **keys = nullptr, **values = nullptr;
  if (PetscOptionsLeftGet(nullptr, &count, &keys, &values)) throw std::runtime_error("PETSc cannot list its options");
  std::string stray;
  for (PetscInt i = 0; i < count; ++i) {
    const std::string key = lower_case(keys[i]);
    const bool passed = std::any_of(options_.begin(), options_.end(), [&](const auto& o) { return o.key == key; });
    if (!passed && !is_petsc_option(key)) stray = key;
  }
  (void)PetscOptionsLeftRestore(nullptr, &count, &keys, &values);
  if (!stray.empty())
    throw InputError(stray, "",
                     "options of PETSc alone in PETSC_OPTIONS, .petscrc and -options_file; this one goes into a case "
                     "file or on the command line");
}

std::vector<std::string> PetscSession::unused() const {
  std::vector<std::string> keys;
  for (const PetscOption& option : options_) {
    bool of_solver = false;  // others may be asked for at the very end
    for (const char* start : {"ts_", "snes_", "ksp_", "pc_", "mat_", "sub_", "mg_", "fieldsplit_", "inner_", "npc_",
                              "gas_start_", "gas_projection_"})
      of_solver = of_solver || option.key.rfind(start, 0) == 0;
    PetscBool used = PETSC_TRUE;
    if (of_solver && PetscOptionsUsed(nullptr, option.key.c_str(), &used) == 0 && !used) keys.push_back(option.key);
  }
  return keys;
}

}  // namespace scree
