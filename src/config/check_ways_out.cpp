#include <algorithm>
#include <cmath>
#include <set>

#include "scree/config/case_options.hpp"
#include "scree/config/connected_parts.hpp"
#include "scree/config/side_samples.hpp"

namespace scree {
namespace {

/// What bounds one part of the box at a time, with the area that it has there.
struct Exposed {
  const Segment* segment;
  double area;
};

bool brings_gas_at(const Segment& segment, double time) {
  const Condition& condition = segment.condition;
  if (!condition.kind.brings_gas()) return false;
  const std::vector<double>& factors = condition.gas_variation.profile.factor;
  const bool profile =
      factors.empty() || std::any_of(factors.begin(), factors.end(), [](double factor) { return factor != 0; });
  return profile && condition.gas_velocity != 0 && condition.gas_variation.in_time(time) != 0;
}

/// Mean over the patch of a profile.
double mean_of(const InletVariation& variation) {
  if (variation.profile.at.empty()) return 1;
  constexpr int samples = 1000;
  const double lower = variation.lower[variation.axis], width = variation.upper[variation.axis] - lower;
  double sum = 0;
  for (int i = 0; i < samples; ++i) sum += variation.profile.value(lower + (i + 0.5) / samples * width);
  return sum / samples;
}

/// Volume of particles that comes in at a time, an area and a time; negative for what is taken out [m/s].
double particle_inflow(const Segment& segment, double time) {
  const Condition& condition = segment.condition;
  if (!condition.kind.brings_solids()) return 0;
  return condition.brought(SolidsContinuity::unknown) * condition.velocity[segment.axis] * (segment.upper ? -1 : 1) *
         mean_of(condition.variation) * condition.variation.in_time(time);
}

/// Adds the times of a history, and those at which it passes zero, so that in between it is zero always or never, and
/// has its mean in the middle.
void add_cuts(const InletVariation& variation, std::set<double>& cuts) {
  const auto& [at, factor] = variation.history;
  if (variation.rise_time > 0) cuts.insert({variation.begin, variation.begin + variation.rise_time});
  cuts.insert(at.begin(), at.end());
  for (std::size_t i = 1; i < at.size(); ++i) {
    if (factor[i - 1] * factor[i] < 0)
      cuts.insert(at[i - 1] + (at[i] - at[i - 1]) * factor[i - 1] / (factor[i - 1] - factor[i]));
  }
}

/// Solids fraction that a place has at least from the start: profiles and tables count for nothing.
double initial_solids(const Case& the_case, const std::array<double, max_dim>& place) {
  const InitialRegion* region = the_case.solids_region(place);
  return region && !region->has_own_solids_fraction() ? region->uniform_solids_fraction() : 0;
}

std::vector<Patch> boxes_of(const std::vector<InitialRegion>& regions) {
  std::vector<Patch> boxes;
  for (const InitialRegion& region : regions) {
    Patch box;
    box.lower = region.lower;
    box.upper = region.upper;
    boxes.push_back(box);
  }
  return boxes;
}

/// A plate that slides, with edges on the grid planes at which it opens and closes faces.
Plate on_planes(Plate plate, const Box& box) {
  const std::vector<double>& faces = box.faces[plate.slide_axis];
  const auto nearest = [&](double edge) {
    double plane = faces.front();
    for (std::size_t i = 1; i < faces.size(); ++i)
      if (0.5 * (faces[i - 1] + faces[i]) < edge) plane = faces[i];
    return plane;
  };
  std::vector<Patch*> patches{&plate.span};
  for (Patch& opening : plate.openings) patches.push_back(&opening);
  for (Patch* patch : patches) {
    patch->lower[plate.slide_axis] = nearest(patch->lower[plate.slide_axis]);
    patch->upper[plate.slide_axis] = nearest(patch->upper[plate.slide_axis]);
  }
  return plate;
}

std::vector<Plate> plates_at(const Case& the_case, double time) {
  std::vector<Plate> plates;
  for (const Plate& plate : the_case.plates) {
    if (!plate.present(time)) continue;
    plates.push_back(plate.slides() ? on_planes(plate.at(time), the_case.box) : plate);
  }
  return plates;
}

/// Whether plates come, go or slide.
bool plates_change(const Case& the_case) {
  return std::any_of(the_case.plates.begin(), the_case.plates.end(), [](const Plate& plate) {
    return plate.slides() || std::isfinite(plate.condition.from) || std::isfinite(plate.condition.until);
  });
}

/// Times between which nothing comes, goes or turns.
std::set<double> cuts_of(const Case& the_case) {
  std::set<double> cuts{0.0, the_case.time.end_time > 0 ? the_case.time.end_time : 1.0};
  for (const Segment& segment : the_case.segments) {
    cuts.insert({segment.condition.from, segment.condition.until});
    add_cuts(segment.condition.variation, cuts);
    add_cuts(segment.condition.gas_variation, cuts);
  }
  for (const Plate& plate : the_case.plates) {
    const std::vector<double>& faces = the_case.box.faces[plate.slide_axis];
    std::vector<double> centres;
    for (std::size_t i = 1; i < faces.size(); ++i) centres.push_back(0.5 * (faces[i - 1] + faces[i]));
    const std::vector<double> events = plate.events(centres);
    cuts.insert(events.begin(), events.end());
  }
  return cuts;
}

std::vector<double> times_of(const Case& the_case) {
  return middles(cuts_of(the_case), 0.0, the_case.time.end_time > 0 ? the_case.time.end_time : 1.0);
}

/// The connected parts of the box with some plates, and what bounds each in time.
class WaysOut {
 public:
  WaysOut(const Case& the_case, const std::vector<Plate>& plates)
      : case_(the_case), parts_(the_case.box, the_case.segments, plates, boxes_of(the_case.initial)) {
    for (int axis = 0; axis < the_case.box.dim; ++axis) {
      for (const bool upper : {false, true}) sides_[axis][upper] = segments_of_side(the_case.segments, axis, upper);
    }
    for (const Block& block : parts_.blocks())
      if (block.part >= static_cast<int>(places_.size())) places_.push_back(block.centre);
  }

