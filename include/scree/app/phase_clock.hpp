/// CPU seconds by phase of the solution, from PETSc's log events and the operating system.
#pragma once

#include <petscsys.h>

#include <array>

namespace scree {

/// CPU seconds summed over the ranks: since the start of the program, phases since start_phases(). PETSc knows the
/// phases by the clock on the wall: what other programs took of it is shared out among them.
struct PhaseSeconds {
  double cpu = 0;       ///< user and system
  double residual = 0;  ///< evaluations of the residual
  double jacobian = 0;  ///< evaluations of the Jacobian
  double setup = 0;     ///< preconditioner set-up
  double solve = 0;     ///< Krylov iterations with the application of the preconditioner
};

class PhaseClock {
 public:
  /// Collective. Starts PETSc's logging.
  explicit PhaseClock(MPI_Comm comm);
  /// The phases count from here: what comes before, such as a first projection of the gas, is not part of Newton's
  /// method, whose share is a difference.
  void start_phases() { start_ = now(); }
  PhaseSeconds read() const;            ///< collective
  double wall() const;                  ///< seconds since construction
  double peak_memory_per_rank() const;  ///< collective; greatest resident set of a rank so far [byte]

 private:
  struct Reading {
    double wall = 0, cpu = 0;
    std::array<double, 4> phases{};  ///< by the clock on the wall
  };
  Reading now() const;
  MPI_Comm comm_;
  double started_;
  std::array<PetscLogEvent, 4> events_{};
  Reading start_;
};

}  // namespace scree
