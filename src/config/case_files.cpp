#include "scree/config/case_files.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "scree/config/input_error.hpp"

namespace scree {
namespace {

namespace fs = std::filesystem;

/// The entry `based_on` of a file; null if it has none, or one without a value.
const YamlEntry* base_entry(const CaseFile& file) {
  const auto found = std::find_if(file.entries.begin(), file.entries.end(), [](const YamlEntry& entry) {
    return entry.path.size() == 1 && entry.path[0] == "based_on" && !entry.text.empty();
  });
  return found == file.entries.end() ? nullptr : &*found;
}

}  // namespace

CaseFile read_case_file(const std::string& name, const std::string& why) {
  std::error_code error;
  std::ifstream in(name);
  if (fs::is_directory(name, error) || !in)
    throw InputError("case file", name, "a readable YAML file" + (why.empty() ? "" : ", for " + why));
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  return {name, yaml_entries(text, name)};
}

std::vector<CaseFile> case_files(const std::string& file) {
  std::vector<CaseFile> chain;
  std::vector<std::string> seen;
  std::string next = file, why;
  while (!next.empty()) {
    std::error_code error;
    const std::string place = fs::weakly_canonical(next, error).string();
    if (std::find(seen.begin(), seen.end(), place) != seen.end())
      throw InputError("based_on", next, "files that do not refer to each other in a circle");
    seen.push_back(place);
    chain.insert(chain.begin(), read_case_file(next, why));
    const YamlEntry* base = base_entry(chain.front());
    why = base ? "it is the based_on of " + base->place : "";
    next = base ? (fs::path(next).parent_path() / base->text).string() : "";
  }
  return chain;
}

}  // namespace scree
