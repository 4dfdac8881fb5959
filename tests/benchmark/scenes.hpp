/// Problems to measure: scenes of cases/, on their grid or a finer one, in states where nothing is uniform.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "scree/config/case.hpp"
#include "scree/stepping/discrete_problem.hpp"

namespace scree::benchmarks {

/// A case file and what is changed in it.
struct Scene {
  std::string name, file;
  std::vector<std::pair<std::string, std::string>> options;  ///< keys and values, as on the command line
  std::vector<int> refined;                                  ///< values of grid_refine to measure
};

/// 1 mm bin (relaxed, critical_state), bubble, bubble with gas darcy, a box in three dimensions.
std::vector<Scene> scenes(const std::string& cases);

/// The case of a scene. PETSc's options database is empty from then on.
Case read_scene(const Scene& scene, int refine);

/// A problem with a state and its rate.
class Sample {
 public:
  Sample(const Scene& scene, int refine);
  ~Sample();
  Sample(const Sample&) = delete;
  Sample& operator=(const Sample&) = delete;

  void residual();
  void jacobian();
  int cells() const;
  double unknowns() const;  ///< a cell
  double entries() const;   ///< of the matrix, a cell

 private:
  DiscreteProblem problem_;
  Vec state_ = nullptr, rate_ = nullptr, residual_ = nullptr;
};

/// Throws where PETSc reports an error.
void check(PetscErrorCode code);

}  // namespace scree::benchmarks
