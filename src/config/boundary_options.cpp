#include "scree/config/case_options.hpp"

namespace scree {
namespace {

/// Kinds by name; of plates, the walls alone.
OptionSet::Choices<BoundaryKind> kind_choices(const Case& the_case, bool walls_alone) {
  OptionSet::Choices<BoundaryKind> choices;
  for (const BoundaryKind* kind : the_case.catalogue.boundary_kinds())
    if (kind->is_wall() || !walls_alone) choices.push_back({std::string(kind->name), *kind});
  return choices;
}

/// Sides by name; a side is 2 axis + (1 for the upper one).
OptionSet::Choices<int> side_choices(const OptionSet& o, int dim) {
  OptionSet::Choices<int> choices;
  for (const auto& [name, axis] : axis_choices(o, dim)) {
    choices.push_back({name + "_lower", 2 * axis});
    choices.push_back({name + "_upper", 2 * axis + 1});
  }
  return choices;
}

/// A key with coordinates in the plane of a side or plate; the whole of it if not given.
std::vector<double> declare_patches(OptionSet& o, const std::string& key, int dim, bool several,
                                    const std::string& otherwise, const std::string& text) {
  std::vector<double> list;
  const std::size_t count = 2 * static_cast<std::size_t>(dim - 1);
  const OptionEntry& entry =
      o.reals(key, list, {count, several, "lower, upper per remaining axis"}, "m", any_number(), text)
          .unset_by_default(otherwise);
  if (entry.given && dim == 1) throw InputError(key, entry.value, "no coordinates: a side is a point in one dimension");
  return list;
}

/// Whether (25) and (26) hold.
bool has_wall_law(const Condition& condition) {
  return condition.kind.solids_tangential == SolidsTangential::johnson_jackson;
}

void declare_wall_values(OptionSet& o, const std::string& key, bool used, WallParameters& wall) {
  const std::string other_kind = "its kind is not wall_johnson_jackson";
  o.real(key + "friction_angle", wall.delta, "rad", angle_below_right(), "angle of wall friction, eq. (25)")
      .symbol("delta")
      .default_from("wall_friction_angle")
      .used_if(used, other_kind);
  o.real(key + "specularity", wall.specularity, "-", from_zero_to_one(), "specularity coefficient of (25), (26)")
      .symbol("phi'")
      .default_from("wall_specularity")
      .used_if(used, other_kind);
  o.real(key + "restitution", wall.e_w, "-", above_zero_to_one(), "restitution between particle and wall, eq. (26)")
      .symbol("e_w")
      .default_from("wall_restitution")
      .used_if(used, other_kind);
  o.real(key + "particle_friction", wall.mu_w, "-", non_negative(), "friction in collisions with the wall, in (26)")
      .symbol("mu_w")
      .default_from("wall_particle_friction")
      .used_if(used, other_kind);
}

void declare_inlet_values(OptionSet& o, const std::string& key, const Case& the_case, Condition& condition) {
  const bool inlet = condition.kind.brings_solids();
  for (const Unknown* unknown : the_case.catalogue.unknowns()) {
    const GivenValue& given = unknown->inlet;
    if (!given.text) continue;
    const std::string absent = absence(the_case, *unknown);
    double value = given.otherwise;
    OptionEntry& option =
        o.real(key + unknown->dataset, value, option_unit(*unknown), range_of(given.allowed, the_case), given.text)
            .symbol(unknown->symbol)
            .used_if(inlet, "its kind is not inlet")
            .used_if(absent.empty(), absent);
    if (given.required) option.unset_by_default("required for an inlet").needed = inlet;
    condition.bring(*unknown, value);
  }
}

void declare_segment(OptionSet& o, const std::string& key, const GridInput& grid, const Case& the_case,
                     Ordered<Segment>& entry) {
  Segment& segment = entry.item;
  Condition& condition = segment.condition;
  condition.wall = the_case.wall;
  int side = 0;
  o.choice(key + "side", side, side_choices(o, grid.dim), "side of the box").required();
  segment.axis = side / 2;
  segment.upper = side % 2 == 1;
  o.choice(key + "kind", condition.kind, kind_choices(the_case, false), "what happens there, see the table of kinds")
      .required();
  segment.patch = patch_from(
      declare_patches(o, key + "patch", grid.dim, false, "the whole side", "part of the side, on grid planes"),
      segment.axis, grid.dim);
  o.integer(key + "order", entry.order, -1000000, "where segments overlap the higher order holds, then the later name");
  const bool moves = condition.kind.moves();
  o.vector(key + "velocity", condition.velocity, grid.dim, "m/s", "of the wall, or of what an inlet brings")
      .symbol("v")
      .used_if(moves, "its kind has no velocity");
  if (!moves) condition.velocity.fill(0);
  declare_wall_values(o, key, has_wall_law(condition), condition.wall);
  declare_inlet_values(o, key, the_case, condition);
  declare_variation(o, key, "", grid.dim, {condition.kind.brings_solids(), "its kind is not inlet"}, segment.axis,
                    condition.variation);
  declare_gas_side(o, key, grid.dim, the_case, segment);
  o.real(key + "from", condition.from, "s", any_number(), "start of its time window").unset_by_default("always");
  o.real(key + "until", condition.until, "s", any_number(), "end of its time window").unset_by_default("always");
}

void declare_slide(OptionSet& o, const std::string& key, int dim, Plate& plate) {
  o.real(key + "slide_speed", plate.slide_speed, "m/s", any_number(),
         "speed along slide_axis at which the plate slides in its plane, span and openings together; its edges pass "
         "one face after the other, at whose times steps end, and what slides may reach beyond the box");
  const bool slides = plate.slides();
  const std::string at_rest = "its slide_speed is 0";
  plate.slide_axis = plate.axis == 0 && dim > 1 ? 1 : 0;
  o.choice(key + "slide_axis", plate.slide_axis, axis_choices(o, dim), "axis along which it slides, in its plane")
      .default_from("the first axis in its plane")
      .used_if(o.describing() || slides, at_rest);
  if (slides && plate.slide_axis == plate.axis)
    throw InputError(key + "slide_axis", axis_names[plate.axis], "an axis in the plane of the plate");
  o.real(key + "slide_from", plate.slide_from, "s", any_number(), "when it begins to slide").used_if(slides, at_rest);
  o.real(key + "slide_until", plate.slide_until, "s", any_number(), "when it stops")
      .unset_by_default("never")
      .used_if(slides, at_rest);
}

void declare_plate(OptionSet& o, const std::string& key, const GridInput& grid, const Case& the_case, Plate& plate) {
  plate.condition.wall = the_case.wall;
  o.choice(key + "axis", plate.axis, axis_choices(o, grid.dim), "axis normal to the plate").required();
  o.real(key + "position", plate.position, "m", any_number(), "coordinate along that axis, on a grid plane").required();
  o.choice(key + "kind", plate.condition.kind, kind_choices(the_case, true), "wall law on both sides");
  plate.span = patch_from(declare_patches(o, key + "span", grid.dim, false, "everywhere", "extent, on grid planes"),
                          plate.axis, grid.dim);
  const std::vector<double> openings =
      declare_patches(o, key + "openings", grid.dim, true, "none", "holes in the plate, one after the other");
  for (std::size_t first = 0; first < openings.size(); first += 2 * static_cast<std::size_t>(grid.dim - 1))
    plate.openings.push_back(patch_from(openings, plate.axis, grid.dim, first));
  o.vector(key + "velocity", plate.condition.velocity, grid.dim, "m/s",
           "of the wall, in its plane, as of a belt; the plate stays where it is")
      .symbol("v");
  declare_wall_values(o, key, has_wall_law(plate.condition), plate.condition.wall);
  declare_gas_wall(o, key, the_case, plate.condition);
  o.real(key + "from", plate.condition.from, "s", any_number(), "when the plate comes")
      .unset_by_default("always there");
  o.real(key + "until", plate.condition.until, "s", any_number(), "when the plate goes")
      .unset_by_default("always there");
  declare_slide(o, key, grid.dim, plate);
}

}  // namespace

std::vector<Segment> declare_boundaries(OptionSet& o, const GridInput& grid, const Case& the_case) {
  return in_order(o.named<Ordered<Segment>>(
      "boundary", [&](OptionSet& set, const std::string& key, const std::string& name, Ordered<Segment>& entry) {
        entry.item.condition.name = name;
        declare_segment(set, key, grid, the_case, entry);
      }));
}

std::vector<Plate> declare_plates(OptionSet& o, const GridInput& grid, const Case& the_case) {
  return o.named<Plate>("plate", [&](OptionSet& set, const std::string& key, const std::string& name, Plate& plate) {
    plate.condition.name = name;
    declare_plate(set, key, grid, the_case, plate);
  });
}

}  // namespace scree
