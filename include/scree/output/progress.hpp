/// The progress line: one that renews itself on a terminal, plain lines at intervals otherwise.
#pragma once

#include <petscsys.h>

#include <chrono>
#include <string>

namespace scree {

/// Tells on standard output (rank 0) how far a run is. Not collective: other ranks do nothing.
class Progress {
 public:
  /// From `start_time` to `end_time` [s]; plain lines at most every `interval` wall seconds.
  Progress(MPI_Comm comm, double start_time, double end_time, double interval = 10);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// After each step: number of the step, the time reached and the step just made [s].
  void update(int step, double time, double dt);
  /// A line for the log that does not tear the progress line.
  void remark(const std::string& line);
  /// Ends the progress line, with the last state in it.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;
  void show();
  double seconds_since(Clock::time_point start) const;

  bool active_, terminal_;
  double start_time_, end_time_, interval_;
  Clock::time_point started_, shown_;
  bool shown_once_ = false, pending_ = false, line_open_ = false;
  double rate_ = 0, rate_time_;  ///< simulated seconds a wall second, lately; time at the last estimate
  Clock::time_point rate_clock_;
  int step_ = 0;
  double time_, dt_ = 0;
};

/// "time 0.25 s  dt 1.2e-04 s  step 123  25.0 %  rate 0.012 s/s  left 0:01:02". Rate <= 0: no time left is given.
std::string progress_line(int step, double time, double dt, double start_time, double end_time, double rate);

}  // namespace scree
