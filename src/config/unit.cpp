#include "scree/config/unit.hpp"

#include <cmath>
#include <cstdlib>

#include "scree/config/quantity.hpp"

namespace scree {
namespace {

Unit owned(ut_unit* unit, const std::string& what) {
  if (!unit) throw QuantityError(what);
  return Unit(unit, ut_free);
}

void add_alias(ut_system* units, const char* alias, const char* name) {
  ut_unit* unit = ut_parse(units, name, UT_ASCII);
  if (unit) ut_map_name_to_unit(alias, UT_ASCII, unit);
  ut_free(unit);
}

/// UDUNITS' database, read once.
ut_system* unit_system() {
  static const auto units = [] {
    ut_set_error_message_handler(ut_ignore);
    std::unique_ptr<ut_system, decltype(&ut_free_system)> system(ut_read_xml(nullptr), ut_free_system);
    if (!system) throw std::runtime_error("cannot read the units database of UDUNITS-2 (package libudunits2-data)");
    add_alias(system.get(), "dyn", "dyne");
    add_alias(system.get(), "deg", "arc_degree");
    return system;
  }();
  return units.get();
}

/// The nearest number of 15 digits if it is as good as `x`, so that 1.4 cm is 0.014 m and not the number below it.
double without_rounding_noise(double x) {
  const double neat = std::strtod(number_text(x, 15).c_str(), nullptr);
  return std::abs(neat - x) < 4e-16 * std::abs(x) ? neat : x;
}

}  // namespace

Unit parse_unit(const std::string& name) {
  return owned(ut_parse(unit_system(), name.c_str(), UT_UTF8), "'" + name + "' is not a known unit");
}

Unit unit_product(const Unit& a, const Unit& b) { return owned(ut_multiply(a.get(), b.get()), "bad product of units"); }

Unit unit_quotient(const Unit& a, const Unit& b) { return owned(ut_divide(a.get(), b.get()), "bad quotient of units"); }

double converted(double value, const Unit& from, const Unit& to) {
  const std::unique_ptr<cv_converter, decltype(&cv_free)> convert(ut_get_converter(from.get(), to.get()), cv_free);
  if (!convert) throw QuantityError("its unit has another dimension");
  return without_rounding_noise(cv_convert_double(convert.get(), value));
}

}  // namespace scree
