#include <algorithm>
#include <set>

#include "scree/config/case_options.hpp"
#include "scree/config/side_samples.hpp"

namespace scree {
namespace {

std::string list_text(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ", ") + number_text(value);
  return text;
}

/// `key` is that of the lists without "at" and "factor".
void check_ramp(const std::string& key, const Ramp& ramp) {
  const auto entries = [](const std::vector<double>& list) {
    return std::to_string(list.size()) + (list.size() == 1 ? " entry" : " entries");
  };
  if (ramp.at.empty() && !ramp.factor.empty())
    throw InputError(key + "at", "", entries(ramp.factor) + ", as many as " + key + "factor has");
  if (ramp.factor.size() != ramp.at.size())
    throw InputError(key + "factor", list_text(ramp.factor), entries(ramp.at) + ", as many as " + key + "at has");
  const auto wrong = std::adjacent_find(ramp.at.begin(), ramp.at.end(), [](double a, double b) { return !(a < b); });
  if (wrong != ramp.at.end())
    throw InputError(key + "at", list_text(ramp.at),
                     "ascending numbers, but " + number_text(wrong[1]) + " follows " + number_text(wrong[0]));
}

void check_condition(const Case& scene, const Segment& segment) {
  const Condition& condition = segment.condition;
  const std::string key = "boundary_" + condition.name + "_";
  if (condition.kind.brings_gas() && !condition.kind.brings_solids() && scene.gas.model == GasModel::none)
    throw InputError(key + "kind", std::string(condition.kind.name),
                     "gas darcy or incompressible with this kind, but gas is none");
  check_ramp(key + "gas_profile_", condition.gas_profile);
  check_ramp(key + "gas_history_", condition.gas_history);
  if (!condition.gas_profile.at.empty() && condition.gas_profile_axis == segment.axis)
    throw InputError(key + "gas_profile_axis", axis_names[segment.axis],
                     "an axis along the side " + side_name(segment.axis, segment.upper) + ", not the one normal to it");
}

bool brings_gas_at(const Segment& segment, double time) {
  const Condition& condition = segment.condition;
  if (!condition.kind.brings_gas()) return false;
  const std::vector<double>& factors = condition.gas_profile.factor;
  const bool profile =
      factors.empty() || std::any_of(factors.begin(), factors.end(), [](double factor) { return factor != 0; });
  return profile && condition.gas_velocity != 0 && condition.gas_history.value(time) != 0;
}

/// Particles that come in displace as much gas.
bool brings_particles(const Segment& segment) {
  const Condition& condition = segment.condition;
  return condition.kind.brings_solids() && condition.brought(SolidsContinuity::unknown) != 0 &&
         condition.velocity[segment.axis] != 0;
}

/// The segments that hold somewhere on the sides at a time.
std::vector<const Segment*> all_holding(const Box& box, const std::vector<std::vector<Segment>>& sides, double time) {
  std::vector<const Segment*> found;
  for (const std::vector<Segment>& side : sides) {
    if (side.empty()) continue;
    for (const auto& point : side_samples(box, side[0].axis, side)) {
      if (const Segment* segment = holding(side, point, box.dim, time)) found.push_back(segment);
    }
  }
  return found;
}

/// Adds the times of a history, and those at which it passes zero, so that in between it is zero always or never.
void add_cuts(const Ramp& history, std::set<double>& cuts) {
  const auto& [at, factor] = history;
  cuts.insert(at.begin(), at.end());
  for (std::size_t i = 1; i < at.size(); ++i) {
    if (factor[i - 1] * factor[i] < 0)
      cuts.insert(at[i - 1] + (at[i] - at[i - 1]) * factor[i - 1] / (factor[i - 1] - factor[i]));
  }
}

/// Neither gas nor particles can be compressed: what comes in needs an open side at all times.
void check_way_out(const Case& scene) {
  std::set<double> cuts;
  std::vector<std::vector<Segment>> sides;
  for (int axis = 0; axis < scene.box.dim; ++axis) {
    for (const bool upper : {false, true}) sides.push_back(segments_of_side(scene.segments, axis, upper));
  }
  for (const Segment& segment : scene.segments) {
    const Condition& condition = segment.condition;
    cuts.insert({condition.from, condition.until});
    add_cuts(condition.gas_history, cuts);
  }
  for (const double time : middles(cuts, 0.0, scene.time.end_time > 0 ? scene.time.end_time : 1.0)) {
    const std::vector<const Segment*> present = all_holding(scene.box, sides, time);
    const auto is_open = [](const Segment* s) { return s->condition.kind.open_to_gas(); };
    if (std::any_of(present.begin(), present.end(), is_open)) continue;
    const std::string expected =
        "an open side, where the gas can leave; there is none at time " + number_text(time) + " s";
    for (const Segment* segment : present) {
      const std::string key = "boundary_" + segment->condition.name + "_";
      if (brings_gas_at(*segment, time))
        throw InputError(key + "gas_velocity", number_text(segment->condition.gas_velocity) + " m/s", expected);
      if (brings_particles(*segment))
        throw InputError(key + "velocity", number_text(segment->condition.velocity[segment->axis]) + " m/s", expected);
    }
  }
}

}  // namespace

void check_gas(const Case& scene) {
  for (const Segment& segment : scene.segments) check_condition(scene, segment);
  if (scene.gas.model != GasModel::none) check_way_out(scene);
}

}  // namespace scree
