#include "scree/app/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "scree/app/initial_state.hpp"
#include "scree/app/problem_setup.hpp"
#include "scree/output/atomic_file.hpp"
#include "scree/output/checkpoint.hpp"
#include "scree/output/directory.hpp"
#include "scree/output/errors.hpp"
#include "scree/stepping/consistent_gas.hpp"
#include "scree/stepping/presets.hpp"

namespace scree {

namespace {

PresetTrial::Rule trial_rule(const Case& scene) {
  if (scene.gas.model == GasModel::none) return PresetTrial::without_gas;
  return scene.friction.model == FrictionModel::none ? PresetTrial::with_gas_without_friction : PresetTrial::with_gas;
}

}  // namespace

StepControl Simulation::step_control(const Case& scene) {
  const TimeParameters& t = scene.time;
  return {t.scheme, {t.step_initial, t.step_min, t.step_max, t.adaptive}, t.accuracy, scene.solver.extrapolate};
}

Simulation::Simulation(MPI_Comm comm, const Case& scene)
    : comm_(comm), scene_(scene), problem_(problem_setup(scene)), clock_(comm), trial_(trial_rule(scene)) {
  check_petsc(problem_.create(comm, 0), "set-up of the grid");
  print_solver();
  stepper_ = std::make_unique<TimeStepper>(problem_, step_control(scene_));
  check_petsc(stepper_->create(0, solver_options()), "set-up of the solver");
  measures_ = std::make_unique<Measures>(scene_, problem_);

  std::vector<ProbePoint> probes;
  for (const Probe& p : scene_.probes) probes.push_back({p.name, p.point, p.fields});
  std::vector<SampledLine> lines;
  for (const Line& l : scene_.lines) lines.push_back({l.name, l.from, l.to, l.fields, 0});
  probes_ = std::make_unique<ProbeSet>(scene_.box, problem_.dm(), problem_.model().fields(), probes);
  lines_ = std::make_unique<LineSampler>(scene_.box, problem_.dm(), problem_.model().fields(), lines);

  if (scene_.output.restart.empty())
    start_new();
  else
    restart();
}

SolverPreset Simulation::preset() const {
  return !scene_.solver.preset_given && trial_.multigrid() ? SolverPreset::multigrid : scene_.solver.preset;
}

int Simulation::fill() const { return scene_.solver.preset_given ? 0 : trial_.fill(); }

PetscOptionList Simulation::solver_options() const {
  return preset_options(preset(), problem_.model().unknowns(), problem_.model().gas_pressure(), fill());
}

void Simulation::print_solver() const {
  if (!scene_.solver.view) return;
  PetscPrintf(comm_, "solver preset %s:", name_of(preset()));
  for (const auto& [name, value] : solver_options()) PetscPrintf(comm_, " -%s %s", name.c_str(), value.c_str());
  PetscPrintf(comm_, "\n");
}

/// See PresetTrial.
void Simulation::reconsider_preset(const StepReport& report) {
  if (scene_.solver.preset_given || !trial_.turns(report.newton, report.krylov, report.rejected_solver > 0)) return;
  print_solver();
  check_petsc(stepper_->change_preconditioner(solver_options()), "solver preset");
  PetscPrintf(comm_, "time %g s: %.0f Krylov iterations a linear system; solver %s%s from here on\n", stepper_->time(),
              trial_.iterations(), name_of(preset()), !trial_.multigrid() && fill() > 0 ? " with ILU(1)" : "");
}

void Simulation::start_new() {
  set_initial_state(scene_, problem_, stepper_->state());
  make_gas_consistent();
  check_petsc(problem_.solids_volume(stepper_->state(), &totals_.initial_volume), "solids volume");
  open_outputs(std::nullopt);
  append_monitor({});
  write_fields();
}

/// p_g and u that belong to the rest of the state and to the conditions of this time.
void Simulation::make_gas_consistent() {
  bool done;
  check_petsc(scree::make_gas_consistent(problem_, step_control(scene_), solver_options(), stepper_->time(),
                                         stepper_->state(), &done),
              "consistent gas");
  if (!done) PetscPrintf(comm_, "no consistent gas pressure found at t = %g s: it starts as it is\n", stepper_->time());
}

void Simulation::restart() {
  const Checkpoint saved = read_checkpoint(scene_.output.restart, scene_.box, problem_.dm(), problem_.model().fields());
  if (!saved.remark.empty()) PetscPrintf(comm_, "%s\n", saved.remark.c_str());
  const double time = saved.scalar("time");
  if (time > scene_.time.end_time * (1 + 1e-12))  // at the end: a run that was cut off while it finished
    throw std::runtime_error("restart: " + saved.file + " is at " + std::to_string(time) +
                             " s already; give an end_time beyond it");
  check_petsc(VecCopy(saved.vector("state"), stepper_->state()), "restart");
  check_petsc(VecCopy(saved.vector("past_0"), stepper_->past(0)), "restart");
  check_petsc(VecCopy(saved.vector("past_1"), stepper_->past(1)), "restart");
  const auto restore = [&](const char* name, auto& member) {
    member = static_cast<std::remove_reference_t<decltype(member)>>(saved.scalar(name));
  };
  const auto restore_if_saved = [&](const char* name, auto& member) {
    if (saved.scalars.count(name) > 0) restore(name, member);
  };
  trial_.state().each_member(restore_if_saved);  // checkpoints of earlier versions lack some
  check_petsc(stepper_->change_preconditioner(solver_options()), "restart");
  check_petsc(problem_.update_conditions(time), "restart");
  check_petsc(stepper_->restart_after_event(), "restart");
  stepper_->history().each_member(restore);
  check_petsc(stepper_->set_time(time), "restart");
  totals_.each_member(restore);
  next_fields_ = saved.scalar("next_fields");
  next_checkpoint_ = saved.scalar("next_checkpoint");
  open_outputs(time);
  PetscPrintf(comm_, "going on from %s at t = %g s\n", saved.file.c_str(), time);
}

void Simulation::open_outputs(std::optional<double> restart_time) {
  const std::string& directory = scene_.output.directory;
  prepare_directory(comm_, directory, scene_.output.restart, scene_.output.overwrite);
  monitor_ = std::make_unique<MonitorFile>(comm_, directory + "/monitor.csv", monitor_columns(), restart_time);
  on_first_rank(comm_, [&] { write_text_atomically(directory + "/case.yaml", scene_.effective_yaml); });
  fields_ =
      std::make_unique<FieldWriter>(directory, scene_.box, problem_.dm(), problem_.model().fields(), restart_time);
  stop_ = std::make_unique<StopRequest>(comm_, scene_.output.wall_clock_budget);
}

/// The time that the next step must not pass: the end, or a start or end of a time window.
double Simulation::next_event() const {
  double event = scene_.time.end_time;
  const auto consider = [&](double time) {
    if (time > stepper_->time() * (1 + 1e-12)) event = std::min(event, time);
  };
  for (const Segment& segment : scene_.segments) {
    consider(segment.condition.from);
    consider(segment.condition.until);
  }
  return event;
}

void Simulation::run() {
  Progress progress(comm_, stepper_->time(), scene_.time.end_time);
  std::string end = "end_time";
  while (stepper_->time() < scene_.time.end_time * (1 - 1e-12)) {
    if (stop_->requested()) {
      end = stop_->reason();
      break;
    }
    const double event = next_event();
    StepReport report;
    check_petsc(stepper_->step(event, &report), "time step");
    if (report.failed) {
      write_checkpoint();
      write_summary("no step works");
      char what[200];
      std::snprintf(what, sizeof what,
                    "no step of at least time_step_min = %g s works at t = %g s (%s); the checkpoint "
                    "holds the last good state",
                    scene_.time.step_min, stepper_->time(), report.reason.c_str());
      throw std::runtime_error(what);
    }
    account(report);
    reconsider_preset(report);
    if (event < scene_.time.end_time && stepper_->time() >= event * (1 - 1e-12)) {
      check_petsc(problem_.update_conditions(stepper_->time()), "time window");
      check_petsc(stepper_->restart_after_event(), "time window");
      make_gas_consistent();
    }
    if (static_cast<long>(totals_.steps) % scene_.output.monitor_every == 0) append_monitor(report);
    if (scene_.output.field_interval > 0 && stepper_->time() >= next_fields_ * (1 - 1e-12)) write_fields();
    if (scene_.output.checkpoint_interval > 0 && stepper_->time() >= next_checkpoint_ * (1 - 1e-12)) write_checkpoint();
    progress.update(static_cast<int>(totals_.steps), stepper_->time(), report.dt);
  }
  progress.finish();
  if (!fields_->last_time() || *fields_->last_time() < stepper_->time()) write_fields();
  write_checkpoint();
  write_summary(end);
}

void Simulation::account(const StepReport& report) {
  totals_.steps += 1;
  totals_.newton += report.newton;
  totals_.krylov += report.krylov;
  totals_.rejected_error += report.rejected_error;
  totals_.rejected_solver += report.rejected_solver;
  double limited = static_cast<double>(report.limited);
  MPI_Allreduce(MPI_IN_PLACE, &limited, 1, MPI_DOUBLE, MPI_SUM, comm_);
  totals_.limited += limited;
  totals_.imbalance += report.imbalance.solids;
  totals_.gas_imbalance += report.imbalance.gas;
  totals_.dt_max = std::max(totals_.dt_max, report.dt);
}

std::vector<Column> Simulation::monitor_columns() const {
  std::vector<Column> columns{{"time", "s"},
                              {"dt", "s"},
                              {"newton_iterations", "1"},
                              {"krylov_iterations", "1"},
                              {"rejected_error", "1"},
                              {"rejected_solver", "1"},
                              {"limited", "1"},
                              {"local_error", "1"},
                              {"mass_error", "1"},
                              {"cpu_seconds", "s"},
                              {"cpu_residual", "s"},
                              {"cpu_jacobian", "s"},
                              {"cpu_setup", "s"},
                              {"cpu_solve", "s"}};
  if (scene_.gas.model != GasModel::none) columns.push_back({"gas_volume_error", "1"});
  for (const auto* more : {&measures_->columns(), &probes_->columns()})
    columns.insert(columns.end(), more->begin(), more->end());
  return columns;
}

double Simulation::mass_error() const {
  return totals_.initial_volume > 0 ? totals_.imbalance / totals_.initial_volume : totals_.imbalance;
}

/// Sum of what the gas lost or gained, over the volume it had.
double Simulation::gas_volume_error() const {
  double box = 1;
  for (int axis = 0; axis < scene_.box.dim; ++axis) box *= scene_.box.upper(axis) - scene_.box.lower(axis);
  return totals_.gas_imbalance / (box - totals_.initial_volume);
}

void Simulation::append_monitor(const StepReport& report) {
  const PhaseSeconds cpu = clock_.read();
  std::vector<double> row{stepper_->time(),
                          report.dt,
                          static_cast<double>(report.newton),
                          static_cast<double>(report.krylov),
                          static_cast<double>(report.rejected_error),
                          static_cast<double>(report.rejected_solver),
                          totals_.limited,
                          report.error,
                          mass_error(),
                          cpu.cpu,
                          cpu.residual,
                          cpu.jacobian,
                          cpu.setup,
                          cpu.solve};
  if (scene_.gas.model != GasModel::none) row.push_back(gas_volume_error());
  for (const auto& more : {measures_->values(stepper_->time(), stepper_->state()), probes_->values(stepper_->state())})
    row.insert(row.end(), more.begin(), more.end());
  monitor_->append(row);
}

void Simulation::write_fields() {
  const double interval = scene_.output.field_interval;
  const int index = fields_->write(stepper_->time(), stepper_->state());
  lines_->write(scene_.output.directory, index, stepper_->time(), stepper_->state());
  if (interval > 0) next_fields_ = interval * (std::floor(stepper_->time() / interval * (1 + 1e-12)) + 1);
}

void Simulation::write_checkpoint() {
  const double interval = scene_.output.checkpoint_interval;
  if (interval > 0) next_checkpoint_ = interval * (std::floor(stepper_->time() / interval * (1 + 1e-12)) + 1);
  NamedScalars scalars{
      {"time", stepper_->time()}, {"next_fields", next_fields_}, {"next_checkpoint", next_checkpoint_}};
  const auto save = [&](const char* name, const auto& member) { scalars[name] = static_cast<double>(member); };
  stepper_->history().each_member(save);
  trial_.state().each_member(save);
  totals_.each_member(save);
  scree::write_checkpoint(scene_.output.directory, static_cast<int>(totals_.steps), scene_.box, problem_.dm(),
                          problem_.model().fields(),
                          {{"state", stepper_->state()}, {"past_0", stepper_->past(0)}, {"past_1", stepper_->past(1)}},
                          scalars, {{"case", scene_.effective_yaml}});
  check_petsc(stepper_->forget_preconditioner(), "checkpoint");
}

void Simulation::write_summary(const std::string& end) {
  int ranks, cells = 1;
  MPI_Comm_size(comm_, &ranks);
  for (int axis = 0; axis < scene_.box.dim; ++axis) cells *= scene_.box.cells(axis);
  const PhaseSeconds cpu = clock_.read();

  Summary summary;
  summary["end"] = end;
  summary["time"] = stepper_->time();
  const auto values = measures_->values(stepper_->time(), stepper_->state());
  for (std::size_t k = 0; k < values.size(); ++k) summary["quantities"][measures_->columns()[k].name] = values[k];
  summary["quantities"]["mass_error"] = mass_error();
  if (scene_.gas.model != GasModel::none) summary["quantities"]["gas_volume_error"] = gas_volume_error();
  summary["cells"] = cells;
  summary["unknowns_per_cell"] = problem_.model().unknowns();
  for (const Field& field : problem_.model().fields()) summary["unknowns"].push_back(column_name(field));
  summary["ranks"] = ranks;
  summary["steps"] = totals_.steps;
  summary["newton_iterations"] = totals_.newton;
  summary["krylov_iterations"] = totals_.krylov;
  summary["rejected_error"] = totals_.rejected_error;
  summary["rejected_solver"] = totals_.rejected_solver;
  summary["unknowns_limited"] = totals_.limited;
  summary["dt_max"] = totals_.dt_max;
  summary["wall_seconds"] = clock_.wall();
  summary["cpu_seconds"] = {{"total", cpu.cpu},
                            {"residual", cpu.residual},
                            {"jacobian", cpu.jacobian},
                            {"preconditioner_setup", cpu.setup},
                            {"krylov", cpu.solve}};
  summary["cpu_seconds_per_step"] = totals_.steps > 0 ? cpu.cpu / totals_.steps : 0;
  summary["peak_memory_per_rank_bytes"] = clock_.peak_memory_per_rank();
  char version[256];
  check_petsc(PetscGetVersion(version, sizeof version), "version");
  summary["versions"] = {{"scree", SCREE_VERSION}, {"petsc", version}};
  scree::write_summary(comm_, scene_.output.directory + "/summary.json", summary);
}

}  // namespace scree
