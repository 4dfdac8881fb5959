/// What monitor.csv says of a state: masses, rates, extremes, bed height.
#pragma once

#include <vector>

#include "scree/config/case.hpp"
#include "scree/output/monitor.hpp"
#include "scree/stepping/discrete_problem.hpp"

namespace scree {

/// Quantities of a state, in SI; masses, volume flows and rates refer to `output_depth` and `output_mirror`.
class Measures {
 public:
  Measures(const Case& scene, const DiscreteProblem& problem);

  const std::vector<Column>& columns() const { return columns_; }
  std::vector<double> values(double time, Vec state) const;  ///< collective; one a column

  /// Factor from solids volume [m^dim] to mass [kg].
  double mass_per_volume() const { return mass_per_volume_; }

 private:
  struct Range {
    double least, greatest;
  };
  Range range(Vec state, const Field& field) const;
  double greatest_speed(Vec state, const std::string& symbol) const;
  double bed_height(Vec state) const;

  const Case& scene_;
  const DiscreteProblem& problem_;
  double mass_per_volume_;
  bool with_gas_, has_gas_velocity_;
  std::vector<Column> columns_;
};

}  // namespace scree
