/// Where the faces of a grid that is given by sizes have to lie, and where its cells are to be finest.
#include <algorithm>
#include <cmath>

#include "scree/config/case_options.hpp"

namespace scree {
namespace {

constexpr double rounding = 1e-9;  ///< of the box: coordinates that differ by less are the same

class Places {
 public:
  Places(const Box& ends, const Case& scene) : ends_(ends), scene_(scene) {
    for (int axis = 0; axis < ends.dim; ++axis) places_[axis].planes = ends.faces[axis];
  }

  /// All edges that have to lie on planes of the grid, whether cells are fine there or not.
  void add_planes() {
    for (const Segment& segment : scene_.segments) add_patch(segment.patch, segment.axis, -1, false);
    for (const Plate& plate : scene_.plates) add_plate(plate, false);
    for (const FluxPlane& flux : scene_.flux_planes) add_flux(flux, false);
    for (const InitialRegion& region : scene_.initial) add_region(region, false);
  }

  /// Whatever particles or gas pass beside a wall: parts of sides, holes and free edges of plates.
  void refine_openings() {
    for (const Segment& segment : scene_.segments) {
      const BoundaryKind& kind = segment.condition.kind;
      if (!kind.lets_solids_out() && !kind.open_to_gas() && !kind.brings_solids() && !kind.brings_gas()) continue;
      if (add_lips(segment)) add(segment.axis, side(segment), true);
    }
    for (const Plate& plate : scene_.plates)
      if (plate.slides() || has_edges(plate)) add_plate(plate, true);
  }

  /// All items of that name; whether there are any.
  bool refine_named(const std::string& name) {
    bool found = false;
    const auto is_it = [&](const std::string& other) { return other == name && (found = true); };
    for (const Segment& segment : scene_.segments) {
      if (!is_it(segment.condition.name)) continue;
      add_patch(segment.patch, segment.axis, -1, true);
      add(segment.axis, side(segment), true);
    }
    for (const Plate& plate : scene_.plates)
      if (is_it(plate.condition.name)) add_plate(plate, true);
    for (const FluxPlane& flux : scene_.flux_planes)
      if (is_it(flux.name)) add_flux(flux, true);
    for (std::size_t i = 1; i < scene_.initial.size(); ++i)  // the first is the empty box, which has no name
      if (is_it(scene_.initial[i].name)) add_region(scene_.initial[i], true);
    return found;
  }

  const std::array<GridPlaces, max_dim>& all() const { return places_; }

 private:
  double side(const Segment& segment) const {
    return segment.upper ? ends_.upper(segment.axis) : ends_.lower(segment.axis);
  }

  bool same(int axis, double a, double b) const {
    return std::abs(a - b) <= rounding * (ends_.upper(axis) - ends_.lower(axis));
  }

  /// Whether from `lower` to `upper` is all of the axis.
  bool is_whole(int axis, double lower, double upper) const {
    const bool from_lower = lower < ends_.lower(axis) || same(axis, lower, ends_.lower(axis));
    return from_lower && (upper > ends_.upper(axis) || same(axis, upper, ends_.upper(axis)));
  }

  /// An edge that ends on a side is none, except where the axis is periodic and the box goes on.
  bool is_edge(int axis, double at) const {
    if (at < ends_.lower(axis) || at > ends_.upper(axis)) return false;
    return ends_.periodic[axis] || (!same(axis, at, ends_.lower(axis)) && !same(axis, at, ends_.upper(axis)));
  }

  void add(int axis, double at, bool fine) { (fine ? places_[axis].fine : places_[axis].planes).push_back(at); }

  /// The edges of [lower, upper] along an axis.
  std::vector<double> edges(int axis, double lower, double upper) const {
    std::vector<double> found;
    if (is_whole(axis, lower, upper)) return found;
    for (const double at : {lower, upper})
      if (is_edge(axis, at)) found.push_back(at);
    return found;
  }

  /// Along all axes but `normal` and `free`.
  void add_patch(const Patch& patch, int normal, int free, bool fine) {
    for (int axis = 0; axis < ends_.dim; ++axis) {
      if (axis == normal || axis == free) continue;
      for (const double at : edges(axis, patch.lower[axis], patch.upper[axis])) add(axis, at, fine);
    }
  }

