#include "scree/config/case_options.hpp"

namespace scree {
namespace {

const char* const field_list = "comma list of datasets";

void declare_files(OptionSet& o, OutputParameters& output) {
  o.group("output");
  o.text("output_dir", output.directory, "a directory", "where the run leaves its files");
  o.boolean("output_overwrite", output.overwrite, "allow a directory that holds a run already");
  o.real("output_interval", output.field_interval, "s", non_negative(), "between fields; 0: only first and last");
  o.real(
      "checkpoint_interval", output.checkpoint_interval, "s", non_negative(),
      "simulated time between checkpoints; 0: only the last. After each the solver is made anew, as in a restart: it "
      "costs a set-up, and changes the last digits");
  o.integer("monitor_every", output.monitor_every, 1, "steps between rows of monitor.csv");
  o.real("wall_clock_budget", output.wall_clock_budget, "s", non_negative(),
         "wall-clock time after which the run writes a checkpoint and ends; 0: none");
  o.text("restart", output.restart, "a directory of a run", "run to go on from");
}

void declare_quantities(OptionSet& o, const Case& scene, OutputParameters& output) {
  o.real("output_depth", output.depth, "m", positive(), "plane flow: thickness that masses and rates refer to");
  o.real("output_mirror", output.mirror, "-", positive(), "factor on masses and rates, such as 2 for half a domain");
  o.real("bed_solids_fraction", output.bed_solids_fraction, "-",
         above_zero_below(scene.kinetic.nu_max, "solids_fraction_max"), "solids fraction that marks the bed's surface");
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

void declare_output(OptionSet& o, const GridInput& grid, Case& scene) {
  declare_files(o, scene.output);
  declare_quantities(o, scene, scene.output);
  scene.probes =
      o.named<Probe>("probe", [&](OptionSet& set, const std::string& key, const std::string& name, Probe& probe) {
        probe.name = name;
        set.vector(key + "point", probe.point, grid.dim, "m", "point whose fields monitor.csv reports").required();
        set.texts(key + "fields", probe.fields, field_list, "fields to report").unset_by_default("all");
      });
  scene.lines = o.named<Line>("line", [&](OptionSet& set, const std::string& key, const std::string& name, Line& line) {
    line.name = name;
    set.vector(key + "from", line.from, grid.dim, "m", "start of the sampled line").required();
    set.vector(key + "to", line.to, grid.dim, "m", "end of the sampled line").required();
    set.texts(key + "fields", line.fields, field_list, "fields to sample").unset_by_default("all");
  });
  scene.flux_planes =
      o.named<FluxPlane>("flux", [&](OptionSet& set, const std::string& key, const std::string& name, FluxPlane& flux) {
        flux.name = name;
        declare_flux(set, key, grid, flux);
      });
}

}  // namespace scree
