#include "scree/closures/rheology.hpp"
#include "scree/config/case_options.hpp"

namespace scree {

std::string option_unit(const Unknown& unknown) { return unknown.unit == std::string("1") ? "-" : unknown.unit; }

Range range_of(Allowed allowed, const Case& the_case) {
  switch (allowed) {
    case Allowed::solids_fraction:
      return from_zero_below(the_case.kinetic.nu_max, "solids_fraction_max");
    case Allowed::non_negative:
      return non_negative();
    case Allowed::positive:
      return positive();
    default:
      return any_number();
  }
}

std::string absence(const Case& the_case, const Unknown& unknown) {
  if (&unknown == &GranularEnergy::unknown && the_case.model.temperature != TemperatureModel::transport)
    return "granular_temperature is not transport";
  if (&unknown == &FrictionRelaxation::unknown && !the_case.friction.model->has_unknown)
    return "friction_model is not relaxed";
  if (&unknown == &Fluidity::unknown && !has_fluidity(the_case.friction)) return "friction_coefficient is not fluidity";
  if (&unknown == &GasMomentum::unknown && the_case.gas.model != GasModel::incompressible)
    return "gas is not incompressible";
  return "";
}

}  // namespace scree
