#include "scree/app/check_fields.hpp"

#include "scree/app/problem_setup.hpp"
#include "scree/config/input_error.hpp"

namespace scree {
namespace {

void check_names(const std::vector<Field>& fields, const std::vector<std::string>& names, const std::string& key) {
  for (const std::string& name : names) {
    bool found = false;
    std::string known;
    for (const Field& field : fields) {
      found = found || name == field.dataset || name == column_name(field);
      known += (known.empty() ? "" : ", ") + column_name(field);
    }
    if (!found) throw InputError(key, name, "fields of this model, which are " + known);
  }
}

}  // namespace

void check_fields(const Case& the_case, const ModelFactory& models) {
  const ProblemSetup setup = problem_setup(the_case, models);
  const std::vector<Field> fields = models.fields(setup.box.dim, setup.model, setup.solids, setup.scales);
  for (const Probe& probe : the_case.probes) check_names(fields, probe.fields, "probe_" + probe.name + "_fields");
  for (const Line& line : the_case.lines) check_names(fields, line.fields, "line_" + line.name + "_fields");
}

}  // namespace scree
