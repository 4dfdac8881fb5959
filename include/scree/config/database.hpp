/// PETSc's options database as a map of lower-case keys, with the `define:` section and PETSc's own options told apart.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "scree/config/quantity.hpp"

namespace scree {

/// A copy of PETSc's global options database. Keys are without the leading '-', as PETSc nested them with '_'.
class Database {
 public:
  /// Throws std::runtime_error if PETSc reports an error.
  Database();

  /// The text given for `key`, or nullptr. A key given without a value has an empty text.
  const std::string* find(const std::string& key) const;

  /// The text of `${name}`: the flat key `name` if given, else `define_name`, else nullptr; `name` must stand under
  /// define.
  const std::string* definition(const std::string& name) const;
  Definitions definitions() const;

  /// `define_name`, or `name` where there is such a definition.
  bool is_definition(const std::string& key) const;

  /// Names under `define:` that no value has referred to so far.
  std::vector<std::string> unused_definitions() const;

  /// Tells PETSc that the option was ours, so that -options_left does not report it.
  void mark_used(const std::string& key) const;

  const std::map<std::string, std::string>& entries() const { return entries_; }

 private:
  std::map<std::string, std::string> entries_;
  mutable std::set<std::string> referred_;
};

/// True for a key that PETSc or one of its solvers reads.
bool is_petsc_option(const std::string& key);

}  // namespace scree
