#include "scree/app/problem_setup.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scree/balances/layout.hpp"

namespace scree {

namespace {

/// Whether particles are there from the start or come in.
bool has_particles(const Case& scene) {
  const auto brings = [](const Segment& s) {
    return s.condition.kind.brings_solids() && s.condition.brought(SolidsContinuity::unknown) > 0;
  };
  const auto holds = [](const InitialRegion& r) {
    return r.has_own_solids_fraction() || r.uniform_solids_fraction() > 0;
  };
  return scene.gas.model == GasModel::none || std::any_of(scene.segments.begin(), scene.segments.end(), brings) ||
         std::any_of(scene.initial.begin(), scene.initial.end(), holds);
}

/// Unless the case says otherwise V = sqrt(g d) and time V/g.
Scales scales_of(const Case& scene) {
  double g = 0;
  for (const double component : scene.model.gravity) g += component * component;
  g = std::sqrt(g);
  Scales scales;
  scales.velocity = scene.scale_velocity > 0 ? scene.scale_velocity : g > 0 ? std::sqrt(g * scene.kinetic.d) : 0.1;
  scales.time = g > 0 ? scales.velocity / g : scene.kinetic.d / scales.velocity;
  scales.density = has_particles(scene) ? scene.kinetic.rho_s : scene.gas.rho_g;
  return scales;
}

}  // namespace

ProblemSetup problem_setup(const Case& scene, const ModelFactory& models) {
  ProblemSetup setup;
  setup.models = models;
  setup.box = scene.box;
  setup.segments = scene.segments;
  setup.plates = scene.plates;
  setup.model = scene.model;
  setup.solids = {scene.kinetic,
                  scene.friction,
                  scene.model.temperature,
                  scene.model.temperature_value,
                  scene.model.temperature_floor,
                  scene.gas};
  if (scene.friction.lagged && scene.friction.model == FrictionModel::instantaneous) {
    setup.solids.friction.model = FrictionModel::relaxed;  // chi is kept, and does not relax
    setup.solids.friction.tau = std::numeric_limits<double>::min();
  }
  setup.scales = scales_of(scene);
  return setup;
}

}  // namespace scree
