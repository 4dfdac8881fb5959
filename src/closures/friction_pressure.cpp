#include "scree/closures/friction_pressure.hpp"

#include "scree/closures/friction_pressure/power.hpp"
#include "scree/closures/friction_pressure/schaeffer.hpp"

namespace scree {

const FrictionPressure* default_friction_pressure() { return &friction_pressure_entry<PowerPressure>; }

Variants<FrictionPressure>& friction_pressures() {
  static Variants<FrictionPressure> all{&friction_pressure_entry<PowerPressure>,
                                        &friction_pressure_entry<SchaefferPressure>};
  return all;
}

}  // namespace scree
