#include <set>
#include <sstream>

#include "scree/config/case_options.hpp"

namespace scree {
namespace {

/// PETSc's options that belong to one launch, not to the case.
bool of_this_launch(const std::string& key) {
  return key.compare(0, 8, "options_") == 0 || key == "help" || key == "version";
}

void write_petsc_options(std::ostream& out, const Database& database) {
  bool first = true;
  for (const auto& [key, value] : database.entries()) {
    if (!is_petsc_option(key) || of_this_launch(key) || database.is_definition(key)) continue;
    if (first) out << "\n# PETSc\n";
    first = false;
    out << key << ":" << (value.empty() ? "" : " " + yaml_quoted(value)) << "\n";
  }
}

}  // namespace

std::string effective_yaml(const Database& database, const OptionSet& options) {
  std::ostringstream out;
  out << "# The case as Scree understood it, in SI.\n";
  std::string group;
  for (const OptionEntry& entry : options.entries()) {
    if (entry.key == "based_on" || entry.key == "check") continue;  // its values are here already; of this launch
    if (entry.value.empty() || (!entry.unused_because.empty() && !entry.given)) continue;
    if (entry.group != group) out << "\n# " << entry.group << "\n";
    group = entry.group;
    out << entry.key << ": " << entry.value << (entry.unit == "-" ? "" : "  # " + entry.unit) << "\n";
  }
  write_petsc_options(out, database);
  return out.str();
}

std::vector<std::string> unused_remarks(const Database& database, const OptionSet& options) {
  std::vector<std::string> remarks;
  for (const OptionEntry& entry : options.entries()) {
    if (entry.given && !entry.unused_because.empty())
      remarks.push_back(entry.key + " is not used: " + entry.unused_because);
  }
  for (const std::string& name : database.unused_definitions())
    remarks.push_back("define_" + name + " is not used: no value refers to ${" + name + "}");
  return remarks;
}

}  // namespace scree
