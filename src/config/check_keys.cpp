#include <numeric>
#include <set>

#include "scree/config/case_options.hpp"

namespace scree {
namespace {

/// Levenshtein's distance.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t above = row[j];
      row[j] = std::min({row[j - 1] + 1, above + 1, diagonal + (a[i - 1] != b[j - 1])});
      diagonal = above;
    }
  }
  return row[b.size()];
}

/// Keys that a user may have meant by `key`: the known ones, and in the sections of named items every way to read
/// `key` as name and attribute.
std::set<std::string> candidates(const std::string& key, const OptionSet& known) {
  std::set<std::string> keys;
  for (const OptionEntry& entry : known.entries()) keys.insert(entry.key);
  constexpr std::size_t longest = 100;  // the ways to read a key, and the comparison of each, grow with its length
  const std::size_t first = key.find('_');
  if (first == std::string::npos || key.size() > longest) return keys;
  for (const auto& [section, attributes] : known.sections()) {
    if (edit_distance(key.substr(0, first), section) > 2) continue;
    for (std::size_t end = key.find('_', first + 1); end != std::string::npos; end = key.find('_', end + 1)) {
      const std::string name = key.substr(first + 1, end - first - 1);
      for (const std::string& attribute : attributes) keys.insert(section + "_" + name + "_" + attribute);
    }
  }
  return keys;
}

std::string nearest(const std::string& key, const OptionSet& known) {
  const std::set<std::string> keys = candidates(key, known);
  return *std::min_element(keys.begin(), keys.end(), [&](const std::string& a, const std::string& b) {
    return edit_distance(key, a) < edit_distance(key, b);
  });
}

}  // namespace

void check_keys(const CaseInput& input, const OptionSet& known) {
  std::set<std::string> ours;
  for (const OptionEntry& entry : known.entries()) ours.insert(entry.key);
  for (const auto& [key, given] : input.entries()) {
    if (given.petsc_section) {
      if (ours.count(key) || input.is_definition(key))
        throw InputError("petsc: " + key, given.text, "options of PETSc alone under petsc; this one is Scree's",
                         given.place);
    } else if (ours.count(key)) {
      if (const std::string* text = input.find("define_" + key))
        throw InputError("define_" + key, *text, "a name that is not an option itself");
    } else if (!input.is_definition(key) && !is_petsc_option(key)) {
      throw InputError(key, given.text,
                       "a known key (the nearest is '" + nearest(key, known) +
                           "'), a name under 'define', or for PETSc a key under 'petsc'");
    }
  }
}

}  // namespace scree
