/// Units of measurement by UDUNITS-2, with the names its database lacks.
#pragma once

#include <udunits2.h>

#include <memory>
#include <string>

namespace scree {

using Unit = std::shared_ptr<ut_unit>;

/// The unit called `name`, such as "m2/s2" or "g/(cm s)". Throws QuantityError if there is none.
Unit parse_unit(const std::string& name);

Unit unit_product(const Unit& a, const Unit& b);
Unit unit_quotient(const Unit& a, const Unit& b);

/// `value` in `from` expressed in `to`.
/// Throws QuantityError if the dimensions differ.
double converted(double value, const Unit& from, const Unit& to);

}  // namespace scree
