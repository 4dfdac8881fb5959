/// The options as a JSON schema: keys may be nested or joined by '_' at any place, as the reader takes them.
#include <cmath>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>

#include "scree/config/case_options.hpp"
#include "scree/config/read_case.hpp"

namespace scree {
namespace {

using Json = nlohmann::json;

/// Keys and the schemas of their values.
using Keys = std::vector<std::pair<std::string, Json>>;

Json reference(const std::string& name) { return {{"$ref", "#/$defs/" + name}}; }

Json any_of(const std::vector<Json>& schemas) { return {{"anyOf", schemas}}; }

/// A text that is worked out to a number: it may have a unit and definitions.
Json expression() { return {{"type", "string"}, {"pattern", R"(^\s*[-+.(0-9$])"}}; }

/// A text with a definition in it, whatever it becomes.
Json with_definition() { return {{"type", "string"}, {"pattern", R"(\$\{)"}}; }

Json number(const OptionEntry& entry) {
  Json schema{{"type", entry.type == OptionEntry::Type::integer ? "integer" : "number"}};
  const Range& range = entry.range;
  if (std::isfinite(range.lower)) schema[range.with_lower ? "minimum" : "exclusiveMinimum"] = range.lower;
  if (std::isfinite(range.upper)) schema[range.with_upper ? "maximum" : "exclusiveMaximum"] = range.upper;
  return any_of({schema, expression()});
}

Json choice(const OptionEntry& entry) {
  Json words = entry.choices;
  for (const std::string& word : entry.choices) {
    char* end = nullptr;
    const long whole = std::strtol(word.c_str(), &end, 10);
    if (*end == '\0') words.push_back(whole);
  }
  return any_of({{{"enum", words}}, with_definition()});
}

Json boolean() {
  const Json words{true, false, nullptr, 0, 1, "", "yes", "true", "on", "1", "no", "false", "off", "0"};
  return any_of({{{"enum", words}}, with_definition()});
}

Json single_value(const OptionEntry& entry) {
  switch (entry.type) {
    case OptionEntry::Type::real:
    case OptionEntry::Type::integer:
      return number(entry);
    case OptionEntry::Type::boolean:
      return boolean();
    case OptionEntry::Type::choice:
      return choice(entry);
    default:
      return {{"type", {"string", "number"}}};
  }
}

/// The default as a value, where there is one.
void add_default(const OptionEntry& entry, Json& schema) {
  if (entry.list || entry.default_in_words || entry.value.empty()) return;
  if (entry.type == OptionEntry::Type::real)
    schema["default"] = std::strtod(entry.value.c_str(), nullptr);
  else if (entry.type == OptionEntry::Type::integer)
    schema["default"] = std::atoi(entry.value.c_str());
  else if (entry.type == OptionEntry::Type::boolean)
    schema["default"] = entry.value == "yes";
  else
    schema["default"] = entry.default_value;
}

Json value_schema(const OptionEntry& entry) {
  Json schema = single_value(entry);
  if (entry.list) schema = any_of({schema, {{"type", "array"}, {"items", schema}, {"minItems", 1}}});
  if (!entry.symbol_.empty()) schema["title"] = entry.symbol_;
  schema["description"] = entry.text + (entry.unit == "-" ? "" : " [" + entry.unit + "]") + "; " + entry.allowed +
                          "; default: " + entry.default_value;
  add_default(entry, schema);
  return schema;
}

/// Properties for keys that may be cut into levels at each '_'.
Json properties(const Keys& keys) {
  Json found = Json::object();
  std::map<std::string, Keys> levels;
  for (const auto& [key, schema] : keys) {
    found[key] = schema;
    for (std::size_t at = key.find('_'); at != std::string::npos; at = key.find('_', at + 1))
      levels[key.substr(0, at)].push_back({key.substr(at + 1), schema});
  }
  for (const auto& [key, below] : levels) {
    const Json level{{"type", "object"}, {"properties", properties(below)}, {"additionalProperties", false}};
    found[key] = found.contains(key) ? any_of({found[key], level}) : level;
  }
  return found;
}

std::string alternatives(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : "|") + word;
  return text;
}

/// The attributes that end in `_attribute`.
std::vector<std::string> longer(const std::vector<std::string>& attributes, const std::string& attribute) {
  std::vector<std::string> found;
  const std::string end = "_" + attribute;
  for (const std::string& other : attributes) {
    const bool ends = other.size() > end.size() && other.compare(other.size() - end.size(), end.size(), end) == 0;
    if (ends) found.push_back(other);
  }
  return found;
}

/// Named items behind `start`: `<name>` with its attributes below, or `<name>_<attribute>`.
Json item_patterns(const std::string& start, const std::string& section, const std::vector<std::string>& attributes) {
  const Json item = reference(section);
  Json patterns = Json::object();
  for (const std::string& attribute : attributes) {
    const std::vector<std::string> others = longer(attributes, attribute);
    const std::string unless = others.empty() ? "" : "(?!.*_(" + alternatives(others) + ")$)";
    patterns["^" + start + unless + ".+_" + attribute + "$"] = any_of({reference(section + "_" + attribute), item});
  }
  patterns["^" + start + "(?!.*_(" + alternatives(attributes) + ")$).+$"] = item;
  return patterns;
}

Json section_schema(const std::string& section, const std::vector<std::string>& attributes) {
  return {{"type", "object"},
          {"description", "by name"},
          {"patternProperties", item_patterns("", section, attributes)},
          {"additionalProperties", false}};
}

/// PETSc's options at the top level: their keys, or the words that they begin with as a level.
void add_petsc(Json& patterns) {
  std::vector<std::string> starts{"v$"}, levels;
  for (const std::string& prefix : petsc_prefixes()) {
    starts.push_back(prefix);
    if (prefix.back() == '_') levels.push_back(prefix.substr(0, prefix.size() - 1));
  }
  patterns["^(" + alternatives(starts) + ")"] = true;
  patterns["^(" + alternatives(levels) + ")$"] = {{"type", "object"}};
}

}  // namespace

std::string json_schema(const Catalogue& catalogue) {
  const OptionSet options = declared(OptionSet(), catalogue);

  Json definitions = Json::object(), patterns = Json::object();
  Keys plain;
  for (const OptionEntry& entry : options.entries()) {
    std::string name = entry.key;
    const std::size_t item = name.find("_<name>_");
    if (item != std::string::npos)
      name.replace(item, 8, "_");
    else
      plain.push_back({name, reference(name)});
    definitions[name] = value_schema(entry);
  }
  Json found = properties(plain);
  for (const auto& [section, attributes] : options.sections()) {
    Keys below;
    for (const std::string& attribute : attributes) below.push_back({attribute, reference(section + "_" + attribute)});
    definitions[section] = {{"type", "object"}, {"properties", properties(below)}, {"additionalProperties", false}};
    found[section] = section_schema(section, attributes);
    patterns.update(item_patterns(section + "_", section, attributes));
  }
  found["define"] = {{"type", "object"}, {"description", "names that stand for values: ${name}"}};
  found["petsc"] = {{"type", {"object", "null"}}, {"description", "options of PETSc, without '-'"}};
  add_petsc(patterns);
  const Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                    {"title", "Case file of Scree"},
                    {"type", "object"},
                    {"properties", found},
                    {"patternProperties", patterns},
                    {"additionalProperties", false},
                    {"$defs", definitions}};
  return schema.dump(1) + "\n";
}

}  // namespace scree
