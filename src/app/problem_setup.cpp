#include "scree/app/problem_setup.hpp"

#include <cmath>
#include <limits>

namespace scree {

namespace {

/// Unless the case says otherwise V = sqrt(g d) and time V/g.
Scales scales_of(const Case& the_case) {
  double g = 0;
  for (const double component : the_case.model.gravity) g += component * component;
  g = std::sqrt(g);
  Scales scales;
  scales.velocity = the_case.scale_velocity > 0 ? the_case.scale_velocity
                    : g > 0                     ? std::sqrt(g * the_case.kinetic.d)
                                                : 0.1;
  scales.time = g > 0 ? scales.velocity / g : the_case.kinetic.d / scales.velocity;
  const bool particles = the_case.gas.model == GasModel::none || the_case.has_particles();
  scales.density = particles ? the_case.kinetic.rho_s : the_case.gas.rho_g;
  return scales;
}

}  // namespace

ProblemSetup problem_setup(const Case& the_case, const ModelFactory& models) {
  ProblemSetup setup;
  setup.models = models;
  setup.box = the_case.box;
  setup.segments = the_case.segments;
  setup.plates = the_case.plates;
  setup.model = the_case.model;
  setup.solids = {the_case.kinetic,
                  the_case.friction,
                  the_case.model.temperature,
                  the_case.model.temperature_value,
                  the_case.model.temperature_floor,
                  the_case.gas};
  if (the_case.friction.lagged && the_case.friction.model == FrictionModel::instantaneous) {
    setup.solids.friction.model = FrictionModel::relaxed;  // chi is kept, and does not relax
    setup.solids.friction.tau = std::numeric_limits<double>::min();
  }
  setup.scales = scales_of(the_case);
  return setup;
}

}  // namespace scree
