#include "scree/config/database.hpp"

#include <petscsys.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <stdexcept>

namespace scree {
namespace {

void check(PetscErrorCode code) {
  if (code) throw std::runtime_error("PETSc cannot read its options database (error " + std::to_string(code) + ")");
}

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

/// All keys. PETSc lists "-key value -key value" without quotes, so a word of a value may look like a key.
std::vector<std::string> key_candidates() {
  char* all = nullptr;
  check(PetscOptionsGetAll(nullptr, &all));
  std::istringstream words(all);
  check(PetscFree(all));
  std::vector<std::string> keys;
  for (std::string word; words >> word;) {
    if (word.size() > 1 && word[0] == '-' && std::isalpha(static_cast<unsigned char>(word[1])))
      keys.push_back(word.substr(1));
  }
  return keys;
}

/// Options that nobody has asked for yet; reading them here does not count as asking, so -options_left stays right.
std::map<std::string, std::string> untouched_options() {
  PetscInt count = 0;
  char **keys = nullptr, **values = nullptr;
  check(PetscOptionsLeftGet(nullptr, &count, &keys, &values));
  std::map<std::string, std::string> options;
  for (PetscInt i = 0; i < count; ++i) options[lower_case(keys[i])] = values[i] ? values[i] : "";
  check(PetscOptionsLeftRestore(nullptr, &count, &keys, &values));
  return options;
}

bool starts_with(const std::string& text, const std::string& prefix) {
  return text.compare(0, prefix.size(), prefix) == 0;
}

const std::string define_prefix = "define_";

}  // namespace

Database::Database() : entries_(untouched_options()) {
  for (const std::string& key : key_candidates()) {
    if (entries_.count(lower_case(key))) continue;
    const char* value = nullptr;
    PetscBool found = PETSC_FALSE;
    check(PetscOptionsFindPair(nullptr, nullptr, ("-" + key).c_str(), &value, &found));
    if (found) entries_[lower_case(key)] = value ? value : "";
  }
}

const std::string* Database::find(const std::string& key) const {
  const auto entry = entries_.find(key);
  return entry == entries_.end() ? nullptr : &entry->second;
}

const std::string* Database::definition(const std::string& name) const {
  const std::string key = lower_case(name);
  const std::string* defined = find(define_prefix + key);
  if (!defined) return nullptr;
  referred_.insert(key);
  const std::string* flat = find(key);
  return flat ? flat : defined;
}

Definitions Database::definitions() const {
  return [this](const std::string& name) { return definition(name); };
}

bool Database::is_definition(const std::string& key) const {
  return (starts_with(key, define_prefix) && key.size() > define_prefix.size()) || find(define_prefix + key);
}

std::vector<std::string> Database::unused_definitions() const {
  std::vector<std::string> names;
  for (const auto& [key, value] : entries_) {
    if (!starts_with(key, define_prefix)) continue;
    const std::string name = key.substr(define_prefix.size());
    if (!referred_.count(name)) names.push_back(name);
  }
  return names;
}

void Database::mark_used(const std::string& key) const {
  const char* value = nullptr;
  PetscBool found = PETSC_FALSE;
  check(PetscOptionsFindPair(nullptr, nullptr, ("-" + key).c_str(), &value, &found));
}

bool is_petsc_option(const std::string& key) {
  static const std::vector<std::string> prefixes = split_list(
      "ts_, snes_, ksp_, pc_, mat_, vec_, dm_, da_, tao_, is_, ao_, sf_, st_, eps_, sub_, mg_, fieldsplit_, npc_, "
      "inner_, redundant_, telescope_, hypre_, mumps_, superlu_, log_, options_, malloc, info, viewer_, draw_, "
      "display, history, on_error_, stop_for_debugger, start_in_debugger, debugger_, memory_, objects_, fp_trap, "
      "help, version, petsc, nox, x_, saws_, device_, cuda_, hip_, use_gpu_aware_mpi, random_, petscsf_, "
      "gas_projection_, gas_start_, vecscatter_, checkstack, check_pointer_intensity, no_signal_handler, skip_petscrc, "
      "get_total_flops, citations, shared_tmp, not_shared_tmp, tmp, error_output_, mpi_, blas_, hdf5_, python, omp_, "
      "coloring_, matptap_");
  if (key == "v") return true;
  return std::any_of(prefixes.begin(), prefixes.end(), [&](const std::string& p) { return starts_with(key, p); });
}

}  // namespace scree
