#include "scree/config/case_options.hpp"

namespace scree {
namespace {

OptionUse use_of_inflow(const Case& the_case, const Condition& condition) {
  if (the_case.gas.model == GasModel::none) return {false, "gas is none"};
  return {condition.kind.brings_gas(), "its kind is neither inlet nor gas_inlet"};
}

OptionUse use_of_pressure(const Case& the_case, const Condition& condition) {
  if (the_case.gas.model == GasModel::none) return {false, "gas is none"};
  return {condition.kind.gas_pressure == GasPressure::prescribed, "its kind is not open"};
}

OptionUse use_of_entry(const Case& the_case, const Condition& condition) {
  if (the_case.gas.model != GasModel::incompressible) return {false, "gas is not incompressible"};
  return {condition.kind.open_to_gas(), "its kind is not open"};
}

OptionUse use_of_wall(const Case& the_case, const Condition& condition) {
  if (the_case.gas.model != GasModel::incompressible) return {false, "gas is not incompressible"};
  if (!the_case.model.gas_viscous_stress) return {false, "gas_viscous_stress is no"};
  return {condition.kind.gas_tangential == GasTangential::wall, "its kind is not a wall"};
}

}  // namespace

void declare_gas_wall(OptionSet& o, const std::string& key, const Case& the_case, Condition& condition) {
  const OptionUse use = use_of_wall(the_case, condition);
  o.choice(key + "gas_wall", condition.gas_no_slip, {{"free_slip", false}, {"no_slip", true}},
           "whether the gas slips along the wall or sticks to it")
      .used_if(use.used, use.otherwise);
}

void declare_gas_side(OptionSet& o, const std::string& key, int dim, const Case& the_case, Segment& segment) {
  Condition& condition = segment.condition;
  const OptionUse inflow = use_of_inflow(the_case, condition), pressure = use_of_pressure(the_case, condition);
  OptionEntry& velocity = o.real(key + "gas_velocity", condition.gas_velocity, "m/s", any_number(),
                                 "superficial velocity of the gas that an inlet or gas_inlet brings into the box")
                              .symbol("(1-nu) u")
                              .default_from("0; required for a gas_inlet")
                              .used_if(inflow.used, inflow.otherwise);
  velocity.needed = inflow.used && !condition.kind.brings_solids();
  declare_variation(o, key, "gas_", dim, inflow, segment.axis, condition.gas_variation);
  o.real(key + "gas_pressure", condition.gas_pressure, "Pa", any_number(),
         "p_g outside of an open side, over that of still gas there")
      .symbol("p_g")
      .used_if(pressure.used, pressure.otherwise);
  const OptionUse entry = use_of_entry(the_case, condition);
  o.choice(key + "gas_entry", condition.gas_enters_at_rest, {{"at_rest", true}, {"developed", false}},
           "gas that comes in through an open side: at_rest: from still gas outside, at the cost of its dynamic head "
           "rho_g u^2/2; developed: as from a channel that goes on outside")
      .used_if(entry.used, entry.otherwise);
  declare_gas_wall(o, key, the_case, condition);
}

}  // namespace scree
