#include "scree/stepping/solver_choice.hpp"

#include <cmath>

namespace scree {

namespace {

/// How much dearer a factor is, per cell, than on the grid where it was measured, with its work shared by ranks that
/// share it badly.
double factor_growth(double cells, double measured_cells, int ranks) {
  return std::cbrt(cells / measured_cells) * std::sqrt(ranks);
}

std::vector<SolverCandidate> without_gas(int dim, double cells, int ranks) {
  if (dim == 3) return {{SolverPreset::ilu, 0, 8, 1, 10, 0.35}, {SolverPreset::condensed, 0, 26, 5.5, 5, 0.35, true}};
  const double growth = factor_growth(cells, 2500, ranks);
  return {{SolverPreset::ilu, 0, 10, 1, 10, 0.35},
          {SolverPreset::condensed, 0, 26 * growth, 3.3 * std::sqrt(growth), 4, 0.35, true},
          {SolverPreset::multigrid, 0, 15, 2.5, 10, 0.35}};
}

std::vector<SolverCandidate> with_gas(int dim, double cells, int ranks) {
  if (dim == 3)
    return {{SolverPreset::fieldsplit, 0, 13, 1, 8, 0.35}, {SolverPreset::condensed, 0, 17, 2.4, 5, 0.35, true}};
  const double growth = factor_growth(cells, 5000, ranks);
  return {{SolverPreset::fieldsplit, 0, 10, 1, 8, 0.35},
          {SolverPreset::fieldsplit, 1, 16, 1.2, 8, 0.35},
          {SolverPreset::multigrid, 0, 22, 2.2, 15, 0.35},
          {SolverPreset::condensed, 0, 40 * growth, 4 * std::sqrt(growth), 6, 0.35, true}};
}

}  // namespace

std::vector<SolverCandidate> solver_candidates(bool gas, int dim, double cells, int ranks) {
  return gas ? with_gas(dim, cells, ranks) : without_gas(dim, cells, ranks);
}

}  // namespace scree
