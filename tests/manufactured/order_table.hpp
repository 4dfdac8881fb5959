/// Observed orders: printed as they come, and left in a file for the page of tests.
#pragma once

#include <string>
#include <vector>

#include "scree/closures/gas.hpp"

namespace scree::test {

/// Errors of one unknown over a sequence of grids or steps, each twice as fine as the one before.
struct OrderRow {
  std::string name, unknown;
  std::vector<double> mean, greatest;  ///< error in L2 and maximum norm
  double bound = 0;                    ///< on the last order in L2
  std::vector<double> steps;           ///< cells along an axis, or steps
  std::string what = "grids";          ///< "grids" or "steps"
};

/// A gas model in the names of rows.
inline std::string gas_name(GasModel gas) {
  return gas == GasModel::none ? "no gas" : gas == GasModel::darcy ? "darcy" : "incompressible";
}

class OrderTable {
 public:
  /// Prints and keeps the row; returns its last order in L2. Collective; rank 0 writes.
  static double add(const OrderRow& row);
};

}  // namespace scree::test
