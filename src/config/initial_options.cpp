#include "scree/config/case_options.hpp"

namespace scree {
namespace {

/// What holds where no region says otherwise: an empty box.
InitialRegion empty_box(const std::vector<const Unknown*>& unknowns) {
  InitialRegion region;
  region.name = "default";
  for (const Unknown* unknown : unknowns) {
    if (!unknown->initial.text) continue;
    region.values.push_back({unknown, {}});
    region.values.back().value.fill(unknown->initial.otherwise);
  }
  return region;
}

void declare_profile(OptionSet& o, const std::string& key, const GridInput& grid, InitialRegion& region) {
  using Profile = InitialRegion::Profile;
  o.choice(key + "profile", region.profile, {{"uniform", Profile::uniform}, {"equilibrium", Profile::equilibrium}},
           "equilibrium: solids fraction of a column at rest below `surface`");
  const bool equilibrium = region.profile == Profile::equilibrium;
  const std::string uniform = "its profile is uniform";
  OptionEntry& surface =
      o.real(key + "surface", region.surface, "m", any_number(), "free surface of the column, along gravity's axis")
          .unset_by_default("required for equilibrium")
          .used_if(equilibrium, uniform);
  surface.needed = equilibrium;
  o.real(key + "janssen_width", region.janssen_width, "m", non_negative(),
         "equilibrium with wall friction in a plane bin of this width; 0: without")
      .used_if(equilibrium, uniform);
  o.file(key + "table", region.table,
         "lines 'coordinate solids_fraction', in SI, interpolated; beside the case file that names it");
  o.choice(key + "table_axis", region.table_axis, axis_choices(o, grid.dim), "axis of the table's coordinate")
      .used_if(!region.table.empty() || o.describing(), "there is no table");
  o.text(key + "run", region.run, "a directory of a run",
         "run whose last state fills the region, from its grid to this one: solids fraction with its mass, velocities "
         "and temperatures as means; values that the region names itself hold, and what that run has not, such as a "
         "gas, starts as elsewhere");
}

/// The option of one unknown, which may be given `elsewhere`, by a profile, table or run; whether it is given.
bool declare_value(OptionSet& o, const std::string& key, const GridInput& grid, const Case& the_case, bool elsewhere,
                   const Unknown& unknown, InitialValue& entry) {
  entry.unknown = &unknown;
  const std::string name = key + unknown.dataset, absent = absence(the_case, unknown);
  OptionEntry& option = unknown.place == Place::face
                            ? o.vector(name, entry.value, grid.dim, unknown.unit, unknown.initial.text)
                            : o.real(name, entry.value[0], option_unit(unknown),
                                     range_of(unknown.initial.allowed, the_case), unknown.initial.text);
  return option.symbol(unknown.symbol)
      .unset_by_default("unchanged")
      .used_if(absent.empty(), absent)
      .used_if(!elsewhere, "its profile, table or run gives the solids fraction")
      .given;
}

void declare_gradient(OptionSet& o, const std::string& key, const GridInput& grid, InitialRegion& region) {
  const std::size_t dim = static_cast<std::size_t>(grid.dim);
  std::vector<double> gradient;
  o.reals(key + "velocity_gradient", gradient, {dim * dim, false, "row by row, dv_i/dx_j"}, "1/s", any_number(),
          "added to velocity as gradient times (x - lower corner of the box)")
      .unset_by_default("0");
  for (std::size_t k = 0; k < gradient.size(); ++k)
    region.velocity_gradient[max_dim * (k / dim) + k % dim] = gradient[k];
  if (!gradient.empty() && !region.find(SolidsMomentum::unknown))
    region.values.push_back({&SolidsMomentum::unknown, {0, 0, 0}});
}

void declare_values(OptionSet& o, const std::string& key, const GridInput& grid, const Case& the_case,
                    InitialRegion& region) {
  for (const Unknown* unknown : the_case.catalogue.unknowns()) {
    if (!unknown->initial.text) continue;
    InitialValue entry;
    const bool elsewhere = unknown == &SolidsContinuity::unknown && region.has_own_solids_fraction();
    if (declare_value(o, key, grid, the_case, elsewhere, *unknown, entry)) region.values.push_back(entry);
    if (unknown == &SolidsMomentum::unknown) declare_gradient(o, key, grid, region);
  }
}

void declare_region(OptionSet& o, const std::string& key, const GridInput& grid, const Case& the_case,
                    Ordered<InitialRegion>& entry) {
  InitialRegion& region = entry.item;
  std::vector<double> box;
  const std::size_t count = 2 * static_cast<std::size_t>(grid.dim);
  o.reals(key + "box", box, {count, false, "lower, upper per axis"}, "m", any_number(), "where the region is")
      .unset_by_default("everywhere");
  const Patch place = patch_from(box, -1, grid.dim);
  region.lower = place.lower;
  region.upper = place.upper;
  o.integer(key + "order", entry.order, -1000000, "regions of higher order, then of later name, overwrite the others");
  declare_profile(o, key, grid, region);
  declare_values(o, key, grid, the_case, region);
}

}  // namespace

std::vector<InitialRegion> declare_initial(OptionSet& o, const GridInput& grid, const Case& the_case) {
  std::vector<InitialRegion> regions = in_order(o.named<Ordered<InitialRegion>>(
      "initial", [&](OptionSet& set, const std::string& key, const std::string& name, Ordered<InitialRegion>& entry) {
        entry.item.name = name;
        declare_region(set, key, grid, the_case, entry);
      }));
  InitialRegion everywhere = empty_box(the_case.catalogue.unknowns());
  everywhere.lower = Patch().lower;
  everywhere.upper = Patch().upper;
  regions.insert(regions.begin(), everywhere);
  return regions;
}

}  // namespace scree
