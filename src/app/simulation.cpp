#include "scree/app/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "scree/app/derived_cells.hpp"
#include "scree/app/initial_state.hpp"
#include "scree/app/problem_setup.hpp"
#include "scree/balances/layout.hpp"
#include "scree/output/atomic_file.hpp"
#include "scree/output/directory.hpp"
#include "scree/output/errors.hpp"
#include "scree/stepping/consistent_gas.hpp"
#include "scree/stepping/gas_flow.hpp"
#include "scree/stepping/presets.hpp"

namespace scree {

namespace {

double cells_of(const Box& box) {
  double cells = 1;
  for (int axis = 0; axis < box.dim; ++axis) cells *= box.cells(axis);
  return cells;
}

int ranks_of(MPI_Comm comm) {
  int ranks;
  MPI_Comm_size(comm, &ranks);
  return ranks;
}

}  // namespace

StepControl Simulation::step_control(const Case& the_case) {
  const TimeParameters& t = the_case.time;
  return {t.scheme,
          {t.step_initial, t.step_min, t.step_max, t.adaptive},
          t.accuracy,
          the_case.solver.tangent,
          the_case.solver.extrapolate};
}

Simulation::Simulation(MPI_Comm comm, const Case& the_case, const ModelFactory& models, Progress& log)
    : comm_(comm),
      case_(the_case),
      log_(log),
      problem_(problem_setup(the_case, models)),
      clock_(comm),
      flow_(the_case.model.mean_pressure_gradient),
      solver_choice_(solver_candidates(the_case.gas.model != GasModel::none, the_case.box.dim, cells_of(the_case.box),
                                       ranks_of(comm))) {
  check_petsc(problem_.create(comm, 0), "set-up of the grid");
  stepper_ = std::make_unique<TimeStepper>(problem_, step_control(case_));
  check_petsc(stepper_->create(0, solver_options()), "set-up of the solver");
  stepper_->on_linear_failure([this] { return stronger_solver(); });
  find_events();
  measures_ = std::make_unique<Measures>(case_, problem_);

  probes_ = std::make_unique<ProbeSet>(case_.box, problem_.dm(), problem_.model().fields(), case_.probes);
  lines_ = std::make_unique<LineSampler>(case_.box, problem_.dm(), problem_.model().fields(), case_.lines);

  if (std::isfinite(case_.output.average_from))
    average_ = std::make_unique<TimeAverage>(problem_.dm(), case_.output.average_from);
  if (case_.output.wall_stress) {
    walls_ = std::make_unique<WallStress>(case_, problem_);
    if (average_) wall_average_ = std::make_unique<WallAverage>(problem_, case_.output.average_from);
  }

  if (case_.output.restart.empty())
    start_new();
  else
    restart();
}

SolverPreset Simulation::preset() const {
  return case_.solver.preset_given ? case_.solver.preset : solver_choice_.current().preset;
}

int Simulation::fill() const { return case_.solver.preset_given ? 0 : solver_choice_.current().fill; }

std::string Simulation::solver_name() const {
  return name_of(preset()) + (fill() > 0 ? " with ILU(" + std::to_string(fill()) + ")" : "");
}

PetscOptionList Simulation::solver_options() const {
  const ModelParameters& model = problem_.setup().model;
  return preset_options(preset(), problem_.model().fields(),
                        {ranks_of(PETSC_COMM_WORLD), fill(), model.gravity, cells_of(case_.box), model.solids_moving});
}

void Simulation::print_solver() const {
  if (!case_.solver.view) return;
  std::string options;
  for (const auto& [name, value] : solver_options()) options += " -" + name + ' ' + value;
  log_.remark("solver preset %s:%s", name_of(preset()), options.c_str());
}

/// See SolverChoice.
void Simulation::reconsider_preset(const StepReport& report) {
  if (case_.solver.preset_given ||
      !solver_choice_.turns(report.newton, report.krylov, report.setups, report.rejected_solver > 0))
    return;
  print_solver();
  check_petsc(stepper_->change_preconditioner(solver_options()), "solver preset");
  log_.remark("time %g s: %.0f Krylov iterations a linear system; solver %s from here on", stepper_->time(),
              solver_choice_.iterations(), solver_name().c_str());
}

/// For a linear system that the preset at hand does not solve.
std::optional<PetscOptionList> Simulation::stronger_solver() {
  if (case_.solver.preset_given || !solver_choice_.strengthens()) return std::nullopt;
  print_solver();
  log_.remark("time %g s: a linear system is not solved; solver %s from here on", stepper_->time(),
              solver_name().c_str());
  return solver_options();
}

void Simulation::start_new() {
  print_solver();
  for (const std::string& remark : set_initial_state(case_, problem_, stepper_->state()))
    log_.remark("%s", remark.c_str());
  make_gas_consistent();
  check_petsc(problem_.solids_volume(stepper_->state(), &totals_.initial_volume), "solids volume");
  open_outputs(std::nullopt);
  append_monitor({});
  write_fields();
}

/// p_g and u that belong to the rest of the state and to the conditions of this time.
void Simulation::make_gas_consistent() {
  bool done;
  check_petsc(scree::make_gas_consistent(problem_, step_control(case_), solver_options(), stepper_->time(),
                                         stepper_->state(), &done),
              "consistent gas");
  if (!done) log_.remark("no consistent gas pressure found at t = %g s: it starts as it is", stepper_->time());
}

/// The mean pressure gradient of the next step, along periodic axes.
void Simulation::hold_gas_flow(const StepReport& report) {
  if (case_.gas.model == GasModel::none || !case_.gas_flow.held) return;
  for (int axis = 0; axis < case_.box.dim; ++axis) {
    if (!case_.box.periodic[axis]) continue;
    double velocity;
    GasResistance gas;
    check_petsc(mean_gas_velocity(problem_, stepper_->time(), stepper_->state(), axis, &velocity), "flow of gas");
    check_petsc(gas_resistance(problem_, stepper_->state(), axis, &gas), "flow of gas");
    flow_.adjust(axis, velocity, case_.gas_flow.velocity[axis], report.dt, stepper_->history().dt_next, gas);
  }
  problem_.set_mean_pressure_gradient(flow_.gradient());
}

void Simulation::restart() {
  const Checkpoint saved = read_checkpoint(case_.output.restart, case_.box, problem_.dm(), problem_.model().fields());
  if (!saved.remark.empty()) log_.remark("%s", saved.remark.c_str());
  const double time = saved.scalar("time");
  if (time > case_.time.end_time * (1 + 1e-12))  // at the end: a run that was cut off while it finished
    throw std::runtime_error("restart: " + saved.file + " is at " + std::to_string(time) +
                             " s already; give an end_time beyond it");
  check_petsc(VecCopy(saved.vector("state"), stepper_->state()), "restart");
  check_petsc(VecCopy(saved.vector("past_0"), stepper_->past(0)), "restart");
  check_petsc(VecCopy(saved.vector("past_1"), stepper_->past(1)), "restart");
  restore_members(saved, "", solver_choice_.state());
  print_solver();
  check_petsc(stepper_->change_preconditioner(solver_options()), "restart");
  check_petsc(problem_.update_conditions(time), "restart");
  check_petsc(stepper_->restart_after_event(), "restart");
  restore_members(saved, "", stepper_->history());
  check_petsc(stepper_->set_time(time), "restart");
  restore_members(saved, "", totals_);
  if (case_.gas_flow.held) {
    restore_members(saved, "", flow_);
    problem_.set_mean_pressure_gradient(flow_.gradient());
  }
  restore_average(saved);
  open_outputs(time);
  log_.remark("going on from %s at t = %g s", saved.file.c_str(), time);
}

void Simulation::restore_average(const Checkpoint& saved) {
  if (!average_) return;
  const double from = case_.output.average_from;
  const auto before = saved.scalars.find("average_from");
  if (before != saved.scalars.end() && before->second != from) {
    log_.remark("output_average_from = %g s is another than the %g s of %s: averages begin anew", from, before->second,
                saved.file.c_str());
  } else if (saved.has("average")) {
    check_petsc(VecCopy(saved.vector("average"), average_->sum()), "restart");
    restore_members(saved, "", *average_);
    if (wall_average_ && saved.scalars.count("wall_average_seconds") > 0) {
      for (const auto& [name, sum] : wall_average_->sums()) check_petsc(VecCopy(saved.vector(name), sum), "restart");
      restore_members(saved, "", *wall_average_);
    }
  } else if (saved.scalar("time") > from) {
    log_.remark("output_average_from: %s holds no averages, they begin at its time", saved.file.c_str());
  }
}

void Simulation::open_outputs(std::optional<double> restart_time) {
  const std::string& directory = case_.output.directory;
  prepare_directory(comm_, directory, case_.output.restart, case_.output.overwrite);
  std::vector<Column> columns;
  for (const Quantity& quantity : monitor_row(nullptr)) columns.push_back(quantity.column);
  monitor_ = std::make_unique<MonitorFile>(comm_, directory + "/monitor.csv", columns, restart_time);
  on_first_rank(comm_, [&] { write_text_atomically(directory + "/case.yaml", case_.effective_yaml); });
  fields_ = std::make_unique<FieldWriter>(directory, case_.box, problem_.dm(), problem_.model().fields(), restart_time);
  stop_ = std::make_unique<StopRequest>(comm_, case_.output.wall_clock_budget);
  clock_.start_phases();
  field_times_ = OutputTimes(case_.output.field_interval, stepper_->time());
  checkpoint_times_ = OutputTimes(case_.output.checkpoint_interval, stepper_->time());
}

/// When conditions of faces change.
void Simulation::find_events() {
  for (const Segment& segment : case_.segments)
    events_.insert(events_.end(), {segment.condition.from, segment.condition.until});
  for (const Plate& plate : case_.plates) {
    const Axis& axis = problem_.lattice().axes[plate.slide_axis];
    std::vector<double> centres;
    for (int i = 0; i < axis.cells(); ++i) centres.push_back(axis.centre(i));
    const std::vector<double> of_plate = plate.events(centres);
    events_.insert(events_.end(), of_plate.begin(), of_plate.end());
  }
  std::sort(events_.begin(), events_.end());
}

/// The next of them, infinite if there is none.
double Simulation::next_window() const {
  const double now = stepper_->time() * (1 + 1e-12);
  const auto next = std::upper_bound(events_.begin(), events_.end(), now);
  return next == events_.end() ? std::numeric_limits<double>::infinity() : *next;
}

/// The time that the next step must not pass.
double Simulation::next_limit() const {
  const double window = next_window();
  const double next = std::min({case_.time.end_time, window, field_times_.next(), checkpoint_times_.next()});
  return window <= next * (1 + 1e-12) ? window : next;  // what differs by rounding waits for the window
}

/// A step that ends exactly where it must not pass, if it comes so far.
void Simulation::step(StepReport* report) {
  const double limit = next_limit();
  check_petsc(stepper_->step(limit, report), "time step");
  if (report->failed || stepper_->time() < limit * (1 - 1e-12)) return;
  check_petsc(stepper_->set_time(limit), "time step");
}

/// The conditions of the sides change at the time that has been reached.
void Simulation::enter_window() {
  check_petsc(problem_.update_conditions(stepper_->time()), "time window");
  check_petsc(stepper_->restart_after_event(), "time window");
  make_gas_consistent();
}

void Simulation::run() {
  log_.begin(stepper_->time(), case_.time.end_time);
  std::string end = "end_time";
  while (stepper_->time() < case_.time.end_time * (1 - 1e-12)) {
    if (stop_->requested()) {
      end = stop_->reason();
      break;
    }
    const double window = next_window();
    StepReport report;
    step(&report);
    if (report.failed) {
      account_effort(report);
      write_checkpoint();
      write_summary("no step works");
      char what[200];
      std::snprintf(what, sizeof what,
                    "no step of at least time_step_min = %g s works at t = %g s (%s); the checkpoint "
                    "holds the last good state",
                    case_.time.step_min, stepper_->time(), report.reason.c_str());
      throw std::runtime_error(what);
    }
    account(report);
    hold_gas_flow(report);
    reconsider_preset(report);
    if (stepper_->time() >= window && window < case_.time.end_time) enter_window();
    if (monitor_due()) append_monitor(report);
    if (field_times_.due(stepper_->time())) write_fields();
    if (checkpoint_times_.due(stepper_->time())) write_checkpoint();
    log_.update(static_cast<int>(totals_.steps), stepper_->time(), report.dt);
  }
  log_.finish();
  if (!fields_->last_time() || *fields_->last_time() < stepper_->time()) write_fields();
  write_checkpoint();
  write_summary(end);
}

/// At every so many steps, and where fields are written.
bool Simulation::monitor_due() const {
  const double time = stepper_->time();
  return static_cast<long>(totals_.steps) % case_.output.monitor_every == 0 || field_times_.due(time) ||
         time >= case_.time.end_time * (1 - 1e-12);
}

void Simulation::account_effort(const StepReport& report) {
  totals_.newton += report.newton;
  totals_.krylov += report.krylov;
  totals_.rejected_error += report.rejected_error;
  totals_.rejected_solver += report.rejected_solver;
}

void Simulation::account(const StepReport& report) {
  totals_.steps += 1;
  account_effort(report);
  double limited = static_cast<double>(report.limited);
  MPI_Allreduce(MPI_IN_PLACE, &limited, 1, MPI_DOUBLE, MPI_SUM, comm_);
  totals_.limited += limited;
  totals_.imbalance += report.imbalance.solids;
  totals_.gas_imbalance += report.imbalance.gas;
  totals_.dt_max = std::max(totals_.dt_max, report.dt);
  if (average_) average_->add(report.time, report.dt, stepper_->state());
  if (wall_average_) wall_average_->add(report.time, report.dt, walls_->faces(report.time, stepper_->state()));
}

double Simulation::mass_error() const {
  return totals_.initial_volume > 0 ? totals_.imbalance / totals_.initial_volume : totals_.imbalance;
}

/// Sum of what the gas lost or gained, over the volume it had.
double Simulation::gas_volume_error() const {
  double box = 1;
  for (int axis = 0; axis < case_.box.dim; ++axis) box *= case_.box.upper(axis) - case_.box.lower(axis);
  return totals_.gas_imbalance / (box - totals_.initial_volume);
}

/// The columns of monitor.csv with their values; without a report the columns alone.
std::vector<Quantity> Simulation::monitor_row(const StepReport* report) const {
  const StepReport step = report ? *report : StepReport();
  const PhaseSeconds cpu = report ? clock_.read() : PhaseSeconds();
  std::vector<Quantity> row{
      {{"time", "s", "time reached"}, stepper_->time()},
      {{"dt", "s", "length of the step"}, step.dt},
      {{"newton_iterations", "1", "of the step, failed attempts included"}, static_cast<double>(step.newton)},
      {{"krylov_iterations", "1", "of the step, failed attempts included"}, static_cast<double>(step.krylov)},
      {{"rejected_error", "1", "attempts at the step given up for their local error"},
       static_cast<double>(step.rejected_error)},
      {{"rejected_solver", "1", "attempts at the step in which Newton's method or the linear solver failed"},
       static_cast<double>(step.rejected_solver)},
      {{"limited", "1", "unknowns held back from values outside of the model, since the start"}, totals_.limited},
      {{"local_error", "1", "local error of the step over what accuracy allows"}, step.error},
      {{"mass_error", "1", "mass of particles lost or gained since the start, over the mass at the start"},
       mass_error()},
      {{"cpu_seconds", "s", "CPU time of all ranks since the start of the program"}, cpu.cpu},
      {{"cpu_residual", "s", "of it, since the first step: residuals"}, cpu.residual},
      {{"cpu_jacobian", "s", "of it, since the first step: Jacobians"}, cpu.jacobian},
      {{"cpu_setup", "s", "of it, since the first step: set-up of preconditioners"}, cpu.setup},
      {{"cpu_solve", "s", "of it, since the first step: the rest of Newton's method, mainly Krylov iterations"},
       cpu.solve}};
  if (case_.gas.model != GasModel::none)
    row.push_back({{"gas_volume_error", "1", "volume of gas lost or gained since the start, over that at the start"},
                   gas_volume_error()});
  for (const Quantity& quantity : measures_->quantities(stepper_->time(), report ? stepper_->state() : nullptr))
    row.push_back(quantity);
  const std::vector<double> at_probes = report ? probes_->values(stepper_->state()) : std::vector<double>();
  for (std::size_t k = 0; k < probes_->columns().size(); ++k)
    row.push_back({probes_->columns()[k], report ? at_probes[k] : 0.0});
  return row;
}

void Simulation::append_monitor(const StepReport& report) {
  std::vector<double> values;
  for (const Quantity& quantity : monitor_row(&report)) values.push_back(quantity.value);
  monitor_->append(values);
}

void Simulation::write_fields() {
  const int index = fields_->write(stepper_->time(), stepper_->state(), derived_cells(problem_, stepper_->state()),
                                   average_ && !average_->empty() ? average_->mean() : nullptr);
  lines_->write(case_.output.directory, index, stepper_->time(), stepper_->state());
  if (walls_)
    write_wall_stress(case_.output.directory, index, stepper_->time(), stepper_->state(), *walls_,
                      wall_average_ && !wall_average_->empty() ? wall_average_.get() : nullptr, problem_);
  field_times_.pass(stepper_->time());
}

void Simulation::write_checkpoint() {
  NamedScalars scalars{{"time", stepper_->time()}};
  store_members(stepper_->history(), "", scalars);
  store_members(solver_choice_.state(), "", scalars);
  store_members(totals_, "", scalars);
  if (case_.gas_flow.held) store_members(flow_, "", scalars);
  NamedVecs vectors{{"state", stepper_->state()}, {"past_0", stepper_->past(0)}, {"past_1", stepper_->past(1)}};
  if (average_) {
    store_members(*average_, "", scalars);
    scalars["average_from"] = case_.output.average_from;
    vectors.push_back({"average", average_->sum()});
  }
  if (wall_average_) {
    store_members(*wall_average_, "", scalars);
    for (const auto& sum : wall_average_->sums()) vectors.push_back(sum);
  }
  scree::write_checkpoint(case_.output.directory, static_cast<int>(totals_.steps), case_.box, problem_.dm(),
                          problem_.model().fields(), vectors, scalars, {{"case", case_.effective_yaml}});
  checkpoint_times_.pass(stepper_->time());
  check_petsc(stepper_->forget_preconditioner(), "checkpoint");
}

void Simulation::write_summary(const std::string& end) {
  int ranks, cells = 1;
  MPI_Comm_size(comm_, &ranks);
  for (int axis = 0; axis < case_.box.dim; ++axis) cells *= case_.box.cells(axis);
  const PhaseSeconds cpu = clock_.read();

  Summary summary;
  summary["end"] = end;
  summary["time"] = stepper_->time();
  for (const Quantity& quantity : measures_->quantities(stepper_->time(), stepper_->state()))
    summary["quantities"][quantity.column.name] = quantity.value;
  summary["quantities"]["mass_error"] = mass_error();
  if (case_.gas.model != GasModel::none) summary["quantities"]["gas_volume_error"] = gas_volume_error();
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
  for (const auto& [column, value] : monitor_row(nullptr))
    summary["monitor_columns"][column.name] = {{"unit", column.unit}, {"text", column.text}};
  scree::write_summary(comm_, case_.output.directory + "/summary.json", summary);
}

}  // namespace scree
