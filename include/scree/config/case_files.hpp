/// The files that a case consists of: the one given and those that it is based on.
#pragma once

#include <string>
#include <vector>

#include "scree/config/yaml_text.hpp"

namespace scree {

struct CaseFile {
  std::string name;
  std::vector<YamlEntry> entries;
};

/// One file; `why` says what it is needed for, "" for the case itself.
/// Throws InputError if it cannot be read or is no YAML.
CaseFile read_case_file(const std::string& name, const std::string& why = "");

/// `file` and what it names under a top-level key `based_on`, beside it, and so on; the base of all first.
/// Throws InputError for a file that cannot be read and for files that go round in a circle.
std::vector<CaseFile> case_files(const std::string& file);

}  // namespace scree
