/// Stresses of the particles on walls, plates and other sides that hold them back: forces, profiles, means over time.
#pragma once

#include <petscvec.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "scree/config/case.hpp"
#include "scree/stepping/discrete_problem.hpp"

namespace scree {

/// One face of a wall with the cell before it; a plate has two.
struct WallFace {
  int wall = 0;  ///< place in WallStress::names
  int axis = 0;
  Index I;                                        ///< the wall is the lower `axis` face of this cell
  End cells = End::upper;                         ///< whether the particles are in the upper or the lower cell
  std::array<double, max_dim> traction{0, 0, 0};  ///< force of the particles on an area [Pa]
};

/// The walls of a case by name, "boundary_left" or "plate_floor", and the stresses on their faces.
class WallStress {
 public:
  WallStress(const Case& the_case, const DiscreteProblem& problem);

  const std::vector<std::string>& names() const { return names_; }
  /// Collective. The faces of walls at nodes of this rank, at a time and the conditions that hold then.
  std::vector<WallFace> faces(double time, Vec state) const;
  /// Collective. Force on each wall along each axis, over the extent that the box has [Pa m^(dim-1)].
  std::vector<std::array<double, max_dim>> forces(double time, Vec state) const;

 private:
  int wall(int axis, const Index& I) const;

  const DiscreteProblem& problem_;
  std::vector<std::string> names_;
};

/// Mean over time of the stresses on walls, each state weighted by the step that led to it; a face counts as without
/// stress while it is no wall.
class WallAverage {
 public:
  /// Collective. Counts what lies after `from` [s].
  WallAverage(const DiscreteProblem& problem, double from);
  ~WallAverage();
  WallAverage(const WallAverage&) = delete;
  WallAverage& operator=(const WallAverage&) = delete;

  /// Adds a step of `dt` that ended at `time`.
  void add(double time, double dt, const std::vector<WallFace>& faces);
  bool empty() const { return seconds_ <= 0; }
  std::array<double, max_dim> mean(const WallFace& face) const;

  /// For checkpoints: sums of the faces with particles above and below, axis by axis, one component of the traction
  /// after the other in each node.
  std::vector<std::pair<std::string, Vec>> sums() const;
  template <class Visit>
  void each_member(Visit&& visit) {
    visit("wall_average_seconds", seconds_);
  }

 private:
  static std::size_t place(const WallFace& face) { return 2 * face.axis + (face.cells == End::upper ? 0 : 1); }

  const DiscreteProblem& problem_;
  double from_, seconds_ = 0;
  std::vector<Vec> sums_;
};

/// Collective. Writes <directory>/walls/<name>_<index>.csv for each wall with faces: a line for each with time, centre,
/// normal from the wall into the particles, area, normal stress (pressure counts positive) and shear stress by axis,
/// and with `average` their means. Lines go along the axes, the first one fastest. Throws std::runtime_error on all
/// ranks.
void write_wall_stress(const std::string& directory, int index, double time, Vec state, const WallStress& walls,
                       const WallAverage* average, const DiscreteProblem& problem);

}  // namespace scree
