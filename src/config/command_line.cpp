#include "scree/config/command_line.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>

#include "scree/config/input_error.hpp"

namespace scree {
namespace {

/// The key of a word such as "-key" or "--key"; empty if it is none. Not for "-1", "-0.5" and "-inf", as PETSc has it.
std::string key_of(const std::string& word) {
  const std::size_t first = word.compare(0, 2, "--") == 0 ? 2 : 1;
  if (word.size() <= first || word[0] != '-' || !std::isalpha(static_cast<unsigned char>(word[first]))) return "";
  char* end = nullptr;
  std::strtod(word.c_str() + first - 1, &end);
  const bool number = end != word.c_str() + first - 1 && !std::isalnum(static_cast<unsigned char>(*end)) && *end != '_';
  return number ? "" : word.substr(first);
}

}  // namespace

bool CommandLine::has(const std::string& key) const {
  return std::any_of(options.begin(), options.end(), [&](const auto& option) { return option.first == key; });
}

CommandLine read_command_line(const std::vector<std::string>& arguments) {
  CommandLine line;
  std::size_t at = 0;
  if (!arguments.empty() && arguments[0].compare(0, 1, "-") != 0) line.case_file = arguments[at++];
  while (at < arguments.size()) {
    const std::string key = lower_case(key_of(arguments[at]));
    if (key.empty())
      throw InputError("command line", arguments[at], "options as -key value, and a value with blanks in quotes");
    const bool with_value = at + 1 < arguments.size() && key_of(arguments[at + 1]).empty();
    line.options.push_back({key, with_value ? arguments[at + 1] : ""});
    at += with_value ? 2 : 1;
  }
  return line;
}

CaseInput case_input(const CommandLine& line) {
  std::string file = line.case_file;
  for (const auto& [key, value] : line.options)
    if (file.empty() && key == "restart" && !value.empty()) file = value + "/case.yaml";
  if (file.empty()) throw InputError("command line", "", "a case file: scree CASE.yaml [-key value ...]");

  CaseInput input;
  input.insert_case(file);
  for (const auto& [key, value] : line.options)
    if (key == "options_file_yaml") input.insert_overrides(value);
  // A run that goes on by itself does so where it is: it may have been moved since its case.yaml was written.
  if (line.case_file.empty())
    for (const auto& [key, value] : line.options)
      if (key == "restart") input.set("output_dir", value);
  for (const auto& [key, value] : line.options)
    if (key != "options_file_yaml") input.set(key, value);
  return input;
}

}  // namespace scree
