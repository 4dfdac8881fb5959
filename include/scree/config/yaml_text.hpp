/// A YAML text as a list of values with the keys that lead to them and the place where they stand; by yaml-cpp.
#pragma once

#include <string>
#include <vector>

namespace scree {

/// A value and how it was reached: `boundary: {wall: {kind: open}}` has the path boundary, wall, kind.
struct YamlEntry {
  std::vector<std::string> path;  ///< in lower case; never empty
  std::string text;               ///< a list as a comma list; empty for a key without a value
  std::string place;              ///< "file:line" of the last key of the path
};

/// The values of `text` in their order; `name` is that of its file. A mapping under `<<` gives what is not there.
/// Throws InputError with file, line, column and reason for what is no YAML, for a key used twice in one mapping or
/// twice in one text, and for lists of anything but plain values.
std::vector<YamlEntry> yaml_entries(const std::string& text, const std::string& name);

/// The keys of a path as one key of a case: joined by '_'.
std::string flat_key(const std::vector<std::string>& path);

std::string lower_case(std::string text);

}  // namespace scree
