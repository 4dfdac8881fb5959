/// The declaration of options: one call names key, variable (holding the default), unit, range and text;
/// validation, -help, the echo of the effective case and the option table all come from it.
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "scree/config/case_input.hpp"
#include "scree/config/input_error.hpp"
#include "scree/grid/box.hpp"

namespace scree {

/// A text as a YAML scalar in single quotes.
std::string yaml_quoted(const std::string& text);

/// The values a number may take.
struct Range {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool with_lower = true, with_upper = true;  ///< whether the bounds themselves are allowed
  std::string text;                           ///< in words, such as "> 0"; empty: any number

  bool contains(double x) const {
    return (with_lower ? x >= lower : x > lower) && (with_upper ? x <= upper : x < upper);
  }
};

Range any_number();
Range positive();
Range non_negative();
Range greater_than_one();
Range angle_below_right();                                      ///< in [0 deg, 90 deg)
Range positive_angle();                                         ///< in (0 deg, 90 deg)
Range above_zero_to_one();                                      ///< in (0, 1]
Range from_zero_to_one();                                       ///< in [0, 1]
Range from_zero_below(double upper, const std::string& name);   ///< in [0, upper)
Range above_zero_below(double upper, const std::string& name);  ///< in (0, upper)

/// How many entries a list has.
struct Count {
  std::size_t number = 0;  ///< 0: any
  bool multiple = false;   ///< any multiple of `number`
  std::string text;        ///< in words, such as "one per axis"
};

/// What is known of an option after its declaration. The setters return the entry, to be chained behind the
/// declaration.
struct OptionEntry {
  enum class Type { real, integer, boolean, choice, text };

  std::string group, key, unit, text;
  Type type = Type::text;
  bool list = false;                 ///< a list of values of the type
  Range range;                       ///< of each number
  std::vector<std::string> choices;  ///< words of a choice
  std::string allowed;               ///< range, choices, or the form of a text
  std::string default_value;         ///< as text
  std::string value;                 ///< the effective value as YAML; empty: nothing to write
  std::string symbol_;               ///< in src/MODEL.md
  std::string unused_because;        ///< why this scene does not use it; empty: it does
  bool default_in_words = false;     ///< the default is no value
  bool given = false;
  bool needed = false;

  OptionEntry& symbol(const std::string& name);
  OptionEntry& used_if(bool used, const std::string& otherwise);
  OptionEntry& required();
  /// The variable's value is no default that could be written: say in words what holds if the option is not given.
  OptionEntry& unset_by_default(const std::string& words);
  /// The default follows from other options: say how.
  OptionEntry& default_from(const std::string& words);
};

/// Declares options and, with an input in mode `read`, sets the variables. All reading throws InputError.
class OptionSet {
 public:
  enum class Mode { describe, read };

  /// Without an input: a description with "<name>" for the names that users choose.
  OptionSet() = default;
  OptionSet(const CaseInput& input, Mode mode) : input_(&input), mode_(mode) {}

  /// Heading of the options declared from here on.
  void group(const std::string& title) { group_ = title; }

  OptionEntry& real(const std::string& key, double& value, const std::string& unit, const Range& range,
                    const std::string& text);
  OptionEntry& reals(const std::string& key, std::vector<double>& values, const Count& count, const std::string& unit,
                     const Range& range, const std::string& text);
  /// One number per axis.
  OptionEntry& vector(const std::string& key, std::array<double, max_dim>& values, int dim, const std::string& unit,
                      const std::string& text);
  OptionEntry& integer(const std::string& key, int& value, int lower, const std::string& text);
  OptionEntry& integers(const std::string& key, std::vector<int>& values, const Count& count, int lower,
                        const std::string& text);
  OptionEntry& boolean(const std::string& key, bool& value, const std::string& text);
  OptionEntry& text(const std::string& key, std::string& value, const std::string& what, const std::string& text);
  /// The path of a file, made absolute: it stands beside the case file that names it, on the command line where one is.
  OptionEntry& file(const std::string& key, std::string& value, const std::string& text);
  OptionEntry& texts(const std::string& key, std::vector<std::string>& values, const std::string& what,
                     const std::string& text);

  template <class Choice>
  using Choices = std::vector<std::pair<std::string, Choice>>;
  template <class Choice>
  OptionEntry& choice(const std::string& key, Choice& value, const Choices<Choice>& choices, const std::string& text);

  /// One item for each name, alphabetically, with its attributes declared by
  /// `declare(options, "<section>_<name>_", name, item)`. Names are those that nesting tells; in a flat key
  /// `<section>_<name>_<attribute>` the longest of them that fits, else what is left by the longest attribute.
  template <class Item, class Declare>
  std::vector<Item> named(const std::string& section, Declare declare);

  /// True where there is no case, only a description of all there could be.
  bool describing() const { return !input_; }

  const std::deque<OptionEntry>& entries() const { return entries_; }
  /// Attributes by section, for the sections of named items.
  const std::map<std::string, std::vector<std::string>>& sections() const { return sections_; }

  /// Throws InputError if a required option was not given.
  void check_required() const;

 private:
  OptionEntry& add(OptionEntry::Type type, const std::string& key, const std::string& unit, const std::string& allowed,
                   const std::string& text);
  const std::string* given(OptionEntry& entry) const;
  std::size_t choose(OptionEntry& entry, const std::vector<std::string>& words, std::size_t fallback) const;
  double number(const OptionEntry& entry, const std::string& text, const std::string& unit, const Range& range) const;
  int whole_number(const OptionEntry& entry, const std::string& text, int lower) const;
  std::string word(const OptionEntry& entry, const std::string& text, const std::string& expected) const;
  std::vector<std::string> names(const std::string& section);
  std::string name_in(const std::string& section, const std::string& rest, const std::set<std::string>& known) const;

  const CaseInput* input_ = nullptr;
  Mode mode_ = Mode::describe;
  std::string group_;
  std::string item_;                           ///< the named item that is being declared
  std::map<std::string, std::string> owners_;  ///< key: the named item that it belongs to
  std::deque<OptionEntry> entries_;
  std::map<std::string, std::vector<std::string>> sections_;
};

template <class Choice>
OptionEntry& OptionSet::choice(const std::string& key, Choice& value, const Choices<Choice>& choices,
                               const std::string& text) {
  std::vector<std::string> words;
  std::size_t chosen = 0;
  std::string allowed;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    words.push_back(choices[i].first);
    allowed += (i ? ", " : "") + choices[i].first;
    if (choices[i].second == value) chosen = i;
  }
  OptionEntry& entry = add(OptionEntry::Type::choice, key, "-", allowed, text);
  entry.choices = words;
  value = choices[choose(entry, words, chosen)].second;
  return entry;
}

template <class Item, class Declare>
std::vector<Item> OptionSet::named(const std::string& section, Declare declare) {
  OptionSet pattern;
  Item nameless;
  declare(pattern, std::string(), std::string(), nameless);
  for (const OptionEntry& entry : pattern.entries()) sections_[section].push_back(entry.key);

  std::vector<Item> items;
  for (const std::string& name : names(section)) {
    group(section + " " + name);
    items.emplace_back();
    item_ = name;
    declare(*this, section + "_" + name + "_", name, items.back());
    item_.clear();
  }
  return items;
}

}  // namespace scree
