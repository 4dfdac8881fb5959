/// A run of a case from its start, or from a checkpoint, to its end.
#pragma once

#include <memory>
#include <optional>

#include "scree/app/measures.hpp"
#include "scree/app/phase_clock.hpp"
#include "scree/app/wall_stress.hpp"
#include "scree/output/checkpoint.hpp"
#include "scree/output/field_writer.hpp"
#include "scree/output/output_times.hpp"
#include "scree/output/probes.hpp"
#include "scree/output/progress.hpp"
#include "scree/output/stop_request.hpp"
#include "scree/output/summary.hpp"
#include "scree/output/time_average.hpp"
#include "scree/stepping/flow_control.hpp"
#include "scree/stepping/solver_choice.hpp"
#include "scree/stepping/time_stepper.hpp"

namespace scree {

class Simulation {
 public:
  /// Collective. Sets everything up and writes the initial output. Throws InputError or std::runtime_error of one line,
  /// on all ranks, before anything of an earlier run is touched. What there is to say goes to `log`.
  Simulation(MPI_Comm comm, const Case& the_case, const ModelFactory& models, Progress& log);

  /// Collective. Runs to end_time, to a signal or to the end of the wall-clock budget; leaves a checkpoint and
  /// summary.json in any of these. Throws std::runtime_error if no step works any more, after a last checkpoint.
  void run();

 private:
  /// Sums over the steps of a run, restarts included.
  struct Totals {
    double steps = 0, newton = 0, krylov = 0, rejected_error = 0, rejected_solver = 0, limited = 0;
    double imbalance = 0;       ///< of solids volume [m^dim]
    double gas_imbalance = 0;   ///< of gas volume [m^dim]
    double initial_volume = 0;  ///< [m^dim]
    double dt_max = 0;          ///< [s]

    /// Calls visit(name, member) for each; the names are those in checkpoints.
    template <class Visitor>
    void each_member(Visitor&& visit) {
      visit("steps", steps);
      visit("newton", newton);
      visit("krylov", krylov);
      visit("rejected_error", rejected_error);
      visit("rejected_solver", rejected_solver);
      visit("limited", limited);
      visit("imbalance", imbalance);
      visit("gas_imbalance", gas_imbalance);
      visit("initial_volume", initial_volume);
      visit("dt_max", dt_max);
    }
  };

  static StepControl step_control(const Case& the_case);
  void start_new();
  void restart();
  void open_outputs(std::optional<double> restart_time);
  void find_events();
  double next_window() const;
  double next_limit() const;
  void step(StepReport* report);
  void enter_window();
  SolverPreset preset() const;             ///< that the case gives, or the choice has come to
  int fill() const;                        ///< likewise
  PetscOptionList solver_options() const;  ///< of that preset
  void print_solver() const;               ///< where the case asks for it
  std::string solver_name() const;
  void reconsider_preset(const StepReport& report);
  std::optional<PetscOptionList> stronger_solver();
  bool monitor_due() const;
  void account_effort(const StepReport& report);  ///< of a step that was made, or of one that does not work
  void account(const StepReport& report);
  void make_gas_consistent();
  void hold_gas_flow(const StepReport& report);
  double mass_error() const;
  double gas_volume_error() const;
  void restore_average(const Checkpoint& saved);
  void append_monitor(const StepReport& report);
  void write_fields();
  void write_checkpoint();
  void write_summary(const std::string& end);
  std::vector<Quantity> monitor_row(const StepReport* report) const;

  MPI_Comm comm_;
  Case case_;
  Progress& log_;
  DiscreteProblem problem_;
  PhaseClock clock_;
  std::unique_ptr<TimeStepper> stepper_;
  std::unique_ptr<Measures> measures_;
  std::unique_ptr<ProbeSet> probes_;
  std::unique_ptr<LineSampler> lines_;
  std::unique_ptr<MonitorFile> monitor_;
  std::unique_ptr<FieldWriter> fields_;
  std::unique_ptr<TimeAverage> average_;       ///< if asked for
  std::unique_ptr<WallStress> walls_;          ///< if asked for
  std::unique_ptr<WallAverage> wall_average_;  ///< if both are
  std::unique_ptr<StopRequest> stop_;
  FlowControl flow_;            ///< where the case holds the flow of gas
  std::vector<double> events_;  ///< starts and ends of time windows, and what plates do [s]
  Totals totals_;
  SolverChoice solver_choice_;
  OutputTimes field_times_, checkpoint_times_;
};

}  // namespace scree
