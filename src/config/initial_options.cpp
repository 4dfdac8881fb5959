#include "scree/closures/rheology.hpp"
#include "scree/config/case_options.hpp"

namespace scree {
namespace {

/// What holds where no region says otherwise: an empty box.
InitialRegion empty_box() {
  InitialRegion region;
  region.name = "default";
  region.has_solids_fraction = region.has_velocity = region.has_temperature = region.has_chi = region.has_gas_velocity =
      true;
  region.granular_temperature = 1e-4;
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
  o.text(key + "table", region.table, "a file", "lines 'coordinate solids_fraction', in SI, interpolated");
  o.choice(key + "table_axis", region.table_axis, axis_choices(o, grid.dim), "axis of the table's coordinate")
      .used_if(!region.table.empty() || o.describing(), "there is no table");
}

void declare_values(OptionSet& o, const std::string& key, const GridInput& grid, const Case& scene,
                    InitialRegion& region) {
  const bool own_profile = region.profile != InitialRegion::Profile::uniform || !region.table.empty();
  region.has_solids_fraction =
      o.real(key + "solids_fraction", region.solids_fraction, "-",
             from_zero_below(scene.kinetic.nu_max, "solids_fraction_max"), "solids fraction in the region")
          .symbol("nu")
          .unset_by_default("unchanged")
          .used_if(!own_profile, "its profile or table gives the solids fraction")
          .given ||
      own_profile;
  const bool velocity = o.vector(key + "velocity", region.velocity, grid.dim, "m/s", "velocity of the particles")
                            .symbol("v")
                            .unset_by_default("unchanged")
                            .given;
  const std::size_t dim = static_cast<std::size_t>(grid.dim);
  std::vector<double> gradient;
  o.reals(key + "velocity_gradient", gradient, {dim * dim, false, "row by row, dv_i/dx_j"}, "1/s", any_number(),
          "added to velocity as gradient times (x - lower corner of the box)")
      .unset_by_default("0");
  for (std::size_t k = 0; k < gradient.size(); ++k)
    region.velocity_gradient[max_dim * (k / dim) + k % dim] = gradient[k];
  region.has_velocity = velocity || !gradient.empty();
  region.has_temperature =
      o.real(key + "granular_temperature", region.granular_temperature, "m2/s2", non_negative(), "granular temperature")
          .symbol("T")
          .unset_by_default("unchanged")
          .used_if(scene.model.temperature != TemperatureModel::constant, "granular_temperature is constant")
          .given;
  region.has_chi =
      o.real(key + "frictional_pressure_ratio", region.chi, "-", non_negative(), "scaled frictional pressure")
          .symbol("chi")
          .unset_by_default("unchanged")
          .used_if(scene.friction.model->has_unknown, "friction_model is not relaxed")
          .given;
  region.has_gas_velocity = o.vector(key + "gas_velocity", region.gas_velocity, grid.dim, "m/s",
                                     "velocity of the gas, before it is made consistent with (2)")
                                .symbol("u")
                                .unset_by_default("unchanged")
                                .used_if(scene.gas.model == GasModel::incompressible, "gas is not incompressible")
                                .given;
}

void declare_region(OptionSet& o, const std::string& key, const GridInput& grid, const Case& scene,
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
  declare_values(o, key, grid, scene, region);
}

}  // namespace

std::vector<InitialRegion> declare_initial(OptionSet& o, const GridInput& grid, const Case& scene) {
  std::vector<InitialRegion> regions = in_order(o.named<Ordered<InitialRegion>>(
      "initial", [&](OptionSet& set, const std::string& key, const std::string& name, Ordered<InitialRegion>& entry) {
        entry.item.name = name;
        declare_region(set, key, grid, scene, entry);
      }));
  InitialRegion everywhere = empty_box();
  everywhere.lower = Patch().lower;
  everywhere.upper = Patch().upper;
  regions.insert(regions.begin(), everywhere);
  return regions;
}

}  // namespace scree
