/// What the user gave: case files and command line as one map of keys, before it is understood.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "scree/config/input_error.hpp"
#include "scree/config/quantity.hpp"
#include "scree/config/yaml_text.hpp"

namespace scree {

/// The text given for a key, and where.
struct Given {
  std::string text;            ///< empty for a key without a value
  std::string place;           ///< "file:line"; empty: the command line
  std::string item;            ///< `wall` for `boundary: {wall: {kind: ...}}`: the name where nesting tells it
  bool petsc_section = false;  ///< under `petsc:`
};

/// Keys are in lower case, without '-', nested ones joined by '_'; what is inserted later wins.
class CaseInput {
 public:
  /// The values of one file; a key under `petsc:` goes by its name there. Renamed keys get their new name.
  void insert(const std::vector<YamlEntry>& entries);
  /// A case file after all those that it is based on. Throws InputError.
  void insert_case(const std::string& file);
  /// A file of overrides, whose own `based_on` counts for nothing. Throws InputError.
  void insert_overrides(const std::string& file);
  /// One option of the command line.
  void set(const std::string& key, const std::string& text);

  /// The text given for `key`, or nullptr. A key given without a value has an empty text.
  const std::string* find(const std::string& key) const;
  /// Where `key` was given; empty if nowhere or on the command line.
  std::string place_of(const std::string& key) const;

  /// The text of `${name}`: the flat key `name` if given, else `define_name`, else nullptr; `name` must stand under
  /// define.
  const std::string* definition(const std::string& name) const;
  Definitions definitions() const;
  /// `define_name`, or `name` where there is such a definition.
  bool is_definition(const std::string& key) const;
  /// Names under `define:` that no value has referred to so far.
  std::vector<std::string> unused_definitions() const;

  /// For PETSc: under `petsc:`, or a key like those of PETSc that is no definition.
  bool is_for_petsc(const std::string& key) const;

  const std::map<std::string, Given>& entries() const { return entries_; }
  /// One line for each key that was given by its former name.
  const std::vector<std::string>& remarks() const { return remarks_; }

 private:
  void put(std::string key, const Given& given);

  std::map<std::string, Given> entries_;
  std::vector<std::string> remarks_;
  mutable std::set<std::string> referred_;
};

/// The error with the place at which its key was given, unless it has one already.
InputError located(const InputError& error, const CaseInput& input);

/// True for a key that begins like those that PETSc or one of its solvers reads.
bool is_petsc_option(const std::string& key);

/// The beginnings of such keys; one that ends in '_' needs more behind it.
const std::vector<std::string>& petsc_prefixes();

}  // namespace scree
