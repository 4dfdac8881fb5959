#include "scree/output/monitor.hpp"

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "scree/output/atomic_file.hpp"
#include "scree/output/errors.hpp"

namespace scree {

namespace {

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

/// Complete lines only: one that a crash cut short does not count.
std::vector<std::string> complete_lines(const std::string& path) {
  std::ifstream file(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line) && !file.eof();) lines.push_back(line);
  return lines;
}

/// monitor.csv -> monitor_000.csv, or the first number that is free.
std::string free_name(const std::string& path) {
  const std::filesystem::path original(path);
  for (int number = 0;; ++number) {
    char suffix[16];
    std::snprintf(suffix, sizeof suffix, "_%03d", number);
    auto name = original;
    name.replace_filename(original.stem().string() + suffix + original.extension().string());
    if (!std::filesystem::exists(name)) return name.string();
  }
}

}  // namespace

MonitorFile::MonitorFile(MPI_Comm comm, std::string path, std::vector<Column> columns,
                         std::optional<double> restart_time)
    : comm_(comm), path_(std::move(path)), columns_(std::move(columns)) {
  on_first_rank(comm_, [&] {
    std::string text = header();
    if (restart_time && std::filesystem::exists(path_)) text += kept_rows(*restart_time);
    write_text_atomically(path_, text);
    file_.reset(std::fopen(path_.c_str(), "a"));
    if (!file_) throw std::runtime_error("cannot write '" + path_ + "': " + std::strerror(errno));
  });
}

std::string MonitorFile::header() const {
  std::string text;
  for (const Column& column : columns_) text += (text.empty() ? "" : ",") + column.name;
  return text + '\n';
}

/// Rows of the file up to `restart_time`, in the order of our columns.
std::string MonitorFile::kept_rows(double restart_time) const {
  const std::vector<std::string> lines = complete_lines(path_);
  if (lines.empty()) return "";
  const std::vector<std::string> names = split(lines[0]);
  std::vector<size_t> origin;  // of each of our columns; names.size(): none
  for (const Column& column : columns_) {
    size_t place = 0;
    while (place < names.size() && names[place] != column.name) ++place;
    origin.push_back(place);
  }
  if (lines[0] + '\n' != header()) std::filesystem::copy_file(path_, free_name(path_));
  const double last = restart_time + 1e-14 * std::abs(restart_time);  // times are rounded to 15 digits
  std::string text;
  for (size_t i = 1; i < lines.size(); ++i) {
    const std::vector<std::string> cells = split(lines[i]);
    if (cells.size() != names.size() || !(std::strtod(cells[0].c_str(), nullptr) <= last)) continue;
    for (size_t column = 0; column < origin.size(); ++column) {
      text += (column > 0 ? "," : "") + (origin[column] < cells.size() ? cells[origin[column]] : "nan");
    }
    text += '\n';
  }
  return text;
}

void MonitorFile::append(const std::vector<double>& row) {
  on_first_rank(comm_, [&] {
    if (row.size() != columns_.size()) throw std::runtime_error("a row of '" + path_ + "' has a wrong length");
    std::string text;
    for (size_t i = 0; i < row.size(); ++i) {
      char number[40];
      std::snprintf(number, sizeof number, i == 0 ? "%.15g" : ",%.10g", row[i]);
      text += number;
    }
    text += '\n';
    const bool written = std::fwrite(text.data(), 1, text.size(), file_.get()) == text.size();
    if (!written || std::fflush(file_.get()) != 0) {
      throw std::runtime_error("cannot write '" + path_ + "': " + std::strerror(errno));
    }
  });
}

}  // namespace scree
