/// Named probes (columns of monitor.csv) and named lines (CSV files at the output times).
#pragma once

#include <string>
#include <vector>

#include "scree/output/monitor.hpp"
#include "scree/output/point_sampler.hpp"

namespace scree {

/// Fields meant by a list of names; throws std::runtime_error naming `owner` and the known names for an unknown one.
std::vector<Field> select_fields(const std::vector<Field>& fields, const std::vector<std::string>& names,
                                 const std::string& owner);

/// Values at named points, as columns of the monitor.
class ProbeSet {
 public:
  /// Throws std::runtime_error for an unknown field or a point outside the box.
  ProbeSet(const Box& box, DM dm, const std::vector<Field>& fields, const std::vector<Probe>& probes);

  const std::vector<Column>& columns() const { return columns_; }  ///< "<probe>_<field>", e.g. "wall_velocity_y"
  std::vector<double> values(Vec state) const { return sampler_.values(state); }  ///< collective; SI, one a column

 private:
  std::vector<Column> columns_;
  PointSampler sampler_;
};

/// Writes lines/NAME_000012.csv: columns time, x, y, z (as many as the box has axes) and the fields, one row a point.
class LineSampler {
 public:
  /// Throws std::runtime_error for an unknown field or an end outside the box.
  LineSampler(const Box& box, DM dm, const std::vector<Field>& fields, const std::vector<Line>& lines);

  /// Collective. `index` is that of the fields written at the same time. Throws std::runtime_error on all ranks.
  void write(const std::string& directory, int index, double time, Vec state) const;

 private:
  struct SampledLine {
    std::string name;
    std::vector<Point> points;
    std::vector<Field> fields;
    PointSampler sampler;
  };
  MPI_Comm comm_;
  int dim_;
  std::vector<SampledLine> lines_;
};

}  // namespace scree
