/// monitor.csv: one row a step.
#pragma once

#include <petscsys.h>

#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace scree {

/// A column of monitor.csv. The header holds the name alone; summary.json has unit (SI) and text.
struct Column {
  std::string name, unit, text;
};

/// A column with its value in a row.
struct Quantity {
  Column column;
  double value = 0;
};

/// Appends rows, each flushed before append() returns. The first column is the time.
class MonitorFile {
 public:
  /// Collective. Starts the file with its header, or with `restart_time` goes on: rows after that time are dropped.
  /// If the columns have changed, old rows are carried over by column name ("nan" where there was none), and the old
  /// file stays as monitor_000.csv, monitor_001.csv, ... Throws std::runtime_error on all ranks.
  MonitorFile(MPI_Comm comm, std::string path, std::vector<Column> columns,
              std::optional<double> restart_time = std::nullopt);

  /// Collective. One value a column, values of rank 0 count; time as %.15g, the others as %.10g.
  /// Throws std::runtime_error on all ranks (disk full, wrong number of values).
  void append(const std::vector<double>& row);

  const std::vector<Column>& columns() const { return columns_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::string header() const;
  std::string kept_rows(double restart_time) const;

  MPI_Comm comm_;
  std::string path_;
  std::vector<Column> columns_;
  std::unique_ptr<std::FILE, Close> file_;  ///< rank 0 only
};

}  // namespace scree
