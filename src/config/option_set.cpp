#include "scree/config/option_set.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

namespace scree {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double right_angle = 1.57079632679489661923;

std::string joined(const std::vector<std::string>& items) {
  std::string text;
  for (const std::string& item : items) text += (text.empty() ? "" : ", ") + item;
  return text;
}

std::string list_text(const std::vector<double>& values) {
  std::vector<std::string> items;
  for (const double value : values) items.push_back(number_text(value));
  return items.empty() ? "" : "[" + joined(items) + "]";
}

std::string list_text(const std::vector<int>& values) {
  return list_text(std::vector<double>(values.begin(), values.end()));
}

std::string quoted_list(const std::vector<std::string>& values) {
  return values.empty() ? "" : yaml_quoted(joined(values));
}

std::string kind_of_number(const std::string& unit) {
  if (unit == "-") return "a number";
  if (unit == "rad") return "an angle in rad, or with a unit such as '28.5 deg'";
  return "a value in " + unit + " (or with a unit of that kind)";
}

std::string with_range(const std::string& kind, const Range& range) {
  return range.text.empty() ? kind : kind + ", " + range.text;
}

std::string in_degrees(double angle) { return number_text(angle * 90 / right_angle, 10) + " deg"; }

std::string count_text(const Count& count) {
  std::string number = count.number ? std::to_string(count.number) + " numbers" : "numbers";
  if (count.multiple) number = "a multiple of " + number;
  return "a list of " + number + (count.text.empty() ? "" : " (" + count.text + ")");
}

bool fits(const Count& count, std::size_t size) {
  if (count.number == 0) return size > 0;
  return count.multiple ? size > 0 && size % count.number == 0 : size == count.number;
}

}  // namespace

std::string yaml_quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("''") : std::string(1, c);
  return out + "'";
}

Range any_number() { return {}; }
Range positive() { return {0, infinity, false, true, "> 0"}; }
Range non_negative() { return {0, infinity, true, true, ">= 0"}; }
Range greater_than_one() { return {1, infinity, false, true, "> 1"}; }
Range angle_below_right() { return {0, right_angle, true, false, "in [0 deg, 90 deg)"}; }
Range positive_angle() { return {0, right_angle, false, false, "in (0 deg, 90 deg)"}; }
Range above_zero_to_one() { return {0, 1, false, true, "in (0, 1]"}; }
Range from_zero_to_one() { return {0, 1, true, true, "in [0, 1]"}; }

Range from_zero_below(double upper, const std::string& name) {
  return {0, upper, true, false, "in [0, " + name + " = " + number_text(upper) + ")"};
}

Range above_zero_below(double upper, const std::string& name) {
  return {0, upper, false, false, "in (0, " + name + " = " + number_text(upper) + ")"};
}

OptionEntry& OptionEntry::symbol(const std::string& name) {
  symbol_ = name;
  return *this;
}

OptionEntry& OptionEntry::used_if(bool used, const std::string& otherwise) {
  if (!used) unused_because = otherwise;
  return *this;
}

OptionEntry& OptionEntry::required() {
  needed = true;
  return unset_by_default("required");
}

OptionEntry& OptionEntry::unset_by_default(const std::string& words) {
  if (!given) value.clear();
  return default_from(words);
}

OptionEntry& OptionEntry::default_from(const std::string& words) {
  default_value = words;
  default_in_words = true;
  return *this;
}

OptionEntry& OptionSet::add(OptionEntry::Type type, const std::string& key, const std::string& unit,
                            const std::string& allowed, const std::string& text) {
  OptionEntry entry;
  entry.group = group_;
  entry.type = type;
  entry.key = key;
  entry.unit = unit;
  entry.allowed = allowed;
  entry.text = text;
  entries_.push_back(entry);
  return entries_.back();
}

const std::string* OptionSet::given(OptionEntry& entry) const {
  if (!input_ || mode_ == Mode::describe) return nullptr;
  const auto owner = owners_.find(entry.key);
  const bool of_another = owner != owners_.end() && owner->second != item_;  // a_gas + velocity, not a + gas_velocity
  const std::string* text = of_another ? nullptr : input_->find(entry.key);
  entry.given = text != nullptr;
  return text;
}

double OptionSet::number(const OptionEntry& entry, const std::string& text, const std::string& unit,
                         const Range& range) const {
  const std::string expected = with_range(kind_of_number(unit), range);
  try {
    const double value = quantity(text, unit == "-" ? "1" : unit, input_->definitions());
    if (range.contains(value)) return value;
  } catch (const QuantityError& error) {
    throw InputError(entry.key, text, expected + "; " + error.what());
  }
  throw InputError(entry.key, text, expected);
}

