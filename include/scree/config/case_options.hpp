/// The declarations of all options, one function and one file an idea; read_case.cpp calls them in the order of a case
/// file.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "scree/config/case.hpp"
#include "scree/config/option_set.hpp"
#include "scree/grid/axis_name.hpp"
#include "scree/grid/graded_axis.hpp"

namespace scree {

/// The grid as given, before it becomes a Box.
struct GridInput {
  /// Blocks of cells along an axis: edges, and per block its cells and the ratio of its last to its first cell size.
  struct Blocks {
    std::vector<double> edges;
    std::vector<int> cells;
    std::vector<double> ratios;
  };
  /// In place of numbers of cells: their sizes, and the places to refine. Each list has one entry, or one per axis.
  struct Sizes {
    std::vector<double> finest, coarsest;
    std::vector<double> growth{1.2};
    std::vector<std::string> fine_at{"openings"};        ///< names of items of the case
    std::array<std::vector<double>, max_dim> positions;  ///< further places, by axis
  };
  int dim = 2;
  std::vector<double> extent, origin;
  std::vector<int> cells;
  Sizes sizes;
  std::array<Blocks, max_dim> blocks;
  int refine = 1;
  std::vector<std::string> periodic;

  /// Whether cells are given by their sizes.
  bool by_sizes() const { return !sizes.finest.empty(); }
};

/// Cells along an axis that are given by number; 0 where none are.
double cells_along(const GridInput& grid, int axis);

/// An item whose place in its list the user chooses.
template <class Item>
struct Ordered {
  int order = 0;
  Item item;
};

/// The items by order, those of equal order as they stand.
template <class Item>
std::vector<Item> in_order(std::vector<Ordered<Item>> list) {
  std::stable_sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.order < b.order; });
  std::vector<Item> items;
  for (auto& entry : list) items.push_back(std::move(entry.item));
  return items;
}

/// Axes by letter, as many as the case has.
OptionSet::Choices<int> axis_choices(const OptionSet& o, int dim);

/// lower, upper for each axis but `normal` (-1: for all) in order, as a patch; an empty list is the whole.
Patch patch_from(const std::vector<double>& coordinates, int normal, int dim, std::size_t first = 0);

/// Unit of the option for an unknown, and the numbers that it accepts.
std::string option_unit(const Unknown& unknown);
Range range_of(Allowed allowed, const Case& the_case);
/// Why the scene has no such unknown; empty: it has.
std::string absence(const Case& the_case, const Unknown& unknown);

/// All options in the order of a case file.
void declare_all(OptionSet& o, GridInput& grid, Case& the_case);
/// `options` with all of them declared, of a case that is not kept.
OptionSet declared(OptionSet options, const Catalogue& catalogue);

void declare_grid(OptionSet& o, GridInput& grid);
void declare_model(OptionSet& o, int dim, ModelParameters& model);
void declare_particles(OptionSet& o, KineticParameters& kinetic, FrictionParameters& friction, WallParameters& wall);
void declare_gas(OptionSet& o, int dim, Case& the_case);
void declare_friction(OptionSet& o, FrictionParameters& friction, TemperatureModel temperature,
                      KineticParameters& kinetic);
void declare_wall(OptionSet& o, WallParameters& wall);
std::vector<Segment> declare_boundaries(OptionSet& o, const GridInput& grid, const Case& the_case);
std::vector<Plate> declare_plates(OptionSet& o, const GridInput& grid, const Case& the_case);
/// Whether an option has a use, and if not, why.
struct OptionUse {
  bool used;
  std::string otherwise;
};
/// How the velocity of a phase that an inlet prescribes varies over its patch and in time. `prefix` comes before the
/// names of the options, "gas_" or nothing; `normal` is the axis of the side.
void declare_variation(OptionSet& o, const std::string& key, const std::string& prefix, int dim, const OptionUse& use,
                       int normal, InletVariation& variation);
/// What a side does to the gas; its kind and axis are known.
void declare_gas_side(OptionSet& o, const std::string& key, int dim, const Case& the_case, Segment& segment);
/// Slip of the gas at a wall or plate; its kind is known.
void declare_gas_wall(OptionSet& o, const std::string& key, const Case& the_case, Condition& condition);
std::vector<InitialRegion> declare_initial(OptionSet& o, const GridInput& grid, const Case& the_case);
void declare_time(OptionSet& o, TimeParameters& time);
void declare_output(OptionSet& o, const GridInput& grid, Case& the_case);
void declare_solver(OptionSet& o, Case& the_case);

/// The sizes of cells, where they are given in place of numbers.
void declare_sizes(OptionSet& o, int dim, GridInput::Sizes& sizes);

/// The box with its face positions, for the scene with all that is in it. Throws InputError if lists do not fit
/// together, and if there are no cells of the wanted sizes.
Box make_box(const GridInput& grid, const Case& scene);

/// What the scene asks of the cells along an axis by its edges.
struct GridPlaces {
  std::vector<double> planes;  ///< where faces have to lie [m]
  std::vector<double> fine;    ///< those of them where cells are to be finest; an end of the axis may be one [m]
  std::vector<double> edges;   ///< of initial regions, where faces should lie unless other planes are close [m]
};

/// The places by axis, for a box with such ends. Throws InputError for a name in grid_fine_at that the scene lacks.
std::array<GridPlaces, max_dim> grid_places(const std::vector<std::string>& fine_at, const Box& ends,
                                            const Case& scene);

/// The axes of a grid that is given by sizes, for a box with such ends. Throws InputError.
std::vector<GradedAxis> graded_axes(const GridInput& grid, const Box& ends, const Case& scene);

/// Lines about the grid: numbers of cells, the smallest and the greatest, and how fast they grow.
std::vector<std::string> grid_summary(const Box& box);

/// Moves all patches, plates and flux planes exactly onto grid planes.
/// Throws InputError naming the nearest grid plane if one is off by more than 1e-6 of a cell.
void put_on_grid(Case& the_case);

/// Combinations of values: one place for what concerns more than one option. Reads the tables. Throws InputError.
void check_case(Case& the_case);

/// What the boundaries say of the gas; the sides are known to be covered. Throws InputError.
void check_gas(const Case& the_case);

/// What comes into each connected part of the box has to find its way out, or room. Reads no tables. Throws InputError.
void check_ways_out(const Case& the_case);

/// Numbers that are allowed but odd, such as a particle as large as the box: one line for each.
std::vector<std::string> odd_numbers(const Case& the_case, const CaseInput& input);

/// Throws InputError for the first key that is neither ours nor a definition nor PETSc's; names the nearest known one.
void check_keys(const CaseInput& input, const OptionSet& known);

/// The effective case as YAML, with the PETSc options that were given.
std::string effective_yaml(const CaseInput& input, const OptionSet& options);

/// One line for each given key that this scene does not use.
std::vector<std::string> unused_remarks(const CaseInput& input, const OptionSet& options);

}  // namespace scree
