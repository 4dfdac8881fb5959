#include "scree/boundary/barriers.hpp"

#include <cmath>
#include <stdexcept>

namespace scree {

namespace {

bool within(const Patch& patch, const Lattice& lattice, int normal_axis, const Index& I) {
  for (int axis = 0; axis < lattice.dim; ++axis) {
    if (axis == normal_axis) continue;
    const Axis& along = lattice.axes[axis];
    const int cell = along.periodic() ? (I[axis] + along.cells()) % along.cells() : I[axis];
    const double x = along.centre(cell);
    if (x < patch.lower[axis] || x > patch.upper[axis]) return false;
  }
  return true;
}

}  // namespace

Barriers::Barriers(const Lattice& lattice, const std::vector<Segment>& segments, const std::vector<Plate>& plates,
                   double time)
    : lattice_(&lattice) {
  for (auto& faces : face_) faces.assign(lattice.ghosted_size(), 0);
  near_.assign(lattice.ghosted_size(), 0);
  mark_sides(segments, time);
  mark_plates(plates, time);
  mark_neighbourhood();
}

void Barriers::mark_sides(const std::vector<Segment>& segments, double time) {
  const Lattice& grid = *lattice_;
  if (segments.size() > 200) throw std::runtime_error("more than 200 boundary segments");
  for (const Segment& segment : segments) conditions_.push_back(segment.condition);
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const Segment& segment = segments[s];
    if (time < segment.condition.from || time >= segment.condition.until) continue;
    some_open_ = some_open_ || segment.condition.kind.open_to_gas();
    const int side = segment.upper ? grid.axes[segment.axis].cells() : 0;
    for_each_node(grid.ghosted_first, grid.ghosted_count, [&](const Index& I) {
      if (I[segment.axis] == side && grid.is_face(segment.axis, I) && within(segment.patch, grid, segment.axis, I))
        face_[segment.axis][grid.ghosted(I)] = static_cast<std::uint8_t>(s + 1);
    });
  }
}

void Barriers::mark_plates(const std::vector<Plate>& plates, double time) {
  const Lattice& grid = *lattice_;
  for (const Plate& given : plates) {
    if (!given.present(time)) continue;
    const Plate plate = given.at(time);
    conditions_.push_back(plate.condition);
    if (conditions_.size() > 255) throw std::runtime_error("more than 255 boundary segments and plates");
    const Axis& axis = grid.axes[plate.axis];
    for_each_node(grid.ghosted_first, grid.ghosted_count, [&](const Index& I) {
      const int face = axis.periodic() ? (I[plate.axis] + axis.cells()) % axis.cells() : I[plate.axis];
      const bool on_plane = std::abs(axis.face(face) - plate.position) < 1e-4 * axis.width(face);
      if (!on_plane || !grid.inside(I) || !grid.inside(I - unit(plate.axis)) ||
          !within(plate.span, grid, plate.axis, I))
        return;
      for (const Patch& opening : plate.openings)
        if (within(opening, grid, plate.axis, I)) return;
      face_[plate.axis][grid.ghosted(I)] = static_cast<std::uint8_t>(conditions_.size());
    });
  }
}

void Barriers::mark_neighbourhood() {
  const Lattice& grid = *lattice_;
  for_each_node(grid.ghosted_first, grid.ghosted_count, [&](const Index& I) {
    for (int axis = 0; axis < grid.dim; ++axis) {
      if (!at(axis, I)) continue;
      for_each_offset(grid, [&](const Index& offset) {
        if (grid.is_ghosted(I + offset)) near_[grid.ghosted(I + offset)] = 1;
      });
    }
  });
}

}  // namespace scree
