/// Advances a problem by TS, with the step chosen from the local error and from the difficulty of the solve.
#pragma once

#include <petscts.h>

#include <array>
#include <limits>
#include <string>

#include "scree/stepping/newton_limits.hpp"
#include "scree/stepping/newton_tolerance.hpp"

namespace scree {

struct StepControl {
  std::string scheme = "beuler";  ///< beuler, bdf (order 2) or arkimex
  double step_initial = 1e-6, step_min = 1e-12, step_max = std::numeric_limits<double>::infinity();  ///< [s]
  double accuracy = 1e-2;   ///< root mean square of the local error of a step, in units of the scales; it counts nu,
                            ///< v, T and chi, or u in scenes where it alone can change: p_g has no error of its own
  bool adaptive = true;     ///< false: every step is step_initial
  bool extrapolate = true;  ///< first guess of Newton's method on the line of the last states if that is better
};

/// What a step took.
struct StepReport {
  double time = 0, dt = 0;     ///< reached; made [s]
  int newton = 0, krylov = 0;  ///< iterations, failed attempts included
  int rejected_error = 0;      ///< attempts given up since the local error was too large
  int rejected_solver = 0;     ///< attempts given up since Newton or Krylov failed
  std::string reason;          ///< of the last failure of the solver
  long limited = 0;            ///< unknowns held back by NewtonLimits on this rank
  bool failed = false;         ///< no step of at least step_min worked; the state is that before the step
  double error = 0;            ///< local error over accuracy; 0 where there is no estimate yet
  VolumeImbalance imbalance;   ///< over the step, see TimeStepper [m^dim]
};

/// What a first guess is: the state before the step or the line through the last two, or whichever has the smaller
/// residual.
enum class FirstGuess { better, state, line };

/// Everything that a step depends on beside the state, for checkpoints.
struct StepHistory {
  double dt_next = 0;
  std::array<double, 2> dt_past{0, 0};  ///< steps before the current state, newest first; 0: none
  int easy_steps = 0;
  NewtonTolerance newton;
  FirstGuess guess = FirstGuess::better;
};

/// Owns TS, the state and the states before it.
///
/// Once Newton has converged, nu of each cell is renewed from its own continuity equation with the fluxes of the last
/// iterate: an explicit correction of the size of the tolerance that makes the balance of mass exact to rounding for
/// whatever tolerance; u is projected accordingly. `imbalance` measures it: change of volume by the scheme plus
/// outflow, summed over the box.
class TimeStepper {
 public:
  TimeStepper(DiscreteProblem& problem, StepControl control);
  ~TimeStepper();
  TimeStepper(const TimeStepper&) = delete;
  TimeStepper& operator=(const TimeStepper&) = delete;

  /// Collective: makes TS and SNES; takes PETSc's options.
  PetscErrorCode create(double time);
  /// Makes one step that does not pass `limit`.
  PetscErrorCode step(double limit, StepReport* report);
  /// Makes the next step set up its preconditioner from nothing, as after a restart: what follows a checkpoint shall
  /// not depend on whether the run was interrupted there.
  PetscErrorCode forget_preconditioner();
  /// After the options of the preconditioner have changed; those of the Krylov method stay as they were.
  PetscErrorCode make_preconditioner_anew();
  /// After the conditions of the problem have changed: matrix and history are made anew.
  PetscErrorCode restart_after_event();

  Vec state() const { return state_; }
  Vec past(int k) const { return past_[static_cast<std::size_t>(k)]; }  ///< state before, and before that
  double time() const { return time_; }
  StepHistory& history() { return history_; }
  /// To go on from a saved state; `history` is set by the caller.
  PetscErrorCode set_time(double time);
  TS ts() const { return ts_; }

 private:
  static PetscErrorCode converged(SNES, PetscInt, PetscReal, PetscReal, PetscReal, SNESConvergedReason*, void* stepper);
  static PetscErrorCode put_back_jacobian(TS, PetscReal stage_time);
  static PetscErrorCode first_guess(SNES, Vec guess, void* stepper);
  PetscErrorCode extrapolate(SNES snes, double ratio, Vec guess);
  PetscErrorCode make_ts();
  PetscErrorCode correct_continuity(SNES snes);
  PetscErrorCode remainder_is_small(SNES snes, bool* small) const;
  PetscErrorCode local_error(double dt, double* error);
  PetscErrorCode norm_of_evolving(Vec difference, double* norm) const;
  PetscErrorCode attempt(double dt, StepReport* report, bool* done);
  PetscErrorCode renew_preconditioner();
  PetscErrorCode renew_if_aged(SNES snes);
  double newton_residual() const;  ///< per unknown, at which Newton's method stops
  PetscErrorCode set_newton_tolerance();
  void choose_next_step(double dt, const StepReport& report);

  DiscreteProblem& problem_;
  StepControl control_;
  NewtonLimits limits_;
  TS ts_ = nullptr;
  Vec state_ = nullptr, guess_ = nullptr, predicted_ = nullptr;
  std::array<Vec, 2> past_{nullptr, nullptr};
  double time_ = 0;
  StepHistory history_;
  bool finds_slope_ = false;           ///< TSARKIMEX begins with a step of the same length to find its first slope
  VolumeImbalance attempt_imbalance_;  ///< per unit time
  std::string last_failure_;
  PetscBool jacobian_tested_ = PETSC_FALSE;  ///< by PETSc: the one in use is to be that of the state
  PetscInt fresh_krylov_ = -1;  ///< iterations of the first system that the preconditioner solved; -1: none yet
  double last_norm_ = 0;        ///< residual of Newton's iteration before
  NewtonProgress progress_;
};

}  // namespace scree
