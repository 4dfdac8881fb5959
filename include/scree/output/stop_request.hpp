/// Clean ends: SIGTERM, SIGINT, SIGUSR1, or the wall-clock budget.
#pragma once

#include <petscsys.h>
#include <signal.h>

#include <array>
#include <chrono>
#include <string>

namespace scree {

/// Turns signals into a question the time loop asks. While it lives, SIGTERM, SIGINT and SIGUSR1 do not end the
/// process (a second SIGINT does). One at a time; make it after PetscInitialize, which sets handlers of its own.
///
/// Open MPI's mpirun, given SIGTERM, kills the ranks one second after passing it on (odls_base_sigkill_timeout): enough
/// for short steps only. SIGUSR1 to mpirun is passed on without that limit, and SIGTERM to any one rank will do too.
class StopRequest {
 public:
  /// `wall_clock_budget` in seconds since construction; 0: none.
  explicit StopRequest(MPI_Comm comm, double wall_clock_budget = 0);
  ~StopRequest();
  StopRequest(const StopRequest&) = delete;
  StopRequest& operator=(const StopRequest&) = delete;

  /// Collective. True on all ranks once any rank got a signal or used up the budget; stays true.
  bool requested();
  /// "SIGTERM", "SIGINT", "SIGUSR1", "wall-clock budget"; empty while nothing was requested. Same on all ranks.
  const std::string& reason() const { return reason_; }

 private:
  MPI_Comm comm_;
  double budget_;
  std::chrono::steady_clock::time_point started_;
  std::array<struct sigaction, 3> previous_;
  std::string reason_;
};

}  // namespace scree
