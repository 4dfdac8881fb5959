#include "scree/app/derived_cells.hpp"

#include "scree/model/derived_fields.hpp"
#include "scree/output/errors.hpp"

namespace scree {

std::vector<CellField> derived_cells(const DiscreteProblem& problem, Vec state) {
  const ProblemSetup& setup = problem.setup();
  const std::vector<Field> fields = derived_fields(setup.model, setup.solids);
  std::vector<CellField> cells;
  if (fields.empty()) return cells;
  GhostedArray u;
  check_petsc(u.open(problem.dm(), state), "derived fields");
  auto values = problem.model().derived_values(u.data());
  for (std::size_t k = 0; k < fields.size(); ++k) cells.push_back({fields[k], std::move(values[k])});
  check_petsc(u.close(), "derived fields");
  return cells;
}

}  // namespace scree
