#include <algorithm>

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

void check_variation(const std::string& key, const Segment& segment, const InletVariation& variation) {
  check_ramp(key + "profile_", variation.profile);
  check_ramp(key + "history_", variation.history);
  if (!variation.profile.at.empty() && variation.axis == segment.axis)
    throw InputError(key + "profile_axis", axis_names[segment.axis],
                     "an axis along the side " + side_name(segment.axis, segment.upper) + ", not the one normal to it");
}

void check_condition(const Case& the_case, const Segment& segment) {
  const Condition& condition = segment.condition;
  const std::string key = "boundary_" + condition.name + "_";
  if (condition.kind.brings_gas() && !condition.kind.brings_solids() && the_case.gas.model == GasModel::none)
    throw InputError(key + "kind", std::string(condition.kind.name),
                     "gas darcy or incompressible with this kind, but gas is none");
  check_variation(key, segment, condition.variation);
  check_variation(key + "gas_", segment, condition.gas_variation);
}

/// Along other axes sides decide.
void check_periodic(const Case& the_case, const std::string& key, const std::string& unit,
                    const std::array<double, max_dim>& values) {
  for (int axis = 0; axis < the_case.box.dim; ++axis)
    if (values[axis] != 0 && !the_case.box.periodic[axis])
      throw InputError(key, number_text(values[axis]) + " " + unit + " along " + axis_names[axis],
                       std::string("0 along ") + axis_names[axis] + ", or periodic " + axis_names[axis]);
}

}  // namespace

void check_gas(const Case& the_case) {
  if (the_case.gas.model != GasModel::none) {
    check_periodic(the_case, "mean_pressure_gradient", "Pa/m", the_case.model.mean_pressure_gradient);
    check_periodic(the_case, "mean_gas_velocity", "m/s", the_case.gas_flow.velocity);
  }
  for (const Segment& segment : the_case.segments) check_condition(the_case, segment);
}

}  // namespace scree
