/// Reads case files as `scree CASE -check` does, thousands in one process. stdin: a path a line; stdout: for each a
/// line "refused <message>" or "accepted", flushed, so that whoever feeds it knows which file was the last. With
/// -print, "accepted <n>" is followed by the n lines that -check prints: the case as understood.
#include <petscsys.h>

#include <algorithm>
#include <iostream>
#include <string>

#include "scree/app/check_fields.hpp"
#include "scree/app/initial_run.hpp"
#include "scree/config/read_case.hpp"

namespace {

/// The case as understood.
std::string check(const scree::CaseInput& input) {
  try {
    const scree::Case the_case = scree::read_case(input);
    scree::check_fields(the_case, {&scree::make_model, {}});
    scree::check_initial_runs(MPI_COMM_SELF, the_case);
    std::string text;
    for (const std::string& remark : the_case.remarks) text += "# " + remark + '\n';
    return text + the_case.effective_yaml;
  } catch (const scree::InputError& error) {
    throw scree::located(error, input);
  }
}

std::string verdict_on(const std::string& file, bool prints) {
  try {
    scree::CaseInput input;
    input.insert_case(file);
    const std::string text = check(input);
    if (!prints) return "accepted";
    return "accepted " + std::to_string(std::count(text.begin(), text.end(), '\n')) + '\n' +
           text.substr(0, text.find_last_not_of('\n') + 1);
  } catch (const std::exception& error) {
    return std::string("refused: ") + error.what();
  }
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  const bool prints = argc > 1 && std::string(argv[1]) == "-print";
  for (std::string file; std::getline(std::cin, file);) std::cout << verdict_on(file, prints) << std::endl;
  MPI_Finalize();
  return 0;
}
