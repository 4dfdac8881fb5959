/// What monitor.csv says of a state: masses, rates, extremes, bed height.
#pragma once

#include <functional>
#include <vector>

#include "scree/config/case.hpp"
#include "scree/output/field_writer.hpp"
#include "scree/output/monitor.hpp"
#include "scree/stepping/discrete_problem.hpp"

namespace scree {

/// Quantities of a state, in SI; masses, volume flows and rates refer to `output_depth` and `output_mirror`.
class Measures {
 public:
  Measures(const Case& the_case, const DiscreteProblem& problem);

  /// Collective. Without a state (nullptr): the columns alone, all values 0.
  std::vector<Quantity> quantities(double time, Vec state) const;

 private:
  struct Range {
    double least, greatest;
  };
  /// What moves, by cell: v^2 is the sum over the axes of the mean of its squares on the two faces.
  struct Motion {
    double kinetic = 0;      ///< sum of nu v^2/2 [m^dim m2/s2]
    double fluctuation = 0;  ///< sum of 3/2 nu T [m^dim m2/s2]
    double speed = 0;        ///< sqrt of the greatest nu v^2/nu_max [m/s]
    double temperature = 0;  ///< greatest nu T/nu_max [m2/s2]
  };
  bool has_temperature() const;  ///< as an unknown or as a derived field
  Motion motion(Vec state, const std::vector<CellField>& derived) const;
  Range range(const std::function<double(const Index&)>& value) const;  ///< over the cells of the box
  Range range(Vec state, const Field& field) const;
  Range range(const CellField& field) const;
  double greatest_speed(Vec state, const Unknown& velocity) const;
  double bed_height(Vec state) const;

  const Case& case_;
  const DiscreteProblem& problem_;
  double mass_per_volume_;  ///< factor from solids volume [m^dim] to mass [kg]
  bool with_gas_, has_gas_velocity_;
  int T_;                       ///< component of T; -1 where it is no unknown
  std::vector<Field> derived_;  ///< of the cells
};

}  // namespace scree