  /// Edges that slide lie anywhere.
  static int free_axis(const Plate& plate) { return plate.slides() ? plate.slide_axis : -1; }

  void add_plate(const Plate& plate, bool fine) {
    add(plate.axis, plate.position, fine);
    add_patch(plate.span, plate.axis, free_axis(plate), fine);
    for (const Patch& opening : plate.openings) add_patch(opening, plate.axis, free_axis(plate), fine);
  }

  void add_flux(const FluxPlane& flux, bool fine) {
    add(flux.axis, flux.position, fine);
    add_patch(flux.patch, flux.axis, -1, fine);
  }

  void add_region(const InitialRegion& region, bool fine) {
    for (int axis = 0; axis < ends_.dim; ++axis) {
      for (const double at : edges(axis, region.lower[axis], region.upper[axis])) {
        if (fine || !region.run.empty())
          add(axis, at, fine);
        else
          places_[axis].edges.push_back(at);
      }
    }
  }

  bool has_edges(const Patch& patch, int normal) const {
    for (int axis = 0; axis < ends_.dim; ++axis)
      if (axis != normal && !edges(axis, patch.lower[axis], patch.upper[axis]).empty()) return true;
    return false;
  }

  bool has_edges(const Plate& plate) const {
    return has_edges(plate.span, plate.axis) ||
           std::any_of(plate.openings.begin(), plate.openings.end(),
                       [&](const Patch& opening) { return has_edges(opening, plate.axis); });
  }

  /// The edges of a part of a side, except where it ends at a plate, as the room below a floor does. Whether there are.
  bool add_lips(const Segment& segment) {
    bool found = false;
    for (int axis = 0; axis < ends_.dim; ++axis) {
      if (axis == segment.axis) continue;
      for (const double at : edges(axis, segment.patch.lower[axis], segment.patch.upper[axis])) {
        const auto ends_there = [&](const Plate& plate) { return meets(plate, axis, at, segment); };
        if (std::any_of(scene_.plates.begin(), scene_.plates.end(), ends_there)) continue;
        add(axis, at, true);
        found = true;
      }
    }
    return found;
  }

  /// Whether the plate reaches the side of the segment at that coordinate.
  bool meets(const Plate& plate, int axis, double at, const Segment& segment) const {
    if (plate.axis != axis || !same(axis, plate.position, at)) return false;
    const auto reaches = [&](const Patch& patch) {
      const double end = segment.upper ? patch.upper[segment.axis] : patch.lower[segment.axis], wall = side(segment);
      return (segment.upper ? end > wall : end < wall) || same(segment.axis, end, wall);
    };
    return reaches(plate.span) && std::none_of(plate.openings.begin(), plate.openings.end(), reaches);
  }

  const Box& ends_;
  const Case& scene_;
  std::array<GridPlaces, max_dim> places_;
};

std::string names_to_refine(const Case& scene) {
  std::vector<std::string> names;
  for (const Segment& segment : scene.segments) names.push_back(segment.condition.name);
  for (const Plate& plate : scene.plates) names.push_back(plate.condition.name);
  for (const FluxPlane& flux : scene.flux_planes) names.push_back(flux.name);
  for (std::size_t i = 1; i < scene.initial.size(); ++i) names.push_back(scene.initial[i].name);
  std::string text;
  for (const std::string& name : names) text += ", " + name;
  return text;
}

}  // namespace

std::array<GridPlaces, max_dim> grid_places(const std::vector<std::string>& fine_at, const Box& ends,
                                            const Case& scene) {
  Places places(ends, scene);
  places.add_planes();
  for (const std::string& name : fine_at) {
    if (name == "openings")
      places.refine_openings();
    else if (!places.refine_named(name) && !(name == "none" && fine_at.size() == 1))
      throw InputError("grid_fine_at", name,
                       "openings, none, or names of boundaries, plates, flux planes and initial regions of the case: "
                       "openings" +
                           names_to_refine(scene));
  }
  return places.all();
}

}  // namespace scree
