#include "scree/output/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace scree {

namespace {

constexpr double terminal_interval = 0.2;  ///< between two looks of the line on a terminal [s]
constexpr double rate_window = 2;          ///< wall time over which the rate is taken at least [s]

/// Whether standard output ends on a terminal. Open MPI hands each rank a terminal of its own, wherever the output
/// goes; what counts there is that of mpirun, the parent of rank 0 (on another node: its daemon, which has none).
bool on_terminal() {
  if (!isatty(STDOUT_FILENO)) return false;
  if (!std::getenv("OMPI_COMM_WORLD_SIZE")) return true;
  std::error_code error;
  const auto link = std::filesystem::read_symlink("/proc/" + std::to_string(getppid()) + "/fd/1", error);
  const std::string device = link.string();
  return !error && (device.rfind("/dev/pts/", 0) == 0 || device.rfind("/dev/tty", 0) == 0 || device == "/dev/console");
}

std::string duration(double seconds) {
  const long whole = static_cast<long>(std::min(seconds, 1e9) + 0.5);
  char text[48];
  std::snprintf(text, sizeof text, "%ld:%02ld:%02ld", whole / 3600, whole / 60 % 60, whole % 60);
  return text;
}

}  // namespace

std::string progress_line(int step, double time, double dt, double start_time, double end_time, double rate) {
  const double span = end_time - start_time;
  const double done = span > 0 ? std::clamp((time - start_time) / span, 0.0, 1.0) : 1.0;
  char text[160];
  std::snprintf(text, sizeof text, "time %.6g s  dt %.2e s  step %d  %5.1f %%", time, dt, step, 100 * done);
  std::string line = text;
  if (rate > 0) {
    std::snprintf(text, sizeof text, "  rate %.3g s/s", rate);
    line += text + ("  left " + duration(std::max(0.0, end_time - time) / rate));
  }
  return line;
}

Progress::Progress(MPI_Comm comm, double start_time, double end_time, double interval)
    : start_time_(start_time),
      end_time_(end_time),
      interval_(interval),
      started_(Clock::now()),
      shown_(started_),
      rate_time_(start_time),
      rate_clock_(started_),
      time_(start_time) {
  int rank = 0;
  MPI_Comm_rank(comm, &rank);
  active_ = rank == 0;
  terminal_ = active_ && on_terminal();
}

Progress::~Progress() { finish(); }

double Progress::seconds_since(Clock::time_point start) const {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void Progress::update(int step, double time, double dt) {
  if (!active_) return;
  step_ = step;
  time_ = time;
  dt_ = dt;
  pending_ = true;
  const double wait = terminal_ ? terminal_interval : interval_;
  if (!shown_once_ || seconds_since(shown_) >= wait) show();
}

/// Recent progress counts more than old: steps change in size and cost.
void Progress::show() {
  const double window = seconds_since(rate_clock_);
  if (rate_ <= 0 || window >= rate_window) {
    const double lately = window > 0 ? (time_ - rate_time_) / window : 0;
    rate_ = rate_ > 0 ? 0.7 * rate_ + 0.3 * lately : lately;
    if (window >= rate_window) {
      rate_time_ = time_;
      rate_clock_ = Clock::now();
    }
  }
  const std::string line = progress_line(step_, time_, dt_, start_time_, end_time_, rate_);
  std::printf(terminal_ ? "\r%s\033[K" : "%s\n", line.c_str());
  std::fflush(stdout);
  line_open_ = terminal_;
  shown_once_ = true;
  pending_ = false;
  shown_ = Clock::now();
}

void Progress::remark(const std::string& line) {
  if (!active_) return;
  std::printf("%s%s\n", line_open_ ? "\r\033[K" : "", line.c_str());
  std::fflush(stdout);
  line_open_ = false;
}

void Progress::finish() {
  if (!active_) return;
  if (pending_) show();
  if (line_open_) std::printf("\n");
  std::fflush(stdout);
  line_open_ = false;
}

}  // namespace scree
