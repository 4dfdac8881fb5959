/// Solves the stages of time steps: a first guess, Newton's method, and the corrections after it.
#pragma once

#include <petscts.h>

#include <functional>
#include <string>

#include "scree/stepping/corrections.hpp"
#include "scree/stepping/newton_limits.hpp"
#include "scree/stepping/newton_progress.hpp"
#include "scree/stepping/preconditioner_age.hpp"
#include "scree/stepping/step_control.hpp"
#include "scree/stepping/step_history.hpp"

namespace scree {

/// What the solves of a step took, failed ones included.
struct SolveCount {
  int newton = 0, krylov = 0;  ///< iterations
  int setups = 0;              ///< of the preconditioner
  std::string failure;         ///< PETSc's name for the last one; empty: none
};

/// Stands between TS and Newton's method: TS asks for the state of a stage and gets it corrected. Owns the SNES that
/// does the work; the one of TS is a shell about it.
class StageSolver {
 public:
  /// The referenced objects must outlive it.
  StageSolver(const DiscreteProblem& problem, const StepControl& control, StepHistory& history)
      : problem_(problem), control_(control), scheme_(control.scheme), history_(history), limits_(problem) {}
  ~StageSolver();
  StageSolver(const StageSolver&) = delete;
  StageSolver& operator=(const StageSolver&) = delete;

  /// Collective. Makes SNES, with PETSc's options of this prefix, and becomes the solver of `ts`: gives it residual and
  /// Jacobian, and solves its stages. Anew at each call.
  PetscErrorCode create(TS ts, const std::string& prefix);

  /// Before each attempt at a step from `start`, the state before which is `before`: tolerance and preconditioner are
  /// made anew; counts go on.
  PetscErrorCode begin_attempt(Vec start, Vec before);
  /// Before the first attempt.
  void begin_step() {
    count_ = SolveCount();
    limits_.reset();
  }

  /// Asked where a linear system is not solved though the preconditioner is new: sets whether the solver has been made
  /// another, for another try.
  using Strengthen = std::function<PetscErrorCode(bool* stronger)>;
  void on_linear_failure(Strengthen strengthen) { strengthen_ = std::move(strengthen); }

  SNES newton() const { return newton_; }
  const SolveCount& count() const { return count_; }
  long limited() const { return limits_.limited(); }  ///< unknowns held back in this step on this rank
  /// Of the last stage that was solved.
  const VolumeImbalance& imbalance() const { return imbalance_; }

  /// Takes the preconditioner back to before its first set-up, and reads the options of the linear solver again.
  PetscErrorCode forget_preconditioner();
  /// After the options of the linear solver have changed. Options of the Krylov method that are gone stay as they were.
  PetscErrorCode make_preconditioner_anew();

 private:
  // Callbacks of PETSc.
  static PetscErrorCode evaluate(TS, PetscReal time, Vec state, Vec rate, Vec residual, void* solver);
  static PetscErrorCode differentiate(TS, PetscReal time, Vec state, Vec rate, PetscReal shift, Mat A, Mat P,
                                      void* solver);
  static PetscErrorCode solve_stage(SNES shell, Vec state);
  static PetscErrorCode test_convergence(SNES, PetscInt, PetscReal, PetscReal, PetscReal, SNESConvergedReason*,
                                         void* solver);
  static PetscErrorCode before_iteration(SNES, PetscInt iteration);

  PetscErrorCode create_newton();
  PetscErrorCode begin_newton();
  PetscErrorCode run_newton(Vec right_side, Vec state, bool counts, SNESConvergedReason* reason);
  PetscErrorCode strengthen(bool renews, bool* stronger);
  PetscErrorCode guess(Vec state, bool after_failure);
  PetscErrorCode put_on_line(double ratio, Vec state);
  PetscErrorCode residual_norm(Vec state, double* norm);
  PetscErrorCode settle_what_died_down(PetscReal* f_norm) const;
  PetscErrorCode remainder_is_small(bool* small) const;
  PetscErrorCode look_at_age();
  PetscErrorCode renew_preconditioner();
  PetscErrorCode set_tolerance();
  PetscErrorCode is_given(const char* option, PetscBool* given) const;
  double tolerated_residual() const;
  ResidualNorms norms() const;

  const DiscreteProblem& problem_;
  const StepControl& control_;
  Scheme scheme_;
  StepHistory& history_;
  NewtonLimits limits_;
  PreconditionerAge age_;
  std::string prefix_;
  TS ts_ = nullptr;  ///< not owned
  SNES newton_ = nullptr;
  Vec start_ = nullptr, before_ = nullptr;  ///< of the step; not owned
  Vec line_ = nullptr;                      ///< the guess on the line through them
  Vec guess_ = nullptr;                     ///< from which Newton's method has started
  Vec settled_ = nullptr;                   ///< the residual without the rows that need no more
  Stage stage_;                             ///< as TS has asked for it last
  SolveCount count_;
  VolumeImbalance imbalance_;
  double linear_tolerance_ = 0;  ///< of the Krylov method far from the solution
  bool found_slope_ = false;     ///< the last stage was one of TSARKIMEX's first slope
  bool keeps_jacobian_ = false;  ///< in this iteration
  bool renews_ = false;          ///< the preconditioner, in the next iteration
  Strengthen strengthen_;
  PetscBool tests_jacobian_ = PETSC_FALSE;  ///< by PETSc: the one in use is to be that of the state
};

}  // namespace scree
