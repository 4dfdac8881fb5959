#include "scree/grid/coarse_axis.hpp"

namespace scree {

CoarseAxis::CoarseAxis(const std::vector<double>& faces, double widest) : finer_(faces) {
  const std::size_t cells = faces.size() - 1;
  for (std::size_t i = 0; i < cells;) {
    const bool pair = i + 2 <= cells && faces[i + 2] - faces[i] <= widest;
    first_.push_back(static_cast<int>(i));
    faces_.push_back(faces[i]);
    for (const std::size_t end = i + (pair ? 2 : 1); i < end; ++i)
      within_.push_back(static_cast<int>(first_.size()) - 1);
  }
  within_.push_back(static_cast<int>(first_.size()));
  first_.push_back(static_cast<int>(cells));
  faces_.push_back(faces.back());
}

AxisWeights CoarseAxis::face(int i) const {
  const int below = within_[static_cast<std::size_t>(i)];
  if (first(below) == i) return {1, {below, 0}, {1, 0}};
  const double from = faces_[static_cast<std::size_t>(below)], to = faces_[static_cast<std::size_t>(below) + 1];
  const double upper = (finer_[static_cast<std::size_t>(i)] - from) / (to - from);
  return {2, {below, below + 1}, {1 - upper, upper}};
}

}  // namespace scree
