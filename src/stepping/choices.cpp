#include "scree/stepping/choices.hpp"

#include <array>

namespace scree {

const char* name_of(TimeScheme scheme) {
  constexpr std::array names{"beuler", "bdf", "arkimex"};
  return names.at(static_cast<std::size_t>(scheme));
}

const char* name_of(SolverPreset preset) {
  constexpr std::array names{"direct", "ilu", "multigrid", "fieldsplit", "condensed"};
  return names.at(static_cast<std::size_t>(preset));
}

}  // namespace scree
