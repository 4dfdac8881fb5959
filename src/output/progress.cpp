#include "scree/output/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace scree {

namespace {

constexpr double terminal_interval = 0.2;  ///< between two looks of the line on a terminal [s]
constexpr double rate_window = 2;          ///< wall time over which the rate is taken at least [s]
constexpr double told_from = 0.01;         ///< part of the run before which its first, tiny steps would promise days

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
  const long whole = std::lround(std::min(seconds, 1e9));
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
    line += text;
    if (done >= told_from) line += "  left " + duration(std::max(0.0, end_time - time) / rate);
  }
  return line;
}

LogTarget standard_output() {
  const auto write = [](const std::string& text) {
    std::fputs(text.c_str(), stdout);
    std::fflush(stdout);
  };
  return {write, MPI_Wtime, on_terminal()};
}

Progress::Progress(MPI_Comm comm, LogTarget target, double interval)
    : target_(std::move(target)), interval_(interval), shown_(-1) {
  int rank = 0;
  MPI_Comm_rank(comm, &rank);
  active_ = rank == 0;
}

Progress::~Progress() { finish(); }

void Progress::begin(double start_time, double end_time) {
  start_time_ = mark_time_ = time_ = start_time;
  end_time_ = end_time;
  if (active_) mark_seconds_ = target_.seconds();
}

void Progress::update(int step, double time, double dt) {
  if (!active_) return;
  step_ = step;
  time_ = time;
  dt_ = dt;
  pending_ = true;
  const double wait = target_.terminal ? terminal_interval : interval_;
  if (shown_ < 0 || target_.seconds() - shown_ >= wait) show();
}

/// Simulated seconds a wall second. Recent progress counts more than old, since steps change in size and cost: what
/// was before the present window of time counts less as the window grows.
double Progress::rate() {
  const double now = target_.seconds(), window = now - mark_seconds_;
  const double lately = window > 0 ? (time_ - mark_time_) / window : 0;
  const double weight = rate_ > 0 ? 0.3 * std::min(1.0, window / rate_window) : 1;
  const double blended = (1 - weight) * rate_ + weight * lately;
  if (window >= rate_window) {
    rate_ = blended;
    mark_time_ = time_;
    mark_seconds_ = now;
  }
  return blended;
}

void Progress::show() {
  const std::string line = progress_line(step_, time_, dt_, start_time_, end_time_, rate());
  target_.write(target_.terminal ? '\r' + line + "\033[K" : line + '\n');
  line_open_ = target_.terminal;
  pending_ = false;
  shown_ = target_.seconds();
}

void Progress::remark(const char* format, ...) {
  if (!active_) return;
  std::va_list arguments, again;
  va_start(arguments, format);
  va_copy(again, arguments);
  std::string line(static_cast<std::size_t>(std::vsnprintf(nullptr, 0, format, arguments)) + 1, '\0');
  std::vsnprintf(line.data(), line.size(), format, again);
  va_end(again);
  va_end(arguments);
  line.back() = '\n';
  target_.write((line_open_ ? "\r\033[K" : "") + line);
  if (line_open_) show();
}

void Progress::finish() {
  if (!active_) return;
  if (pending_) show();
  if (line_open_) target_.write("\n");
  line_open_ = false;
}

}  // namespace scree
