#include "scree/output/stop_request.hpp"

namespace scree {

namespace {

constexpr std::array<int, 3> signals{SIGTERM, SIGINT, SIGUSR1};
constexpr int budget_code = -1;  ///< where others have the number of a signal
constexpr int no_code = -2;

volatile sig_atomic_t caught_signal = no_code;

extern "C" void note_signal(int number) { caught_signal = number; }

std::string name_of(int code) {
  switch (code) {
    case SIGTERM:
      return "SIGTERM";
    case SIGINT:
      return "SIGINT";
    case SIGUSR1:
      return "SIGUSR1";
    default:
      return "wall-clock budget";
  }
}

}  // namespace

StopRequest::StopRequest(MPI_Comm comm, double wall_clock_budget)
    : comm_(comm), budget_(wall_clock_budget), started_(std::chrono::steady_clock::now()) {
  caught_signal = no_code;
  for (size_t i = 0; i < signals.size(); ++i) {
    struct sigaction action = {};
    action.sa_handler = note_signal;
    sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART;
    if (signals[i] == SIGINT) action.sa_flags |= static_cast<int>(SA_RESETHAND);
    sigaction(signals[i], &action, &previous_[i]);
  }
}

StopRequest::~StopRequest() {
  for (size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &previous_[i], nullptr);
}

bool StopRequest::requested() {
  if (!reason_.empty()) return true;
  int mine = caught_signal, code = no_code;
  const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
  if (mine == no_code && budget_ > 0 && elapsed >= budget_) mine = budget_code;
  MPI_Allreduce(&mine, &code, 1, MPI_INT, MPI_MAX, comm_);
  if (code != no_code) reason_ = name_of(code);
  return code != no_code;
}

}  // namespace scree
