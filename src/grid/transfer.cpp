#include "scree/grid/transfer.hpp"

#include <algorithm>
#include <cmath>

namespace scree {

namespace {

/// The smaller of two slopes of one sign; 0 where their signs differ.
double minmod(double a, double b) {
  if (!(a * b > 0)) return 0;
  return std::abs(a) < std::abs(b) ? a : b;
}

/// The face at or below x, not the last.
int interval(const std::vector<double>& faces, double x) {
  const auto above = std::upper_bound(faces.begin(), faces.end(), x) - faces.begin();
  return static_cast<int>(std::clamp<std::ptrdiff_t>(above - 1, 0, static_cast<std::ptrdiff_t>(faces.size()) - 2));
}

}  // namespace

std::vector<TransferPart> cell_parts(const std::vector<double>& faces, double lower, double upper) {
  std::vector<TransferPart> parts;
  const int cells = static_cast<int>(faces.size()) - 1;
  for (int i = interval(faces, lower); i < cells && (faces[i] < upper || parts.empty()); ++i) {
    const double from = std::max(lower, faces[i]), to = std::min(upper, faces[i + 1]);
    if (!(to > from)) continue;
    parts.push_back({i, (to - from) / (upper - lower), 0.5 * (from + to) - 0.5 * (faces[i] + faces[i + 1])});
  }
  return parts;
}

std::vector<TransferPart> face_parts(const std::vector<double>& faces, double position) {
  const int i = interval(faces, position);
  const double share = std::clamp((position - faces[i]) / (faces[i + 1] - faces[i]), 0.0, 1.0);
  std::vector<TransferPart> parts;
  if (share < 1) parts.push_back({i, 1 - share, 0});
  if (share > 0) parts.push_back({i + 1, share, 0});
  return parts;
}

Transfer::Parts Transfer::parts(const std::array<double, max_dim>& lower, const std::array<double, max_dim>& upper,
                                int face_axis) const {
  Parts parts;
  for (int axis = 0; axis < max_dim; ++axis) {
    if (axis >= from_.dim)
      parts[axis] = {{}};
    else
      parts[axis] = axis == face_axis ? face_parts(from_.faces[axis], lower[axis])
                                      : cell_parts(from_.faces[axis], lower[axis], upper[axis]);
  }
  return parts;
}

double Transfer::mean(const Parts& parts, int face_axis, const Values& values, const Values& weight) const {
  double sum = 0, weights = 0;
  Index count;
  for (int axis = 0; axis < max_dim; ++axis) count[axis] = static_cast<int>(parts[axis].size());
  for (Index choice; choice[2] < count[2]; ++choice[2])
    for (choice[1] = 0; choice[1] < count[1]; ++choice[1])
      for (choice[0] = 0; choice[0] < count[0]; ++choice[0]) {
        Index cell;
        double share = 1;
        for (int axis = 0; axis < max_dim; ++axis) {
          const TransferPart& part = parts[axis][static_cast<std::size_t>(choice[axis])];
          cell[axis] = part.at;
          share *= part.weight;
        }
        if (weight) share *= weight(cell);
        sum += share * value_in(cell, choice, parts, face_axis, values);
        weights += share;
      }
  return weight ? sum / weights : sum;
}

/// The value in the middle of a part. The slopes of a cell leave the values in it between those about it.
double Transfer::value_in(const Index& cell, const Index& choice, const Parts& parts, int face_axis,
                          const Values& values) const {
  const double own = values(cell);
  double least = own, greatest = own, change = 0, reach = 0;
  for (int axis = 0; axis < from_.dim; ++axis) {
    if (axis == face_axis || !has(axis, cell[axis] - 1) || !has(axis, cell[axis] + 1)) continue;
    const double below = values(cell - unit(axis)), above = values(cell + unit(axis));
    const double slope =
        minmod((own - below) / distance(axis, cell[axis]), (above - own) / distance(axis, cell[axis] + 1));
    change += slope * parts[axis][static_cast<std::size_t>(choice[axis])].offset;
    reach += 0.5 * std::abs(slope) * (from_.faces[axis][cell[axis] + 1] - from_.faces[axis][cell[axis]]);
    least = std::min({least, below, above});
    greatest = std::max({greatest, below, above});
  }
  const double room = std::min(own - least, greatest - own);
  return own + (reach > room ? room / reach : 1) * change;
}

double Transfer::distance(int axis, int cell) const {
  const std::vector<double>& faces = from_.faces[axis];
  const int cells = from_.cells(axis);
  const auto width = [&](int i) {
    i = (i + cells) % cells;
    return faces[i + 1] - faces[i];
  };
  return 0.5 * (width(cell - 1) + width(cell));
}

}  // namespace scree