/// A text with its definitions filled in.
std::string OptionSet::word(const OptionEntry& entry, const std::string& text, const std::string& expected) const {
  try {
    return with_definitions(text, input_->definitions());
  } catch (const QuantityError& error) {
    throw InputError(entry.key, text, expected + "; " + error.what());
  }
}

int OptionSet::whole_number(const OptionEntry& entry, const std::string& text, int lower) const {
  const std::string expected = "a whole number >= " + std::to_string(lower);
  double value = 0;
  try {
    value = quantity(text, "1", input_->definitions());
  } catch (const QuantityError& error) {
    throw InputError(entry.key, text, expected + "; " + error.what());
  }
  const bool whole = std::abs(value - std::round(value)) < 1e-9 && std::abs(value) < 1e9;
  if (!whole || std::lround(value) < lower) throw InputError(entry.key, text, expected);
  return static_cast<int>(std::lround(value));
}

OptionEntry& OptionSet::real(const std::string& key, double& value, const std::string& unit, const Range& range,
                             const std::string& text) {
  OptionEntry& entry = add(OptionEntry::Type::real, key, unit, range.text.empty() ? "any" : range.text, text);
  entry.range = range;
  entry.default_value = unit == "rad" ? in_degrees(value) : number_text(value);
  if (const std::string* input = given(entry)) value = number(entry, *input, unit, range);
  entry.value = number_text(value);
  return entry;
}

OptionEntry& OptionSet::reals(const std::string& key, std::vector<double>& values, const Count& count,
                              const std::string& unit, const Range& range, const std::string& text) {
  OptionEntry& entry =
      add(OptionEntry::Type::real, key, unit, with_range(count.text.empty() ? "list" : count.text, range), text);
  entry.list = true;
  entry.range = range;
  entry.default_value = list_text(values);
  if (const std::string* input = given(entry)) {
    const std::vector<std::string> items = split_list(*input);
    if (!fits(count, items.size()))
      throw InputError(key, *input, count_text(count) + ", each " + with_range(kind_of_number(unit), range));
    values.clear();
    for (const std::string& item : items) {
      try {
        values.push_back(number(entry, item, unit, range));
      } catch (const InputError& error) {
        throw InputError(key, *input, count_text(count) + ", each " + error.expected + "; at '" + item + "'");
      }
    }
  }
  entry.value = list_text(values);
  return entry;
}

OptionEntry& OptionSet::vector(const std::string& key, std::array<double, max_dim>& values, int dim,
                               const std::string& unit, const std::string& text) {
  std::vector<double> list(values.begin(), values.begin() + dim);
  OptionEntry& entry = reals(key, list, {list.size(), false, "one per axis"}, unit, any_number(), text);
  std::copy(list.begin(), list.end(), values.begin());
  return entry;
}

OptionEntry& OptionSet::integer(const std::string& key, int& value, int lower, const std::string& text) {
  OptionEntry& entry = add(OptionEntry::Type::integer, key, "-", "whole, >= " + std::to_string(lower), text);
  entry.range.lower = lower;
  entry.default_value = std::to_string(value);
  if (const std::string* input = given(entry)) value = whole_number(entry, *input, lower);
  entry.value = std::to_string(value);
  return entry;
}

OptionEntry& OptionSet::integers(const std::string& key, std::vector<int>& values, const Count& count, int lower,
                                 const std::string& text) {
  OptionEntry& entry =
      add(OptionEntry::Type::integer, key, "-", count.text + ", whole, >= " + std::to_string(lower), text);
  entry.list = true;
  entry.range.lower = lower;
  entry.default_value = list_text(values);
  if (const std::string* input = given(entry)) {
    const std::vector<std::string> items = split_list(*input);
    if (!fits(count, items.size()))
      throw InputError(key, *input, count_text(count) + ", each a whole number >= " + std::to_string(lower));
    values.clear();
    for (const std::string& item : items) values.push_back(whole_number(entry, item, lower));
  }
  entry.value = list_text(values);
  return entry;
}

