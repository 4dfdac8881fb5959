#include "scree/config/renamed_options.hpp"

#include <map>

namespace scree {

const std::string* present_name(const std::string& key) {
  static const std::map<std::string, std::string> renamed{
      {"void_fraction_floor", "solids_fraction_floor"}};  // "void fraction" is that of the gas
  const auto entry = renamed.find(key);
  return entry == renamed.end() ? nullptr : &entry->second;
}

}  // namespace scree
