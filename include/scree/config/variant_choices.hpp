/// Closures that are chosen by name, as an option's choices and text: what their list holds is what the option offers.
#pragma once

#include <string>

#include "scree/closures/variants.hpp"
#include "scree/config/option_set.hpp"

namespace scree {

template <class Entry>
OptionSet::Choices<const Entry*> variant_choices(const Variants<Entry>& variants) {
  OptionSet::Choices<const Entry*> choices;
  for (const Entry* entry : variants) choices.emplace_back(entry->name, entry);
  return choices;
}

/// "<what>: <name>: <source>; ..."
template <class List>
std::string variant_text(const std::string& what, const List& variants) {
  std::string text = what;
  const char* separator = ". ";
  for (const auto& entry : variants) {
    text += separator + std::string(entry->name) + ": " + entry->source;
    separator = "; ";
  }
  return text;
}

}  // namespace scree
