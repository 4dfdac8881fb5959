/// A grid that is given by the sizes of its cells in place of their numbers.
#include <algorithm>
#include <cmath>

#include "scree/config/case_options.hpp"

namespace scree {
namespace {

/// Edges of initial regions get planes where these are at least so many finest cells from all others.
constexpr double room_for_edges = 6;

/// Cells have to differ from the rounding of coordinates.
constexpr double least_of_box = 1e-9;

Range growth_range() { return {1, 2, false, true, "in (1, 2]"}; }

/// The entry of an axis in a list that has one for all or one for each.
double of_axis(const std::vector<double>& list, int axis) {
  return list[list.size() == 1 ? 0 : static_cast<std::size_t>(axis)];
}

void check_count(const std::string& key, const std::vector<double>& list, int dim) {
  if (list.size() == 1 || list.size() == static_cast<std::size_t>(dim)) return;
  throw InputError(key, std::to_string(list.size()) + " entries",
                   dim == 1 ? "1 entry" : "1 entry, or " + std::to_string(dim) + " entries, one per axis");
}

std::string in_metres(double length) { return number_text(length, 9) + " m"; }

std::string on_axis(int axis) { return std::string(" along ") + axis_names[axis]; }

void check_sizes(const CellSizes& sizes, int axis) {
  if (sizes.finest > sizes.coarsest)
    throw InputError("grid_finest", in_metres(sizes.finest),
                     "at most grid_coarsest = " + in_metres(sizes.coarsest) + on_axis(axis));
  const double least = least_of_box * std::max(std::abs(sizes.lower), std::abs(sizes.upper));
  if (sizes.finest < least)
    throw InputError("grid_finest", in_metres(sizes.finest),
                     "at least " + in_metres(least) + on_axis(axis) + ", a part of 1e-9 of the coordinates");
}

/// The given positions, which are to lie in the box.
void add_positions(const GridInput& grid, const Box& ends, int axis, std::vector<double>& fine) {
  const double lower = ends.lower(axis), upper = ends.upper(axis), rounding = least_of_box * (upper - lower);
  for (const double at : grid.sizes.positions[axis]) {
    if (at < lower - rounding || at > upper + rounding)
      throw InputError(
          std::string("grid_fine_") + axis_names[axis], in_metres(at),
          "places in the box, which is from " + in_metres(lower) + " to " + in_metres(upper) + on_axis(axis));
    fine.push_back(std::min(std::max(at, lower), upper));
  }
}

/// The edges that have room, alike whichever comes first.
std::vector<double> edges_with_room(const CellSizes& sizes, std::vector<double> edges) {
  std::sort(edges.begin(), edges.end());
  const double close = same_plane * sizes.finest;
  const auto same = [&](double a, double b) { return b - a <= close; };
  edges.erase(std::unique(edges.begin(), edges.end(), same), edges.end());
  std::vector<double> found;
  for (const double edge : edges) {
    const auto crowds = [&](double other) {
      const double way = std::abs(other - edge);
      return way < room_for_edges * sizes.finest && way > close;
    };
    const auto crowded_by = [&](const std::vector<double>& list) {
      return std::any_of(list.begin(), list.end(), crowds);
    };
    if (!crowded_by(edges) && !crowded_by(sizes.planes) && !crowded_by(sizes.fine)) found.push_back(edge);
  }
  return found;
}

/// A smaller finest size, of two digits, with which there is a grid; 0 if none is found.
double finest_that_fits(CellSizes sizes) {
  for (int k = 0; k < 60; ++k) {
    const double smaller = 0.95 * sizes.finest, digit = std::pow(10, std::floor(std::log10(smaller)) - 1);
    sizes.finest = digit * std::floor(smaller / digit);
    try {
      GradedAxis axis(sizes);
      return sizes.finest;
    } catch (const GradingError&) {
    }
  }
  return 0;
}

/// What is wrong between two planes, as an error of the size.
InputError no_grid(const CellSizes& sizes, const GradingError& error, int axis) {
  const std::string between = " between the planes at " + in_metres(error.lower) + " and " + in_metres(error.upper) +
                              on_axis(axis) + ", which are " + in_metres(error.upper - error.lower) + " apart";
  const double fits = finest_that_fits(sizes);
  return {"grid_finest", in_metres(sizes.finest),
          "a size with which a whole number of cells fits" + between +
              (fits > 0 ? ", such as " + number_text(fits, 2) + " m"
                        : "; no smaller one does with grid_coarsest = " + in_metres(sizes.coarsest) +
                              " and grid_growth = " + number_text(sizes.growth))};
}

GradedAxis graded(const CellSizes& sizes, int axis) {
  try {
    return GradedAxis(sizes);
  } catch (const GradingError& error) {
    throw no_grid(sizes, error, axis);
  }
}

}  // namespace

void declare_sizes(OptionSet& o, int dim, GridInput::Sizes& sizes) {
  const Count one_or_per_axis{0, false, "one, or one per axis"};
  OptionEntry& finest =
      o.reals("grid_finest", sizes.finest, one_or_per_axis, "m", positive(),
              "size of the cells at the places to refine; in place of numbers of cells, which then follow: "
              "faces lie on all edges of sides, plates and flux planes, and no cell is smaller by more than 5 %")
          .unset_by_default("none");
  const bool by_sizes = o.describing() || !sizes.finest.empty();
  const std::string not_given = "grid_finest is not given";
  OptionEntry& coarsest = o.reals("grid_coarsest", sizes.coarsest, one_or_per_axis, "m", positive(),
                                  "greatest size of cells, far from these places")
                              .unset_by_default("required with grid_finest");
  coarsest.needed = !o.describing() && by_sizes;
  finest.needed = coarsest.given;
  o.reals("grid_growth", sizes.growth, one_or_per_axis, "-", growth_range(), "greatest ratio of neighbouring cells")
      .default_from("1.2")
      .used_if(by_sizes, not_given);
  o.texts("grid_fine_at", sizes.fine_at, "openings, none, names of boundaries, plates, flux planes, initial regions",
          "places to refine: their edges, and the wall that they lie in; openings: all open parts of sides, inlets, "
          "openings and free edges of plates")
      .used_if(by_sizes, not_given);
  for (int axis = 0; axis < max_dim; ++axis)
    o.reals(std::string("grid_fine_") + axis_names[axis], sizes.positions[axis], {0, false, ""}, "m", any_number(),
            std::string("further places to refine, by their coordinate along ") + axis_names[axis])
        .unset_by_default("none")
        .used_if(by_sizes, not_given)
        .used_if(o.describing() || axis < dim, "dimension is " + std::to_string(dim));
}

std::vector<GradedAxis> graded_axes(const GridInput& grid, const Box& ends, const Case& scene) {
  check_count("grid_finest", grid.sizes.finest, grid.dim);
  check_count("grid_coarsest", grid.sizes.coarsest, grid.dim);
  check_count("grid_growth", grid.sizes.growth, grid.dim);
  std::array<GridPlaces, max_dim> places = grid_places(grid.sizes.fine_at, ends, scene);
  bool refined = false, uniform = true;
  std::vector<CellSizes> wanted;
  for (int axis = 0; axis < grid.dim; ++axis) {
    GridPlaces& place = places[axis];
    add_positions(grid, ends, axis, place.fine);
    CellSizes sizes;
    sizes.lower = ends.lower(axis);
    sizes.upper = ends.upper(axis);
    sizes.periodic = ends.periodic[axis];
    sizes.finest = of_axis(grid.sizes.finest, axis);
    sizes.coarsest = of_axis(grid.sizes.coarsest, axis);
    sizes.growth = of_axis(grid.sizes.growth, axis);
    check_sizes(sizes, axis);
    sizes.planes = place.planes;
    sizes.fine = place.fine;
    for (const double edge : edges_with_room(sizes, place.edges)) sizes.planes.push_back(edge);
    refined = refined || !place.fine.empty();
    uniform = uniform && sizes.finest == sizes.coarsest;
    wanted.push_back(sizes);
  }
  if (!refined && !uniform)
    throw InputError("grid_fine_at", "",
                     "a place where cells are to be finest: the case has no opening, so the name of a boundary, plate, "
                     "flux plane or initial region, or a coordinate as grid_fine_x");
  std::vector<GradedAxis> axes;
  for (int axis = 0; axis < grid.dim; ++axis) axes.push_back(graded(wanted[axis], axis));
  return axes;
}

std::vector<std::string> grid_summary(const Box& box) {
  std::vector<std::string> lines;
  std::string sizes;
  double cells = 1;
  for (int axis = 0; axis < box.dim; ++axis) {
    const std::vector<double>& faces = box.faces[axis];
    const int count = box.cells(axis);
    double least = faces[1] - faces[0], greatest = least, growth = 1;
    double before = box.periodic[axis] ? faces[count] - faces[count - 1] : least;
    for (int i = 0; i < count; ++i) {
      const double size = faces[i + 1] - faces[i];
      least = std::min(least, size);
      greatest = std::max(greatest, size);
      growth = std::max({growth, size / before, before / size});
      before = size;
    }
    cells *= count;
    sizes += (axis ? " x " : "") + std::to_string(count);
    lines.push_back("grid along " + axis_name(axis) + ": " + std::to_string(count) + " cells of " +
                    number_text(least, 4) + " m to " + number_text(greatest, 4) + " m, neighbours within a factor of " +
                    number_text(growth, 4));
  }
  lines.insert(lines.begin(), "grid: " + sizes + (box.dim > 1 ? " = " + number_text(cells) : "") + " cells");
  return lines;
}

}  // namespace scree
