/// Reads case files as `scree CASE -check` does, thousands in one process. stdin: a path a line; stdout: for each a
/// line "refused <message>" or "accepted", flushed, so that whoever feeds it knows which file was the last.
#include <petscsys.h>

#include <iostream>
#include <string>
#include <vector>

#include "scree/config/case_files.hpp"
#include "scree/config/read_case.hpp"

namespace {

std::string verdict_on(const std::string& file) {
  try {
    if (PetscOptionsClear(nullptr)) return "refused: the options cannot be cleared";
    for (const std::string& name : scree::case_files(file)) {
      PetscPushErrorHandler(PetscIgnoreErrorHandler, nullptr);
      const PetscErrorCode code = PetscOptionsInsertFileYAML(PETSC_COMM_WORLD, nullptr, name.c_str(), PETSC_TRUE);
      PetscPopErrorHandler();
      if (code) return "refused: no YAML";
    }
    scree::read_case();
    return "accepted";
  } catch (const std::exception& error) {
    return std::string("refused: ") + error.what();
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (PetscInitialize(&argc, &argv, nullptr, nullptr)) return 1;
  for (std::string file; std::getline(std::cin, file);) std::cout << verdict_on(file) << std::endl;
  if (PetscOptionsClear(nullptr) || PetscFinalize()) return 1;
  return 0;
}
