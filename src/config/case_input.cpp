#include "scree/config/case_input.hpp"

#include <algorithm>

#include "scree/config/case_files.hpp"
#include "scree/config/renamed_options.hpp"

namespace scree {
namespace {

bool starts_with(const std::string& text, const std::string& prefix) {
  return text.compare(0, prefix.size(), prefix) == 0;
}

const std::string define_prefix = "define_";
const std::string petsc_section = "petsc";

}  // namespace

void CaseInput::put(std::string key, const Given& given) {
  if (const std::string* name = present_name(key)) {
    remarks_.push_back(key + (given.place.empty() ? "" : " (" + given.place + ")") + " is now called " + *name +
                       "; the former name will go");
    key = *name;
  }
  entries_[key] = given;
}

void CaseInput::insert(const std::vector<YamlEntry>& entries) {
  for (const YamlEntry& entry : entries) {
    if (entry.path == std::vector<std::string>{petsc_section}) {
      if (entry.text.empty()) continue;
      throw InputError(petsc_section, entry.text, "a section of PETSc's options, 'petsc: {key: value}'", entry.place);
    }
    const bool for_petsc = entry.path.size() > 1 && entry.path[0] == petsc_section;
    if (for_petsc)
      put(flat_key({entry.path.begin() + 1, entry.path.end()}), {entry.text, entry.place, "", true});
    else
      put(flat_key(entry.path), {entry.text, entry.place, entry.path.size() > 2 ? entry.path[1] : "", false});
  }
}

void CaseInput::insert_case(const std::string& file) {
  for (const CaseFile& one : case_files(file)) insert(one.entries);
}

void CaseInput::insert_overrides(const std::string& file) {
  insert(read_case_file(file, "it is a file of overrides").entries);
}

void CaseInput::set(const std::string& key, const std::string& text) {
  const auto before = entries_.find(lower_case(key));
  Given given = before == entries_.end() ? Given() : before->second;  // in the same section, of the same item
  given.text = text;
  given.place.clear();
  put(lower_case(key), given);
}

const std::string* CaseInput::find(const std::string& key) const {
  const auto entry = entries_.find(key);
  return entry == entries_.end() ? nullptr : &entry->second.text;
}

std::string CaseInput::place_of(const std::string& key) const {
  const auto entry = entries_.find(key);
  return entry == entries_.end() ? "" : entry->second.place;
}

const std::string* CaseInput::definition(const std::string& name) const {
  const std::string key = lower_case(name);
  const std::string* defined = find(define_prefix + key);
  if (!defined) return nullptr;
  referred_.insert(key);
  const std::string* flat = find(key);
  return flat ? flat : defined;
}

Definitions CaseInput::definitions() const {
  return [this](const std::string& name) { return definition(name); };
}

bool CaseInput::is_definition(const std::string& key) const {
  return (starts_with(key, define_prefix) && key.size() > define_prefix.size()) || find(define_prefix + key);
}

std::vector<std::string> CaseInput::unused_definitions() const {
  std::vector<std::string> names;
  for (const auto& [key, given] : entries_) {
    if (!starts_with(key, define_prefix)) continue;
    const std::string name = key.substr(define_prefix.size());
    if (!referred_.count(name)) names.push_back(name);
  }
  return names;
}

bool CaseInput::is_for_petsc(const std::string& key) const {
  const auto entry = entries_.find(key);
  const bool in_section = entry != entries_.end() && entry->second.petsc_section;
  return in_section || (!is_definition(key) && is_petsc_option(key));
}

InputError located(const InputError& error, const CaseInput& input) {
  const std::string place = error.place.empty() ? input.place_of(error.key) : error.place;
  return InputError(error.key, error.value, error.expected, place);
}

bool is_petsc_option(const std::string& key) {
  const std::vector<std::string>& prefixes = petsc_prefixes();
  if (key == "v") return true;
  return std::any_of(prefixes.begin(), prefixes.end(), [&](const std::string& p) { return starts_with(key, p); });
}

const std::vector<std::string>& petsc_prefixes() {
  static const std::vector<std::string> prefixes = split_list(
      "ts_, snes_, ksp_, pc_, mat_, vec_, dm_, da_, tao_, is_, ao_, sf_, st_, eps_, sub_, mg_, fieldsplit_, npc_, "
      "inner_, redundant_, telescope_, hypre_, mumps_, superlu_, log_, options_, malloc, info, viewer_, draw_, "
      "display, history, on_error_, stop_for_debugger, start_in_debugger, debugger_, memory_, objects_, fp_trap, "
      "help, version, petsc, nox, x_, saws_, device_, cuda_, hip_, use_gpu_aware_mpi, random_, petscsf_, "
      "gas_projection_, gas_start_, vecscatter_, checkstack, check_pointer_intensity, no_signal_handler, skip_petscrc, "
      "get_total_flops, citations, shared_tmp, not_shared_tmp, tmp, error_output_, mpi_, blas_, hdf5_, python, omp_, "
      "coloring_, matptap_, condensed_");
  return prefixes;
}

}  // namespace scree
