#include "scree/config/case_options.hpp"

namespace scree {

void declare_time(OptionSet& o, TimeParameters& time) {
  o.group("time");
  o.choice("time_scheme", time.scheme,
           {{"beuler", TimeScheme::beuler}, {"bdf", TimeScheme::bdf}, {"arkimex", TimeScheme::arkimex}},
           "backward Euler, BDF of order 2, stiffly accurate implicit Runge-Kutta");
  o.real("end_time", time.end_time, "s", non_negative(), "time at which the run ends");
  o.real("accuracy", time.accuracy, "-", {0, 1, false, false, "in (0, 1)"},
         "relative error that all steps together may leave in the fields; rates and means have less");
  o.boolean(
      "time_step_adaptive", time.adaptive,
      "no: all steps are time_step_initial, but for those cut to end at the time of an output or of a time window");
  o.real("time_step_initial", time.step_initial, "s", positive(), "first step");
  o.real("time_step_min", time.step_min, "s", positive(),
         "the run ends with an error where only steps below this would work, also where fixed steps are cut");
  o.real("time_step_max", time.step_max, "s", positive(), "longest step")
      .unset_by_default("none")
      .used_if(time.adaptive, "time_step_adaptive is no");
}

}  // namespace scree
