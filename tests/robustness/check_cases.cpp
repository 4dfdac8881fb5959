/// Reads case files as `scree CASE -check` does, thousands in one process. stdin: a path a line; stdout: for each a
/// line "refused <message>" or "accepted", flushed, so that whoever feeds it knows which file was the last.
#include <iostream>
#include <string>

#include "scree/config/read_case.hpp"

namespace {

std::string verdict_on(const std::string& file) {
  try {
    scree::CaseInput input;
    input.insert_case(file);
    scree::read_case(input);
    return "accepted";
  } catch (const std::exception& error) {
    return std::string("refused: ") + error.what();
  }
}

}  // namespace

int main() {
  for (std::string file; std::getline(std::cin, file);) std::cout << verdict_on(file) << std::endl;
  return 0;
}
