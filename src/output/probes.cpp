#include "scree/output/probes.hpp"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "scree/grid/axis_name.hpp"
#include "scree/output/atomic_file.hpp"
#include "scree/output/errors.hpp"
#include "scree/output/node_block.hpp"

namespace scree {

namespace {

void require_inside(const Box& box, const Point& point, const std::string& owner) {
  for (int axis = 0; axis < box.dim; ++axis) {
    const double slack = 1e-9 * (box.upper(axis) - box.lower(axis));
    if (point[axis] >= box.lower(axis) - slack && point[axis] <= box.upper(axis) + slack) continue;
    char text[128];
    std::snprintf(text, sizeof text, "%s = %g m is outside the box [%g, %g] m", axis_names[axis], point[axis],
                  box.lower(axis), box.upper(axis));
    throw std::runtime_error(owner + ": " + text);
  }
}

std::vector<Sample> samples_at(const std::vector<Point>& points, const std::vector<Field>& fields) {
  std::vector<Sample> samples;
  for (const Point& point : points) {
    for (const Field& field : fields) samples.push_back({point, field});
  }
  return samples;
}

std::vector<Sample> probe_samples(const Box& box, const std::vector<Field>& fields, const std::vector<Probe>& probes,
                                  std::vector<Column>& columns) {
  std::vector<Sample> samples;
  for (const Probe& probe : probes) {
    const std::string owner = "probe " + probe.name;
    require_inside(box, probe.point, owner);
    for (const Field& field : select_fields(fields, probe.fields, owner)) {
      columns.push_back({probe.name + '_' + column_name(field), field.unit, field.text + ", at " + owner});
      samples.push_back({probe.point, field});
    }
  }
  return samples;
}

Point between(const Point& from, const Point& to, double fraction) {
  Point point{};
  for (int axis = 0; axis < max_dim; ++axis) point[axis] = from[axis] + fraction * (to[axis] - from[axis]);
  return point;
}

/// Fractions of the way from..to at which a line is sampled.
std::vector<double> fractions(const Box& box, const Line& line) {
  std::vector<double> result;
  int axis = 0;
  const auto length = [&](int a) { return std::abs(line.to[a] - line.from[a]); };
  for (int other = 1; other < box.dim; ++other) {
    if (length(other) > length(axis)) axis = other;
  }
  const bool ascending = line.to[axis] >= line.from[axis];
  for (int i = 0; length(axis) > 0 && i < box.cells(axis); ++i) {
    const int cell = ascending ? i : box.cells(axis) - 1 - i;
    const double centre = 0.5 * (box.faces[axis][cell] + box.faces[axis][cell + 1]);
    const double fraction = (centre - line.from[axis]) / (line.to[axis] - line.from[axis]);
    if (fraction >= 0 && fraction <= 1) result.push_back(fraction);
  }
  if (result.empty()) result.push_back(0.5);
  return result;
}

}  // namespace

std::vector<Field> select_fields(const std::vector<Field>& fields, const std::vector<std::string>& names,
                                 const std::string& owner) {
  if (names.empty()) return fields;
  std::vector<Field> selected;
  for (const std::string& name : names) {
    const size_t before = selected.size();
    std::string known;
    for (const Field& field : fields) {
      if (name == field.dataset || name == column_name(field)) selected.push_back(field);
      known += (known.empty() ? "" : ", ") + column_name(field);
    }
    if (selected.size() == before) {
      throw std::runtime_error(owner + ": no field '" + name + "' in this model; it has " + known);
    }
  }
  return selected;
}

ProbeSet::ProbeSet(const Box& box, DM dm, const std::vector<Field>& fields, const std::vector<Probe>& probes)
    : sampler_(box, dm, probe_samples(box, fields, probes, columns_)) {}

LineSampler::LineSampler(const Box& box, DM dm, const std::vector<Field>& fields, const std::vector<Line>& lines)
    : comm_(communicator(dm)), dim_(box.dim) {
  for (const Line& line : lines) {
    const std::string owner = "line " + line.name;
    require_inside(box, line.from, owner);
    require_inside(box, line.to, owner);
    std::vector<Point> points;
    for (const double fraction : fractions(box, line)) points.push_back(between(line.from, line.to, fraction));
    const std::vector<Field> selected = select_fields(fields, line.fields, owner);
    lines_.push_back({line.name, points, selected, PointSampler(box, dm, samples_at(points, selected))});
  }
}

void LineSampler::write(const std::string& directory, int index, double time, Vec state) const {
  for (const SampledLine& line : lines_) {
    const std::vector<double> values = line.sampler.values(state);
    std::string text = "time";
    for (int axis = 0; axis < dim_; ++axis) text += ',' + axis_name(axis);
    for (const Field& field : line.fields) text += ',' + column_name(field);
    text += '\n';
    char number[40];
    for (size_t point = 0, value = 0; point < line.points.size(); ++point) {
      std::snprintf(number, sizeof number, "%.15g", time);
      text += number;
      const auto add = [&](double x) {
        std::snprintf(number, sizeof number, ",%.10g", x);
        text += number;
      };
      for (int axis = 0; axis < dim_; ++axis) add(line.points[point][axis]);
      for (size_t field = 0; field < line.fields.size(); ++field) add(values[value++]);
      text += '\n';
    }
    std::snprintf(number, sizeof number, "_%06d.csv", index);
    const std::string path = directory + "/lines/" + line.name + number;
    on_first_rank(comm_, [&] {
      std::filesystem::create_directories(directory + "/lines");
      write_text_atomically(path, text);
    });
  }
}

}  // namespace scree
