/// What a case may choose from: the parts that come with Scree, and those that a program adds to them.
#pragma once

#include <functional>
#include <vector>

#include "scree/balances/present.hpp"
#include "scree/boundary/kind.hpp"

namespace scree {

class OptionSet;

/// Parts beyond the standard ones. What is pointed to must outlive every case.
struct Catalogue {
  std::vector<const Unknown*> further_unknowns;     ///< ModelFactory::further; run_program fills them in
  std::vector<const BoundaryKind*> further_kinds;   ///< of boundaries
  std::function<void(OptionSet&)> further_options;  ///< declares options that set the program's own variables

  std::vector<const Unknown*> unknowns() const {
    std::vector<const Unknown*> all(standard_unknowns.begin(), standard_unknowns.end());
    all.insert(all.end(), further_unknowns.begin(), further_unknowns.end());
    return all;
  }
  std::vector<const BoundaryKind*> boundary_kinds() const {
    std::vector<const BoundaryKind*> all(standard_boundary_kinds.begin(), standard_boundary_kinds.end());
    all.insert(all.end(), further_kinds.begin(), further_kinds.end());
    return all;
  }
};

}  // namespace scree
