#include "scree/config/case_options.hpp"

namespace scree {

void declare_solver(OptionSet& o, Case& scene) {
  o.group("solver");
  scene.solver.preset = scene.gas.model == GasModel::none ? SolverPreset::ilu : SolverPreset::fieldsplit;
  scene.solver.preset_given =
      o.choice("solver", scene.solver.preset,
               {{"direct", SolverPreset::direct},
                {"ilu", SolverPreset::ilu},
                {"multigrid", SolverPreset::multigrid},
                {"fieldsplit", SolverPreset::fieldsplit}},
               "named set of PETSc options for the linear systems")
          .default_from(
              "ilu, with gas fieldsplit; on the way more fill or multigrid where that pays, see cases/GUIDE.md")
          .given;
  o.boolean("solver_extrapolate", scene.solver.extrapolate, "first guess of a step by extrapolation");
  o.boolean("solver_view", scene.solver.view, "print the PETSc options that the preset stands for");
  o.real("scale_velocity", scene.scale_velocity, "m/s", non_negative(),
         "scale of velocities; 0: sqrt(g d), or 0.1 m/s without gravity");
  std::string based_on;
  o.text("based_on", based_on, "a case file", "case file, beside this one, that this file overrides")
      .unset_by_default("none");
  o.boolean("check", scene.check_only, "check the case, print it as understood, and end").unset_by_default("no");
  bool print_options = false;
  o.boolean("print_options", print_options, "print the table of options and end").unset_by_default("no");
  bool schema = false;
  o.boolean("schema", schema, "print the JSON schema of case files, for editors, and end").unset_by_default("no");
}

}  // namespace scree
