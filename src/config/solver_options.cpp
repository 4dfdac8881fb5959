#include "scree/config/case_options.hpp"

namespace scree {

void declare_solver(OptionSet& o, Case& the_case) {
  o.group("solver");
  the_case.solver.preset = the_case.gas.model == GasModel::none ? SolverPreset::ilu : SolverPreset::fieldsplit;
  the_case.solver.preset_given =
      o.choice("solver", the_case.solver.preset,
               {{"direct", SolverPreset::direct},
                {"ilu", SolverPreset::ilu},
                {"multigrid", SolverPreset::multigrid},
                {"fieldsplit", SolverPreset::fieldsplit},
                {"condensed", SolverPreset::condensed}},
               "named set of PETSc options for the linear systems")
          .unset_by_default(  // one written into the effective case would be given when that is run again
              "ilu, with gas fieldsplit; on the way others where these pay, see cases/GUIDE.md")
          .given;
  o.choice("newton_tangent", the_case.solver.tangent,
           {{"exact", TangentKind::exact}, {"stress_velocity", TangentKind::stress_velocity}},
           "tangent of S/gamma in Newton's method, for the way to the solution alone: the derivative, or the form of "
           "Rudi et al. (2020), which holds where a bed hardly moves")
      .used_if(the_case.friction.model->has_friction, "friction_model is none");
  o.boolean("solver_extrapolate", the_case.solver.extrapolate, "first guess of a step by extrapolation");
  o.boolean("solver_view", the_case.solver.view, "print the PETSc options that the preset stands for");
  o.real("scale_velocity", the_case.scale_velocity, "m/s", non_negative(),
         "scale of velocities; 0: sqrt(g d), or 0.1 m/s without gravity");
  std::string based_on;
  o.text("based_on", based_on, "a case file", "case file, beside this one, that this file overrides")
      .unset_by_default("none");
  o.boolean("check", the_case.check_only, "check the case, print it as understood, and end").unset_by_default("no");
  bool print_options = false;
  o.boolean("print_options", print_options, "print the table of options and end").unset_by_default("no");
  bool schema = false;
  o.boolean("schema", schema, "print the JSON schema of case files, for editors, and end").unset_by_default("no");
}

}  // namespace scree
