#include "scree/config/case_options.hpp"

namespace scree {

void declare_model(OptionSet& o, int dim, ModelParameters& model) {
  o.group("model");
  o.vector("gravity", model.gravity, dim, "m/s2", "acceleration of gravity").symbol("g");
  o.vector("vibration_amplitude", model.vibration_amplitude, dim, "m",
           "the box moves as amplitude sin(2 pi frequency t); velocities are those in the box");
  o.real("vibration_frequency", model.vibration_frequency, "Hz", non_negative(), "frequency of that motion");
  o.choice("solids", model.solids_moving, {{"moving", true}, {"fixed", false}},
           "fixed: solids fraction and velocity stay as they are initially");
  o.choice("granular_temperature", model.temperature,
           {{"transport", TemperatureModel::transport},
            {"algebraic", TemperatureModel::algebraic},
            {"constant", TemperatureModel::constant}},
           "balance of pseudo-thermal energy: (9), or production = dissipation, or a given value")
      .symbol("T");
  const bool constant = model.temperature == TemperatureModel::constant;
  o.real("granular_temperature_value", model.temperature_value, "m2/s2", non_negative(),
         "the value under granular_temperature constant")
      .symbol("T")
      .used_if(constant, "granular_temperature is not constant");
  o.real("granular_temperature_floor", model.temperature_floor, "m2/s2", non_negative(),
         "added to T under square roots");
  o.choice("advection", model.advection,
           {{"upwind", AdvectionScheme::upwind}, {"van_albada", AdvectionScheme::van_albada}}, "scheme of advection");
  o.real("solids_fraction_floor", model.solids_fraction_floor, "-", positive(),
         "added to nu in inertia and storage, and in the void drag eps rho_s v/t_d");
  o.real("void_drag_time", model.void_drag_time, "s", positive(), "t_d of that drag");
}

}  // namespace scree