OptionEntry& OptionSet::boolean(const std::string& key, bool& value, const std::string& text) {
  static const std::set<std::string> yes{"", "yes", "true", "on", "1"}, no{"no", "false", "off", "0"};
  OptionEntry& entry = add(OptionEntry::Type::boolean, key, "-", "yes, no", text);
  entry.default_value = value ? "yes" : "no";
  if (const std::string* input = given(entry)) {
    const std::string expected = "yes or no (true/false, on/off, 1/0)", answer = word(entry, *input, expected);
    if (!yes.count(answer) && !no.count(answer)) throw InputError(key, *input, expected);
    value = yes.count(answer) > 0;
  }
  entry.value = value ? "yes" : "no";
  return entry;
}

OptionEntry& OptionSet::text(const std::string& key, std::string& value, const std::string& what,
                             const std::string& text) {
  OptionEntry& entry = add(OptionEntry::Type::text, key, "-", what, text);
  entry.default_value = value.empty() ? "none" : value;
  if (const std::string* input = given(entry)) {
    value = word(entry, *input, what);
  }
  entry.value = value.empty() ? "" : yaml_quoted(value);
  return entry;
}

OptionEntry& OptionSet::file(const std::string& key, std::string& value, const std::string& text) {
  namespace fs = std::filesystem;
  OptionEntry& entry = this->text(key, value, "a file", text);
  if (!entry.given || value.empty()) return entry;
  const std::string place = input_->place_of(key);  // file:line
  const fs::path path = fs::path(place.substr(0, place.rfind(':'))).parent_path() / value;
  std::error_code error;
  const fs::path absolute = fs::absolute(path, error);
  value = (error ? path : absolute).lexically_normal().string();
  entry.value = yaml_quoted(value);
  return entry;
}

OptionEntry& OptionSet::texts(const std::string& key, std::vector<std::string>& values, const std::string& what,
                              const std::string& text) {
  OptionEntry& entry = add(OptionEntry::Type::text, key, "-", what, text);
  entry.list = true;
  entry.default_value = values.empty() ? "none" : joined(values);
  if (const std::string* input = given(entry)) values = split_list(word(entry, *input, what));
  entry.value = quoted_list(values);
  return entry;
}

std::size_t OptionSet::choose(OptionEntry& entry, const std::vector<std::string>& words, std::size_t fallback) const {
  std::size_t chosen = fallback;
  entry.default_value = words[fallback];
  if (const std::string* input = given(entry)) {
    const std::string expected = (words.size() > 1 ? "one of " : "") + entry.allowed;
    const auto found = std::find(words.begin(), words.end(), word(entry, *input, expected));
    if (found == words.end()) throw InputError(entry.key, *input, expected);
    chosen = static_cast<std::size_t>(found - words.begin());
  }
  entry.value = words[chosen];
  return chosen;
}

std::vector<std::string> OptionSet::names(const std::string& section) {
  if (!input_) return {"<name>"};
  const auto begins = [](const std::string& key, const std::string& start) {
    return key.compare(0, start.size(), start) == 0;
  };
  const std::string start = section + "_";
  std::set<std::string> found;
  for (const auto& [key, given] : input_->entries()) {
    if (given.item.empty() || !begins(key, start + given.item + "_")) continue;
    found.insert(given.item);
    owners_[key] = given.item;
  }
  const std::set<std::string> nested = found;
  for (const auto& [key, given] : input_->entries()) {
    if (given.petsc_section || !begins(key, start) || owners_.count(key)) continue;
    const std::string name = name_in(section, key.substr(start.size()), nested);
    if (name.empty()) continue;
    found.insert(name);
    owners_[key] = name;
  }
  return {found.begin(), found.end()};
}

/// The name in `<name>_<attribute>`; empty if it does not end in an attribute.
std::string OptionSet::name_in(const std::string& section, const std::string& rest,
                               const std::set<std::string>& known) const {
  std::string shortest, longest_known;
  for (const std::string& attribute : sections_.at(section)) {
    const std::string end = "_" + attribute;
    if (rest.size() <= end.size() || rest.compare(rest.size() - end.size(), end.size(), end) != 0) continue;
    const std::string name = rest.substr(0, rest.size() - end.size());
    if (shortest.empty() || name.size() < shortest.size()) shortest = name;
    if (known.count(name) && name.size() > longest_known.size()) longest_known = name;
  }
  return longest_known.empty() ? shortest : longest_known;
}

void OptionSet::check_required() const {
  for (const OptionEntry& entry : entries_) {
    const std::string allowed = entry.unit == "-" ? entry.allowed : entry.allowed + " [" + entry.unit + "]";
    if (entry.needed && !entry.given)
      throw InputError(entry.key, "", "a value (it is required), " + entry.text + ": " + allowed);
  }
}

}  // namespace scree
