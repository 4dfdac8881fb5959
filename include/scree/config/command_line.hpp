/// The command line: a case file and options.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scree/config/case_input.hpp"

namespace scree {

/// `scree CASE.yaml -key value ...` in its parts.
struct CommandLine {
  std::string case_file;                                     ///< the first argument if it is no option; or empty
  std::vector<std::pair<std::string, std::string>> options;  ///< keys in lower case without '-'; "" for no value

  /// Whether -key or --key was given.
  bool has(const std::string& key) const;
};

/// The arguments behind the program's name. An option begins with '-' and a letter; the word behind it is its value
/// unless it is an option itself. Throws InputError for a word that is neither.
CommandLine read_command_line(const std::vector<std::string>& arguments);

/// The case file with what it is based on, then the files of `-options_file_yaml` in their order, then the options.
/// Without a case file that of the run that `-restart` names. Throws InputError.
CaseInput case_input(const CommandLine& line);

}  // namespace scree
