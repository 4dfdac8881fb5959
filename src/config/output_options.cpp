#include "scree/config/case_options.hpp"

namespace scree {
namespace {

const char* const field_list = "comma list of datasets";

void declare_files(OptionSet& o, OutputParameters& output) {
  o.group("output");
  o.text("output_dir", output.directory, "a directory", "where the run leaves its files");
  o.boolean("output_overwrite", output.overwrite, "allow a directory that holds a run already");
  o.real("output_interval", output.field_interval, "s", non_negative(),
         "between fields and lines, which are also written at the start and at the end; a step ends at each of these "
         "times, so that intervals shorter than the steps that the accuracy allows cost steps; 0: only first and last");
  o.real("checkpoint_interval", output.checkpoint_interval, "s", non_negative(),
         "simulated time between checkpoints; a step ends at each, and the next sets its solver up anew; 0: only the "
         "last");
  o.real("output_average_from", output.average_from, "s", non_negative(),
         "start of time averages of all fields, which are written beside them as mean_...")
      .unset_by_default("no averages");
  o.boolean("output_wall_stress", output.wall_stress,
            "stresses of the particles on walls and plates: walls/... at the times of the fields, with means over time "
            "from output_average_from on, and the forces on each in monitor.csv");
  o.integer("monitor_every", output.monitor_every, 1,
            "steps between rows of monitor.csv, probes among them; there is one at the times of the fields too");
  o.real("wall_clock_budget", output.wall_clock_budget, "s", non_negative(),
         "wall-clock time after which the run writes a checkpoint and ends; 0: none");
  o.text("restart", output.restart, "a directory of a run", "run to go on from");
}

void declare_quantities(OptionSet& o, const Case& the_case, OutputParameters& output) {
  o.real("output_depth", output.depth, "m", positive(), "plane flow: thickness that masses and rates refer to");
  o.real("output_mirror", output.mirror, "-", positive(), "factor on masses and rates, such as 2 for half a domain");
  o.real("bed_solids_fraction", output.bed_solids_fraction, "-",
         above_zero_below(the_case.kinetic.nu_max, "solids_fraction_max"),
         "solids fraction that marks the bed's surface");
}

void declare_flux(OptionSet& o, const std::string& key, const GridInput& grid, FluxPlane& flux) {
  o.choice(key + "axis", flux.axis, axis_choices(o, grid.dim), "axis normal to the plane").required();
  o.real(key + "position", flux.position, "m", any_number(), "coordinate along that axis, on a grid plane").required();
  std::vector<double> patch;
  const std::size_t count = 2 * static_cast<std::size_t>(grid.dim - 1);
  const OptionEntry& entry = o.reals(key + "patch", patch, {count, false, "lower, upper per remaining axis"}, "m",
                                     any_number(), "part of the plane, on grid planes")
                                 .unset_by_default("the whole plane");
  if (entry.given && grid.dim == 1) throw InputError(key + "patch", entry.value, "no coordinates in one dimension");
  flux.patch = patch_from(patch, flux.axis, grid.dim);
  o.choice(key + "direction", flux.upward, {{"negative", false}, {"positive", true}}, "flow that counts as positive");
}

}  // namespace

void declare_output(OptionSet& o, const GridInput& grid, Case& the_case) {
  declare_files(o, the_case.output);
  declare_quantities(o, the_case, the_case.output);
  the_case.probes =
      o.named<Probe>("probe", [&](OptionSet& set, const std::string& key, const std::string& name, Probe& probe) {
        probe.name = name;
        set.vector(key + "point", probe.point, grid.dim, "m", "point whose fields monitor.csv reports").required();
        set.texts(key + "fields", probe.fields, field_list, "fields to report").unset_by_default("all");
      });
  the_case.lines =
      o.named<Line>("line", [&](OptionSet& set, const std::string& key, const std::string& name, Line& line) {
        line.name = name;
        set.vector(key + "from", line.from, grid.dim, "m", "start of the sampled line").required();
        set.vector(key + "to", line.to, grid.dim, "m", "end of the sampled line").required();
        set.texts(key + "fields", line.fields, field_list, "fields to sample").unset_by_default("all");
      });
  the_case.flux_planes =
      o.named<FluxPlane>("flux", [&](OptionSet& set, const std::string& key, const std::string& name, FluxPlane& flux) {
        flux.name = name;
        declare_flux(set, key, grid, flux);
      });
}

}  // namespace scree
