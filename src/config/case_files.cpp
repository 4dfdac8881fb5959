#include "scree/config/case_files.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "scree/config/input_error.hpp"

namespace scree {

namespace {

namespace fs = std::filesystem;

/// The file that `file` names under a top-level key `based_on`, as a path; empty if there is none.
std::string base_of(const std::string& file) {
  const std::string key = "based_on:";
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (line.compare(0, key.size(), key) != 0) continue;
    const auto first = line.find_first_not_of(" \t\"'", key.size());
    if (first == std::string::npos || line[first] == '#' || line[first] == '\r') return "";
    const auto last = line.find_first_of(" \t\"'#\r", first);
    return fs::path(file).parent_path() / line.substr(first, last - first);
  }
  return "";
}

}  // namespace

std::vector<std::string> case_files(const std::string& file) {
  std::vector<std::string> chain, seen;
  for (std::string next = file; !next.empty(); next = base_of(next)) {
    std::error_code error;
    if (fs::is_directory(next, error) || !std::ifstream(next))
      throw InputError("case file", next,
                       next == file ? "a readable YAML file" : "a readable YAML file, for it is a based_on");
    const std::string place = fs::weakly_canonical(next, error).string();
    if (std::find(seen.begin(), seen.end(), place) != seen.end())
      throw InputError("based_on", next, "files that do not refer to each other in a circle");
    seen.push_back(place);
    chain.insert(chain.begin(), next);
  }
  return chain;
}

}  // namespace scree