  /// Gas cannot be compressed: a part into which gas or particles come needs an open side at all times.
  void check_gas(const std::vector<double>& times) const {
    for (const double time : times) {
      for (int part = 0; part < parts_.count(); ++part) {
        const std::vector<Exposed> bounds = bounds_of(part, time);
        if (has_side(bounds, &BoundaryKind::open_to_gas)) continue;
        const std::string expected =
            "an open side, where the gas can leave; there is none at time " + number_text(time) + " s" + around(part);
        for (const auto& [segment, area] : bounds) {
          const std::string key = "boundary_" + segment->condition.name + "_";
          if (brings_gas_at(*segment, time))
            throw InputError(key + "gas_velocity", number_text(segment->condition.gas_velocity) + " m/s", expected);
          if (particle_inflow(*segment, time) != 0) throw velocity_error(*segment, expected);
        }
      }
    }
  }

  /// Without gas: particles fill a part that never lets them out; they have to find room until the end.
  void check_room() const {
    const std::set<double> cuts = cuts_of(case_);
    const std::vector<double> middle = times_of(case_);
    for (int part = 0; part < parts_.count(); ++part) {
      const Segment* inlet = nullptr;
      double inflow = 0;
      bool open = false;
      std::set<double>::const_iterator cut = cuts.lower_bound(0.0);
      for (const double time : middle) {
        const double duration = 2 * (time - *cut);
        ++cut;
        const std::vector<Exposed> bounds = bounds_of(part, time);
        open = open || has_side(bounds, &BoundaryKind::lets_solids_out);
        for (const auto& [segment, area] : bounds) {
          inflow += particle_inflow(*segment, time) * area * duration;
          if (particle_inflow(*segment, time) > 0) inlet = segment;
        }
      }
      const double room = room_in(part);
      if (!open && inlet && inflow > room * (1 + 1e-6))
        throw velocity_error(*inlet, "an open side, where particles can leave, or less of them: until " +
                                         number_text(case_.time.end_time) + " s they would take " +
                                         (room > 0 ? number_text(inflow / room, 3) + " times" : "more than") +
                                         " the room that is left" + around(part));
    }
  }

 private:
  std::vector<Exposed> bounds_of(int part, double time) const {
    std::vector<Exposed> found;
    for (const SideFace& face : parts_.side_faces()) {
      if (face.part != part) continue;
      const Segment* segment = holding(sides_[face.axis][face.upper], face.centre, case_.box.dim, time);
      if (segment) found.push_back({segment, face.area});
    }
    return found;
  }

  /// Whether a kind among them answers yes.
  static bool has_side(const std::vector<Exposed>& bounds, bool (BoundaryKind::*asked)() const) {
    return std::any_of(bounds.begin(), bounds.end(),
                       [&](const Exposed& exposed) { return (exposed.segment->condition.kind.*asked)(); });
  }

  double room_in(int part) const {
    double room = 0;
    for (const Block& block : parts_.blocks())
      if (block.part == part) room += block.volume * (case_.kinetic.nu_max - initial_solids(case_, block.centre));
    return room;
  }

  /// Which part, where there are several.
  std::string around(int part) const {
    if (parts_.count() == 1) return "";
    std::string place;
    for (int axis = 0; axis < case_.box.dim; ++axis)
      place += (axis ? ", " : "") + number_text(places_[static_cast<std::size_t>(part)][axis], 4);
    return " in the part of the box around (" + place + ") m, which plates close off";
  }

  static InputError velocity_error(const Segment& segment, const std::string& expected) {
    return InputError("boundary_" + segment.condition.name + "_velocity",
                      number_text(segment.condition.velocity[segment.axis]) + " m/s", expected);
  }

  const Case& case_;
  const ConnectedParts parts_;
  std::array<std::array<std::vector<Segment>, 2>, max_dim> sides_;
  std::vector<std::array<double, max_dim>> places_;  ///< one in each part
};

}  // namespace

void check_ways_out(const Case& the_case) {
  if (the_case.gas.model == GasModel::none) {
    // Particles in parts that open later find their way then.
    if (the_case.model.solids_moving && the_case.time.end_time > 0 && !plates_change(the_case))
      WaysOut(the_case, the_case.plates).check_room();
  } else if (!plates_change(the_case)) {
    WaysOut(the_case, the_case.plates).check_gas(times_of(the_case));
  } else {
    for (const double time : times_of(the_case)) WaysOut(the_case, plates_at(the_case, time)).check_gas({time});
  }
}

}  // namespace scree
