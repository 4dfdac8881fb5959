#include "scree/config/read_case.hpp"

#include "scree/config/case_options.hpp"

namespace scree {
namespace {

/// Region boxes as parts of the box of the case.
void clip_regions(const Box& box, std::vector<InitialRegion>& regions) {
  for (InitialRegion& region : regions) {
    for (int axis = 0; axis < max_dim; ++axis) {
      const bool present = axis < box.dim;
      region.lower[axis] = present ? std::max(region.lower[axis], box.lower(axis)) : 0.0;
      region.upper[axis] = present ? std::min(region.upper[axis], box.upper(axis)) : 0.0;
    }
  }
}

}  // namespace

void declare_all(OptionSet& o, GridInput& grid, Case& the_case) {
  declare_grid(o, grid);
  declare_model(o, grid.dim, the_case.model);
  declare_particles(o, the_case.kinetic, the_case.friction, the_case.wall);
  declare_gas(o, grid.dim, the_case);
  declare_friction(o, the_case.friction, the_case.model.temperature, the_case.kinetic);
  declare_wall(o, the_case.wall);
  the_case.segments = declare_boundaries(o, grid, the_case);
  the_case.plates = declare_plates(o, grid, the_case);
  the_case.initial = declare_initial(o, grid, the_case);
  declare_time(o, the_case.time);
  declare_output(o, grid, the_case);
  declare_solver(o, the_case);
  if (the_case.catalogue.further_options) the_case.catalogue.further_options(o);
}

OptionSet declared(OptionSet options, const Catalogue& catalogue) {
  GridInput grid;
  Case the_case;
  the_case.catalogue = catalogue;
  declare_all(options, grid, the_case);
  return options;
}

namespace {

std::vector<PetscOption> petsc_options(const CaseInput& input) {
  std::vector<PetscOption> options;
  for (const auto& [key, given] : input.entries())
    if (input.is_for_petsc(key)) options.push_back({key, given.text, given.place.empty()});
  return options;
}

Case understood(const CaseInput& input, const Catalogue& catalogue) {
  check_keys(input, declared(OptionSet(input, OptionSet::Mode::describe), catalogue));

  OptionSet options(input, OptionSet::Mode::read);
  GridInput grid;
  Case the_case;
  the_case.catalogue = catalogue;
  declare_all(options, grid, the_case);
  options.check_required();

  the_case.box = make_box(grid, the_case);
  put_on_grid(the_case);
  clip_regions(the_case.box, the_case.initial);
  check_case(the_case);

  the_case.effective_yaml = effective_yaml(input, options);
  the_case.grid_summary = grid_summary(the_case.box);
  the_case.petsc_options = petsc_options(input);
  the_case.remarks = input.remarks();
  for (const std::vector<std::string>& more : {unused_remarks(input, options), odd_numbers(the_case, input)})
    the_case.remarks.insert(the_case.remarks.end(), more.begin(), more.end());
  return the_case;
}

}  // namespace

Case read_case(const CaseInput& input, const Catalogue& catalogue) {
  try {
    return understood(input, catalogue);
  } catch (const InputError& error) {
    throw located(error, input);
  }
}

}  // namespace scree
