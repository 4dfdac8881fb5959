/// Texts of the case file as numbers in SI: units by UDUNITS-2, definitions, and + - * / with parentheses.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace scree {

/// Why a text is not the wanted quantity; OptionSet makes an InputError of it.
struct QuantityError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The text behind `${name}`, or nullptr.
using Definitions = std::function<const std::string*(const std::string& name)>;

/// The value of `text` in `unit`, for example quantity("1.4 cm", "m"), quantity("2*${width} + 1 mm", "m", definitions).
/// A number without a unit is taken to be in `unit`; in products it is a pure factor. Always finite.
/// Throws QuantityError for a malformed text, an unknown unit or one of another dimension.
double quantity(const std::string& text, const std::string& unit, const Definitions& definitions = {});

/// `text` with each `${name}` replaced by its definition. Throws QuantityError where there is none.
std::string with_definitions(std::string text, const Definitions& definitions);

/// The entries of a comma list, without surrounding blanks; empty for an empty text.
std::vector<std::string> split_list(const std::string& text);

/// The shortest decimal form that reads back as the same number; with `digits`, rounded to so many.
std::string number_text(double value, int digits = 0);

}  // namespace scree
