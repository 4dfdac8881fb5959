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

OptionSet known_options(const CaseInput& input, const Catalogue& catalogue) {
  OptionSet known(input, OptionSet::Mode::describe);
  GridInput grid;
  Case scene;
  scene.catalogue = catalogue;
  declare_all(known, grid, scene);
  return known;
}

}  // namespace

void declare_all(OptionSet& o, GridInput& grid, Case& scene) {
  declare_grid(o, grid);
  declare_model(o, grid.dim, scene.model);
  declare_particles(o, scene.kinetic, scene.friction, scene.wall);
  declare_gas(o, scene);
  declare_friction(o, scene.friction, scene.model.temperature, scene.kinetic);
  declare_wall(o, scene.wall);
  scene.segments = declare_boundaries(o, grid, scene);
  scene.plates = declare_plates(o, grid, scene);
  scene.initial = declare_initial(o, grid, scene);
  declare_time(o, scene.time);
  declare_output(o, grid, scene);
  declare_solver(o, scene);
  if (scene.catalogue.further_options) scene.catalogue.further_options(o);
}

namespace {

std::vector<PetscOption> petsc_options(const CaseInput& input) {
  std::vector<PetscOption> options;
  for (const auto& [key, given] : input.entries())
    if (input.is_for_petsc(key)) options.push_back({key, given.text, given.place.empty()});
  return options;
}

Case understood(const CaseInput& input, const Catalogue& catalogue) {
  check_keys(input, known_options(input, catalogue));

  OptionSet options(input, OptionSet::Mode::read);
  GridInput grid;
  Case scene;
  scene.catalogue = catalogue;
  declare_all(options, grid, scene);
  options.check_required();

  scene.box = make_box(grid);
  put_on_grid(scene);
  clip_regions(scene.box, scene.initial);
  check_case(scene);

  scene.effective_yaml = effective_yaml(input, options);
  scene.petsc_options = petsc_options(input);
  scene.remarks = input.remarks();
  for (const std::vector<std::string>& more : {unused_remarks(input, options), odd_numbers(scene)})
    scene.remarks.insert(scene.remarks.end(), more.begin(), more.end());
  return scene;
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
