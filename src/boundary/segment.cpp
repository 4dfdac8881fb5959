#include "scree/boundary/segment.hpp"

#include <algorithm>
#include <cmath>

namespace scree {

namespace {

/// Of an event's time: what has happened by then counts as done, whatever the rounding.
constexpr double just_after = 1e-9;

void move(Patch& patch, int axis, double distance) {
  patch.lower[axis] += distance;
  patch.upper[axis] += distance;
}

}  // namespace

double gas_inflow(const Condition& condition, const FaceExtent& face, double time) {
  return condition.gas_velocity * condition.gas_variation.value(face, time);
}

double solids_velocity(const Condition& condition, int axis, const FaceExtent& face, double time) {
  const double factor = condition.kind.brings_solids() ? condition.variation.value(face, time) : 1;
  return condition.velocity[axis] * factor;
}

Plate Plate::at(double time) const {
  Plate moved = *this;
  if (!slides() || time < slide_from) return moved;
  const double seconds = std::min(time, slide_until) - slide_from;
  const double distance = slide_speed * (seconds + just_after * std::max(seconds, 1e-3));
  move(moved.span, slide_axis, distance);
  for (Patch& opening : moved.openings) move(opening, slide_axis, distance);
  if (time < slide_until) moved.condition.velocity[slide_axis] += slide_speed;
  return moved;
}

std::vector<double> Plate::events(const std::vector<double>& centres) const {
  std::vector<double> times{condition.from, condition.until};
  if (slides()) {
    times.insert(times.end(), {slide_from, slide_until});
    std::vector<Patch> patches = openings;
    patches.push_back(span);
    for (const Patch& patch : patches)
      for (const double edge : {patch.lower[slide_axis], patch.upper[slide_axis]})
        for (const double centre : centres) {
          const double time = slide_from + (centre - edge) / slide_speed;
          if (time > slide_from && time < slide_until && time >= condition.from && time < condition.until)
            times.push_back(time);
        }
  }
  times.erase(std::remove_if(times.begin(), times.end(), [](double time) { return !std::isfinite(time); }),
              times.end());
  return times;
}

}  // namespace scree
