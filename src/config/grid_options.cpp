#include <petscsys.h>

#include <cmath>
#include <numeric>

#include "scree/config/case_options.hpp"

namespace scree {
namespace {

const char* const given_by_sizes = "the grid is given by grid_finest";

void declare_blocks(OptionSet& o, int axis, int dim, bool by_sizes, GridInput::Blocks& blocks) {
  const std::string key = std::string("grid_") + axis_names[axis] + "_";
  const std::string no_axis = "dimension is " + std::to_string(dim);
  const bool used = o.describing() || axis < dim;
  const std::string name = axis_names[axis];
  o.reals(key + "edges", blocks.edges, {0, false, "ascending"}, "m", any_number(),
          "edges of the blocks of cells along " + name +
              ", in place of extent, origin and grid_cells; with grid_finest, the box and planes of the grid in it")
      .unset_by_default("none")
      .used_if(used, no_axis);
  const bool has_blocks = o.describing() || (!blocks.edges.empty() && !by_sizes);
  const std::string no_blocks = by_sizes ? given_by_sizes : key + "edges is not given";
  o.integers(key + "cells", blocks.cells, {0, false, "one per block"}, 1, "cells of each block along " + name)
      .unset_by_default("none")
      .used_if(has_blocks, no_blocks);
  o.reals(key + "ratio", blocks.ratios, {0, false, "one per block"}, "-", positive(),
          "last over first cell size of each block along " + name + ", geometric in between")
      .unset_by_default("1")
      .used_if(has_blocks, no_blocks);
}

/// Appends the faces of a block behind its lower edge, which is there already; sizes grow geometrically from 1 to
/// `ratio`.
void append_block(std::vector<double>& faces, double lower, double upper, int cells, double ratio) {
  const double growth = cells > 1 ? std::pow(ratio, 1.0 / (cells - 1)) : 1.0;
  const bool uniform = std::abs(growth - 1) < 1e-14;
  for (int i = 1; i < cells; ++i) {
    const double length = upper - lower;
    const double part =
        uniform ? length * i / cells : length * std::expm1(i * std::log(growth)) / std::expm1(cells * std::log(growth));
    faces.push_back(lower + part);
  }
  faces.push_back(upper);
}

template <class List>
void check_length(const std::string& key, const List& list, std::size_t length, const std::string& why) {
  if (list.size() == length) return;
  const std::string given = list.empty() ? "" : std::to_string(list.size()) + " entries";
  throw InputError(key, given, std::to_string(length) + (length == 1 ? " entry, " : " entries, ") + why);
}

void check_edges(const std::string& key, const std::vector<double>& edges) {
  if (edges.size() < 2) throw InputError(key, number_text(edges[0]), "at least two edges");
  for (std::size_t b = 0; b + 1 < edges.size(); ++b) {
    if (!(edges[b + 1] > edges[b]))
      throw InputError(key, number_text(edges[b + 1]), "ascending edges, so more than " + number_text(edges[b]));
  }
}

std::vector<double> faces_of_blocks(const std::string& axis, GridInput::Blocks blocks, int refine) {
  const std::string key = "grid_" + axis + "_";
  check_edges(key + "edges", blocks.edges);
  const std::size_t count = blocks.edges.size() - 1;
  check_length(key + "cells", blocks.cells, count, "one fewer than " + key + "edges has");
  if (blocks.ratios.empty()) blocks.ratios.assign(count, 1.0);
  check_length(key + "ratio", blocks.ratios, count, "one fewer than " + key + "edges has");
  std::vector<double> faces{blocks.edges[0]};
  for (std::size_t b = 0; b < count; ++b)
    append_block(faces, blocks.edges[b], blocks.edges[b + 1], blocks.cells[b] * refine, blocks.ratios[b]);
  return faces;
}

/// Lower and upper end of an axis without blocks.
std::array<double, 2> ends_of_axis(const GridInput& grid, int axis) {
  check_length("extent", grid.extent, static_cast<std::size_t>(grid.dim), "one length per axis");
  const double origin = grid.origin.empty() ? 0.0 : grid.origin[axis];
  return {origin, origin + grid.extent[axis]};
}

std::vector<double> faces_of_axis(const GridInput& grid, int axis) {
  const GridInput::Blocks& blocks = grid.blocks[axis];
  if (!blocks.edges.empty()) return faces_of_blocks(axis_names[axis], blocks, grid.refine);
  const auto [lower, upper] = ends_of_axis(grid, axis);
  check_length("grid_cells", grid.cells, static_cast<std::size_t>(grid.dim), "one number of cells per axis");
  std::vector<double> faces{lower};
  append_block(faces, lower, upper, grid.cells[axis] * grid.refine, 1.0);
  return faces;
}

/// Of a grid that is given by sizes: the ends of the axis, with the edges between them.
std::vector<double> planes_of_axis(const GridInput& grid, int axis) {
  const GridInput::Blocks& blocks = grid.blocks[axis];
  if (!blocks.edges.empty()) {
    check_edges(std::string("grid_") + axis_names[axis] + "_edges", blocks.edges);
    return blocks.edges;
  }
  const auto [lower, upper] = ends_of_axis(grid, axis);
  return {lower, upper};
}

/// Before the faces are built: nodes and unknowns are to be numbers of PETSc, and each rank holds all faces of an axis.
void check_size(const std::vector<double>& cells_by_axis) {
  constexpr double most_along_axis = 1e7;
  constexpr int unknowns = 4 + 2 * max_dim;  // nu, T, chi, p_g, v, u; g_f has no gas beside it
  constexpr double most = PETSC_MAX_INT / unknowns;
  double nodes = 1;
  for (std::size_t axis = 0; axis < cells_by_axis.size(); ++axis) {
    const double cells = cells_by_axis[axis];
    if (cells > most_along_axis)
      throw InputError("grid", number_text(cells) + " cells along " + axis_names[axis],
                       "at most " + number_text(most_along_axis) + " along an axis");
    nodes *= cells + 1;
  }
  if (nodes > most)
    throw InputError("grid", number_text(nodes) + " nodes",
                     "at most " + number_text(most) + ", as PETSc numbers unknowns");
}

void set_periodic(Box& box, const std::vector<std::string>& axes) {
  for (const std::string& letter : axes) {
    const auto* axis = std::find(axis_names, axis_names + box.dim, letter);
    if (axis == axis_names + box.dim) {
      if (letter == "none" && axes.size() == 1) return;
      throw InputError("periodic", letter, "axes of this case (x, y, z up to its dimension) or none");
    }
    box.periodic[static_cast<std::size_t>(axis - axis_names)] = true;
  }
}

}  // namespace

double cells_along(const GridInput& grid, int axis) {
  const std::size_t a = static_cast<std::size_t>(axis);
  double cells = a < grid.cells.size() ? grid.cells[a] : 0;
  if (!grid.blocks[a].edges.empty())
    cells = std::accumulate(grid.blocks[a].cells.begin(), grid.blocks[a].cells.end(), 0.0);
  return cells * grid.refine;
}

OptionSet::Choices<int> axis_choices(const OptionSet& o, int dim) {
  OptionSet::Choices<int> choices;
  for (int axis = 0; axis < (o.describing() ? max_dim : dim); ++axis) choices.push_back({axis_names[axis], axis});
  return choices;
}

Patch patch_from(const std::vector<double>& coordinates, int normal, int dim, std::size_t first) {
  Patch patch;
  if (coordinates.empty()) return patch;
  for (int axis = 0; axis < dim; ++axis) {
    if (axis == normal) continue;
    patch.lower[axis] = coordinates[first++];
    patch.upper[axis] = coordinates[first++];
  }
  return patch;
}

void declare_grid(OptionSet& o, GridInput& grid) {
  o.group("grid");
  o.choice("dimension", grid.dim, {{"1", 1}, {"2", 2}, {"3", 3}}, "number of axes");
  const std::size_t dim = static_cast<std::size_t>(grid.dim);
  OptionEntry& extent =
      o.reals("extent", grid.extent, {dim, false, "one per axis"}, "m", positive(), "size of the box");
  OptionEntry& origin =
      o.reals("origin", grid.origin, {dim, false, "one per axis"}, "m", any_number(), "lower corner of the box");
  OptionEntry& cells = o.integers("grid_cells", grid.cells, {dim, false, "one per axis"}, 1, "cells of the box");
  declare_sizes(o, grid.dim, grid.sizes);
  bool uniform_axis = o.describing();
  for (int axis = 0; axis < max_dim; ++axis) {
    declare_blocks(o, axis, grid.dim, grid.by_sizes(), grid.blocks[axis]);
    uniform_axis = uniform_axis || (axis < grid.dim && grid.blocks[axis].edges.empty());
  }
  const std::string no_axis = "grid_<axis>_edges is given for all axes";
  extent.unset_by_default("required without grid_<axis>_edges").used_if(uniform_axis, no_axis);
  cells.unset_by_default("required without grid_<axis>_edges or grid_finest")
      .used_if(uniform_axis, no_axis)
      .used_if(!grid.by_sizes(), given_by_sizes);
  origin.unset_by_default("0").used_if(uniform_axis, no_axis);
  o.integer("grid_refine", grid.refine, 1, "multiplies all numbers of cells");
  o.texts("periodic", grid.periodic, "axes, such as 'x' or 'x, y'", "axes along which the box repeats");
}

Box make_box(const GridInput& grid, const Case& scene) {
  Box box;
  box.dim = grid.dim;
  set_periodic(box, grid.periodic);
  std::vector<GradedAxis> graded;
  if (grid.by_sizes()) {
    for (int axis = 0; axis < grid.dim; ++axis) box.faces[axis] = planes_of_axis(grid, axis);
    graded = graded_axes(grid, box, scene);
  }
  std::vector<double> cells;
  for (int axis = 0; axis < grid.dim; ++axis)
    cells.push_back(graded.empty() ? cells_along(grid, axis) : graded[axis].cells() * grid.refine);
  check_size(cells);
  for (int axis = 0; axis < grid.dim; ++axis)
    box.faces[axis] = graded.empty() ? faces_of_axis(grid, axis) : graded[axis].faces(grid.refine);
  return box;
}

}  // namespace scree
