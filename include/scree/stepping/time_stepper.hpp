/// Advances a problem by TS, with the step chosen from the local error and from the difficulty of the solve.
#pragma once

#include <petscts.h>

#include <array>
#include <functional>
#include <optional>
#include <string>

#include "scree/stepping/scoped_options.hpp"
#include "scree/stepping/stage_solver.hpp"

namespace scree {

/// What a step took.
struct StepReport {
  double time = 0, dt = 0;     ///< reached; made [s]
  int newton = 0, krylov = 0;  ///< iterations, failed attempts included
  int setups = 0;              ///< of preconditioners, likewise
  int rejected_error = 0;      ///< attempts given up since the local error was too large
  int rejected_solver = 0;     ///< attempts given up since Newton or Krylov failed
  std::string reason;          ///< of the last failure of the solver
  long limited = 0;            ///< unknowns held back by NewtonLimits on this rank
  bool failed = false;         ///< no step of at least the least length worked; the state is that before the step
  double error = 0;            ///< local error over accuracy; 0 where there is no estimate yet
  VolumeImbalance
      imbalance;  ///< over the step: change of volume by the scheme plus outflow, summed over the box [m^dim]
};

/// Owns TS, the state and the states before it. How stages are solved is StageSolver's, how long steps are
/// StepController's.
class TimeStepper {
 public:
  /// `prefix` is that of PETSc's options for all solvers in it.
  TimeStepper(const DiscreteProblem& problem, const StepControl& control, std::string prefix = "");
  ~TimeStepper();
  TimeStepper(const TimeStepper&) = delete;
  TimeStepper& operator=(const TimeStepper&) = delete;

  /// Collective: makes TS and SNES with the options `solver`, such as those of a preset; those that PETSc's database
  /// has already, from the user, win.
  PetscErrorCode create(double time, const PetscOptionList& solver = {});
  /// Makes one step that does not pass `limit`.
  PetscErrorCode step(double limit, StepReport* report);
  /// Takes the options of another preset from the next step on, those of the Krylov method included. What `solver` does
  /// not name stays as it was, except that the preconditioner is made from nothing.
  PetscErrorCode change_preconditioner(const PetscOptionList& solver);
  /// `stronger` is asked for other options where a linear system is not solved, before the step is cut.
  void on_linear_failure(std::function<std::optional<PetscOptionList>()> stronger);
  /// Makes the next step set up its preconditioner from nothing, as after a restart: what follows a checkpoint shall
  /// not depend on whether the run was interrupted there.
  PetscErrorCode forget_preconditioner();
  /// After the conditions of the problem have changed: matrix and history are made anew.
  PetscErrorCode restart_after_event();

  Vec state() const { return state_; }
  Vec past(int k) const { return past_[static_cast<std::size_t>(k)]; }  ///< state before, and before that
  double time() const { return time_; }
  StepHistory& history() { return history_; }
  /// To go on from a saved state; `history` is set by the caller.
  PetscErrorCode set_time(double time);
  TS ts() const { return ts_; }
  SNES newton() const { return stages_.newton(); }  ///< that does the work; the one of TS is a shell about it

 private:
  PetscErrorCode make_ts();
  PetscErrorCode set_scheme();
  PetscErrorCode attempt(double dt, StepReport* report, bool* done);
  PetscErrorCode take_step(double dt, double least, int* failures, bool* worked);
  PetscErrorCode give_up(StepReport* report, const std::string& reason);
  PetscErrorCode local_error(double dt, double* error);

  const DiscreteProblem& problem_;
  StepControl control_;
  std::string prefix_;
  Scheme scheme_;
  StepController controller_;
  StepHistory history_;
  ScopedOptions options_;
  StageSolver stages_;
  TS ts_ = nullptr;
  Vec state_ = nullptr, start_ = nullptr, difference_ = nullptr;
  std::array<Vec, 2> past_{nullptr, nullptr};
  double time_ = 0;
  bool finds_slope_ = false;  ///< TSARKIMEX begins with a step of the same length to find its first slope
};

}  // namespace scree
