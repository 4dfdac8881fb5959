/// Reads case files as `scree CASE -check` does, thousands in one process. stdin: a path a line; stdout: for each a
/// line "refused <message>" or "accepted", flushed, so that whoever feeds it knows which file was the last.
#include <petscsys.h>

#include <iostream>
#include <string>

#include "scree/app/check_fields.hpp"
#include "scree/app/initial_run.hpp"
#include "scree/config/read_case.hpp"

namespace {

void check(const scree::CaseInput& input) {
  try {
    const scree::Case the_case = scree::read_case(input);
    scree::check_fields(the_case, {&scree::make_model, {}});
    scree::check_initial_runs(MPI_COMM_SELF, the_case);
  } catch (const scree::InputError& error) {
    throw scree::located(error, input);
  }
}

std::string verdict_on(const std::string& file) {
  try {
    scree::CaseInput input;
    input.insert_case(file);
    check(input);
    return "accepted";
  } catch (const std::exception& error) {
    return std::string("refused: ") + error.what();
  }
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  for (std::string file; std::getline(std::cin, file);) std::cout << verdict_on(file) << std::endl;
  MPI_Finalize();
  return 0;
}
