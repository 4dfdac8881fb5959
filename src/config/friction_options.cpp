#include <cmath>

#include "scree/closures/friction_pressure/power.hpp"
#include "scree/closures/rheology.hpp"
#include "scree/config/case_options.hpp"
#include "scree/config/variant_choices.hpp"

namespace scree {

namespace {

/// Of friction_coefficient fluidity.
void declare_fluidity(OptionSet& o, FluidityParameters& fluidity, const std::string& absent) {
  const bool used = absent.empty();
  o.real("friction_fluidity_amplitude", fluidity.A, "-", non_negative(),
         "nonlocal amplitude: fluidity spreads over A d/sqrt(|sin(friction_angle) - M|); 0: mu(I) in each cell for "
         "itself. 0.48 are glass beads, Henann & Kamrin (2013)")
      .symbol("A")
      .used_if(used, absent);
  o.real("friction_fluidity_slope", fluidity.b, "-", non_negative(),
         "slope of M over the inertial number in uniform shear. 0.9377 are glass beads, Henann & Kamrin (2014)")
      .symbol("b")
      .used_if(used, absent);
  o.real("friction_fluidity_time", fluidity.t_0, "s", positive(),
         "t_0 of the balance of fluidity; Henann & Kamrin (2014) take 1e-4 to 1e-3 s")
      .symbol("t_0")
      .used_if(used, absent);
  o.real("friction_fluidity_at_rest", fluidity.g_min, "1/s", positive(),
         "fluidity of a bed that does not shear, which says how fast it creeps: the rate of shear over M")
      .symbol("g_min")
      .used_if(used, absent);
  o.choice("friction_fluidity_rough_wall", fluidity.held_at_rough, {{"held", true}, {"free", false}},
           "held: walls without slip hold the fluidity at friction_fluidity_wall, as grains that are glued to them do "
           "(Kamrin & Henann 2015); free: none passes through them, as through all other sides")
      .used_if(used, absent);
  fluidity.at_rough = fluidity.g_min;
  o.real("friction_fluidity_wall", fluidity.at_rough, "1/s", positive(), "fluidity at walls without slip")
      .default_from("friction_fluidity_at_rest")
      .used_if(used && fluidity.held_at_rough, used ? "friction_fluidity_rough_wall is free" : absent);
}

}  // namespace

void declare_friction(OptionSet& o, FrictionParameters& friction, TemperatureModel temperature,
                      KineticParameters& kinetic) {
  o.group("friction");
  OptionSet::Choices<FrictionModel> models;
  for (const FrictionModel model : friction_models()) models.emplace_back(model->name, model);
  o.choice("friction_model", friction.model, models, variant_text("frictional stress", friction_models()));
  const bool some = friction.model->has_friction;
  const bool with_chi = friction.model->uses_flow_rule;
  const std::string absent = "friction_model is none";
  const std::string no_chi = "friction_model is neither relaxed nor instantaneous";

  o.real("friction_tau", friction.tau, "s", positive(), "relaxation time of chi, eq. (23)")
      .symbol("tau")
      .used_if(friction.model->has_unknown, "friction_model is not relaxed");
  o.boolean(
       "friction_lagged", friction.lagged,
       "for studies, with fixed steps of beuler: chi of a step is taken from the state before it, through (21) or a "
       "step of (23) without advection, as segregated codes have it")
      .used_if(with_chi, no_chi);
  o.real("friction_angle", friction.phi, "rad", positive_angle(), "angle of internal friction, eq. (14)")
      .symbol("phi")
      .used_if(some, absent);
  o.choice("friction_coefficient", friction.coefficient,
           {{"constant", FrictionCoefficient::constant},
            {"mu_i", FrictionCoefficient::mu_i},
            {"cidr", FrictionCoefficient::cidr},
            {"mu_i_regularised", FrictionCoefficient::mu_i_regularised},
            {"fluidity", FrictionCoefficient::fluidity}},
           "M of (14) and (20). constant: sin(friction_angle); mu_i: M(I) of Jop, Forterre & Pouliquen (2006) from "
           "sin(friction_angle) to friction_coefficient_limit, with the flow rule (13); cidr: with the flow rule that "
           "Barker et al. (2017) ask for, which is well-posed; mu_i_regularised: as mu_i, with the M of Barker & "
           "Gray (2017) in slow and fast flow. I has the strain rate of (20). mu_i and cidr are one under "
           "critical_state. fluidity: the rate of shear over a fluidity with a balance of its own, the nonlocal "
           "friction of Henann & Kamrin (2013), where M of slow flow is sin(friction_angle) and not its tangent; in "
           "two dimensions without gas, with friction_model relaxed")
      .symbol("M")
      .used_if(some, absent);
  if (!some) friction.coefficient = FrictionCoefficient::constant;  // no fluidity without friction
  const bool inertial = some && has_inertial_coefficient(friction), nonlocal = some && has_fluidity(friction);
  const std::string no_inertia =
      some ? std::string("friction_coefficient is ") + (nonlocal ? "fluidity" : "constant") : absent;
  o.real("friction_coefficient_limit", friction.mu_2, "-", positive(), "M(I) of fast flow")
      .symbol("mu_2")
      .used_if(inertial, no_inertia);
  o.real("friction_inertial_number", friction.I_0, "-", positive(), "I at which M(I) is half way to its limit")
      .symbol("I_0")
      .used_if(inertial, no_inertia);
  declare_fluidity(o, friction.fluidity, nonlocal ? "" : some ? "friction_coefficient is not fluidity" : absent);
  friction.n_dilation = std::sqrt(3.0) / (2 * std::sin(friction.phi));
  o.real("friction_exponent_dilation", friction.n_dilation, "-", greater_than_one(), "n of (14) where div v >= 0")
      .symbol("n")
      .default_from("sqrt(3)/(2 sin friction_angle)")
      .used_if(with_chi, no_chi);
  o.real("friction_exponent_compaction", friction.n_compaction, "-", greater_than_one(), "n of (14) where div v < 0")
      .symbol("n")
      .used_if(with_chi, no_chi);
  o.choice("friction_pressure", friction.pressure, variant_choices(friction_pressures()),
           variant_text("critical-state pressure p_c(nu)", friction_pressures()))
      .symbol("p_c")
      .used_if(some, absent);
  const bool power = some && friction.pressure == &friction_pressure_entry<PowerPressure>;
  const std::string no_power = some ? "friction_pressure is not power" : absent;
  o.real("friction_pressure_constant", friction.F, "Pa", positive(), "constant of p_c, eq. (18)")
      .symbol("F")
      .used_if(power, no_power);
  o.real("friction_pressure_exponent_r", friction.r, "-", positive(), "exponent of nu - nu_min in (18)")
      .symbol("r")
      .used_if(power, no_power);
  o.real("friction_pressure_exponent_s", friction.s, "-", positive(), "exponent of nu_max - nu in (18)")
      .symbol("s")
      .used_if(power, no_power);
  o.real("friction_solids_fraction_min", friction.nu_min, "-", from_zero_below(friction.nu_max, "solids_fraction_max"),
         "solids fraction from which p_c acts, eq. (18)")
      .symbol("nu_min")
      .used_if(some, absent);
  bool with_fluctuation = !nonlocal;
  o.boolean("friction_strain_rate_fluctuation", with_fluctuation,
            "S:S + T/d^2 as in (20)-(22); no: S:S as in (15)-(17); friction_fluctuation 1 or 0 in words")
      .default_from("yes, or no where friction_coefficient is fluidity")
      .used_if(some, absent);
  friction.fluctuation = with_fluctuation ? 1 : 0;
  o.real("friction_fluctuation", friction.fluctuation, "-", from_zero_to_one(),
         "c of S:S + c T/d^2, the share of the fluctuations in the strain rate of friction: 1 as in (20)-(22), 0 as in "
         "(15)-(17)")
      .symbol("c")
      .default_from("1, or 0 where friction_strain_rate_fluctuation is no")
      .used_if(some, absent);
  o.real("friction_strain_rate_floor", friction.strain_rate_floor, "1/s", non_negative(),
         "floor^2 is added under sqrt(S:S + c T/d^2)")
      .used_if(some, absent);
  friction.flow_rule_floor = friction.fluctuation < 1 ? 1 : 0;
  o.real(
       "friction_flow_rule_floor", friction.flow_rule_floor, "1/s", non_negative(),
       "floor^2 is added under sqrt(S:S + c T/d^2 + eps^2) in the flow rule (21): a bed that shears more slowly is at "
       "its critical state")
      .default_from("1 1/s where friction_fluctuation is below 1, else 0")
      .used_if(with_chi, no_chi);

  // Here, because the default depends on friction: without it collisions alone hold up a packed bed.
  const bool transported = temperature == TemperatureModel::transport;
  kinetic.T_rest = transported && !some ? 1e-6 : 0;
  o.real("granular_temperature_at_rest", kinetic.T_rest, "m2/s2", non_negative(),
         "T that collisions leave near nu_max: in (1.4) T - T_rest (nu/nu_max)^32 in place of the first T")
      .symbol("T_rest")
      .default_from("1e-6 without friction, else 0")
      .used_if(transported, "granular_temperature is not transport");
  if (!transported) kinetic.T_rest = 0;  // elsewhere T is not what is left of it
}

}  // namespace scree
