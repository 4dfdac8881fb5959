/// The log of a run on standard output: remarks, and a progress line that renews itself on a terminal, plain lines at
/// intervals otherwise.
#pragma once

#include <petscsys.h>

#include <functional>
#include <string>

namespace scree {

/// Where the log goes.
struct LogTarget {
  std::function<void(const std::string&)> write;  ///< as it is, without a line end of its own
  std::function<double()> seconds;                ///< on the wall
  bool terminal = false;                          ///< a line can be written over
};

/// Standard output.
LogTarget standard_output();

/// Tells on rank 0 what a run does and how far it is. Not collective: other ranks do nothing.
class Progress {
 public:
  /// Plain progress lines come at most every `interval` wall seconds.
  explicit Progress(MPI_Comm comm, LogTarget target = standard_output(), double interval = 10);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// A line for the log, as printf, that does not tear the progress line. Its end is added.
  void remark(const char* format, ...) __attribute__((format(printf, 2, 3)));
  /// The run goes from `start_time` to `end_time` [s]; its clock starts.
  void begin(double start_time, double end_time);
  /// After each step: number of the step, the time reached and the step just made [s].
  void update(int step, double time, double dt);
  /// Ends the progress line, with the last state in it.
  void finish();

 private:
  void show();
  double rate();

  LogTarget target_;
  bool active_;
  double interval_;
  double start_time_ = 0, end_time_ = 0;
  int step_ = 0;
  double time_ = 0, dt_ = 0;
  bool pending_ = false, line_open_ = false;
  double shown_;                                        ///< when the last line was [wall s]; negative: none yet
  double mark_time_ = 0, mark_seconds_ = 0, rate_ = 0;  ///< where the present window of the rate began; rate before it
};

/// "time 0.25 s  dt 1.2e-04 s  step 123  25.0 %  rate 0.012 s/s  left 0:01:02". Rate <= 0: neither rate nor time
/// left is given; nor is the time left in the first hundredth of the run, whose steps still grow.
std::string progress_line(int step, double time, double dt, double start_time, double end_time, double rate);

}  // namespace scree
