#include <set>
#include <sstream>

#include "scree/config/case_options.hpp"

namespace scree {
namespace {

/// PETSc's options that belong to one launch, not to the case.
bool of_this_launch(const std::string& key) {
  return key.compare(0, 8, "options_") == 0 || key == "help" || key == "version";
}

void write_petsc_options(std::ostream& out, const CaseInput& input) {
  bool first = true;
  for (const auto& [key, given] : input.entries()) {
    if (!input.is_for_petsc(key) || of_this_launch(key)) continue;
    if (first) out << "\npetsc:\n";
    first = false;
    out << "  " << key << ":" << (given.text.empty() ? "" : " " + yaml_quoted(given.text)) << "\n";
  }
}

}  // namespace

std::string effective_yaml(const CaseInput& input, const OptionSet& options) {
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
  write_petsc_options(out, input);
  return out.str();
}

std::vector<std::string> unused_remarks(const CaseInput& input, const OptionSet& options) {
  std::vector<std::string> remarks;
  for (const OptionEntry& entry : options.entries()) {
    if (entry.given && !entry.unused_because.empty())
      remarks.push_back(entry.key + " is not used: " + entry.unused_because);
  }
  for (const std::string& name : input.unused_definitions())
    remarks.push_back("define_" + name + " is not used: no value refers to ${" + name + "}");
  return remarks;
}

}  // namespace scree
