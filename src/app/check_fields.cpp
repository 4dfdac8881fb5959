#include "scree/app/check_fields.hpp"

#include "scree/app/problem_setup.hpp"
#include "scree/config/input_error.hpp"
#include "scree/output/errors.hpp"

namespace scree {
namespace {

/// The fields of the model, from a problem of the same kind on a few periodic cells.
std::vector<Field> fields_of(const Case& scene) {
  ProblemSetup setup = problem_setup(scene);
  setup.segments.clear();
  setup.plates.clear();
  for (int axis = 0; axis < setup.box.dim; ++axis) {
    setup.box.faces[axis] = {0, 1, 2, 3, 4};
    setup.box.periodic[axis] = true;
  }
  DiscreteProblem problem(setup);
  check_petsc(problem.create(PETSC_COMM_SELF, 0), "set-up of the fields");
  return problem.model().fields();
}

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

void check_fields(const Case& scene) {
  if (scene.probes.empty() && scene.lines.empty()) return;
  const std::vector<Field> fields = fields_of(scene);
  for (const Probe& probe : scene.probes) check_names(fields, probe.fields, "probe_" + probe.name + "_fields");
  for (const Line& line : scene.lines) check_names(fields, line.fields, "line_" + line.name + "_fields");
}

}  // namespace scree
