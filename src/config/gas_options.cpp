#include "scree/closures/drag.hpp"
#include "scree/config/case_options.hpp"
#include "scree/config/variant_choices.hpp"

namespace scree {

void declare_gas(OptionSet& o, int dim, Case& the_case) {
  o.group("gas");
  GasParameters& gas = the_case.gas;
  ModelParameters& model = the_case.model;
  o.choice(
      "gas", gas.model,
      {{"none", GasModel::none}, {"darcy", GasModel::darcy}, {"incompressible", GasModel::incompressible}},
      "gas phase: absent; (2) and (4) without gas inertia, u eliminated on each face, so that p_g alone is an "
      "unknown; (2) and (4) in full. darcy is good enough where the gas answers drag at once, i.e. its response time "
      "rho_g (1-nu)/beta (at nu 0.6: 2e-6 s for 100 um, 4e-5 s for 400 um, 2e-4 s for 1 mm in air) is short against "
      "the "
      "time in which the flow changes. Measured against incompressible: discharge rate of 1 mm 0.0 %, of 100 um 0.5 %, "
      "place of a bubble in 400 um 1 %; the pressure deficit over the orifice of 100 um 9 % off, since voids have the "
      "drag of gas_darcy_solids_fraction. Not for jets and freeboards");
  const bool some = gas.model != GasModel::none;
  const std::string absent = "gas is none";
  o.real("gas_density", gas.rho_g, "kg/m3", positive(), "density of the gas, constant")
      .symbol("rho_g")
      .used_if(some, absent);
  o.real("gas_viscosity", gas.mu_g, "Pa s", positive(), "viscosity of the gas").symbol("mu_g").used_if(some, absent);
  o.choice("drag_law", gas.drag_law, variant_choices(drag_laws()), variant_text("drag of the gas", drag_laws()))
      .symbol("beta")
      .used_if(some, absent);
  o.boolean("gas_viscous_stress", model.gas_viscous_stress, "sigma_g of (5) with its viscous part; no: sigma_g = p_g I")
      .symbol("sigma_g")
      .used_if(gas.model == GasModel::incompressible, "gas is not incompressible");
  o.vector("mean_pressure_gradient", model.mean_pressure_gradient, dim, "Pa/m",
           "part of grad p_g that drives the gas along periodic axes, where p_g itself is periodic; negative: upwards "
           "along the axis")
      .symbol("grad p_g")
      .used_if(some, absent);
  HeldGasFlow& flow = the_case.gas_flow;
  flow.held = o.vector("mean_gas_velocity", flow.velocity, dim, "m/s",
                       "superficial velocity of the gas, mean over the box, that is held along periodic axes: after "
                       "each step the mean pressure gradient is adjusted, from mean_pressure_gradient on")
                  .symbol("(1-nu) u")
                  .unset_by_default("not held")
                  .used_if(some, absent)
                  .given;
  o.real("gas_darcy_solids_fraction", model.darcy_solids_fraction, "-",
         above_zero_below(the_case.kinetic.nu_max, "solids_fraction_max"),
         "gas darcy: drag in voids is that of this solids fraction")
      .symbol("nu")
      .used_if(gas.model == GasModel::darcy, "gas is not darcy");
}

}  // namespace scree
