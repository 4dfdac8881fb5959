/// What another run leaves to the start of this one.
#pragma once

#include <string>

#include "scree/config/case.hpp"
#include "scree/grid/lattice.hpp"
#include "scree/grid/transfer.hpp"
#include "scree/output/saved_state.hpp"

namespace scree {

/// The last state of the run that fills a region, from its grid to that of this case. What the particles carry counts
/// by their solids fraction, so that momentum and heat of few grains do not spread over many.
class InitialRun {
 public:
  /// Collective. Reads what this rank needs. Throws InputError on all ranks: no run of Scree, another dimension, a box
  /// that does not hold the region.
  InitialRun(MPI_Comm comm, const Case& the_case, const InitialRegion& region, const Lattice& grid);
  InitialRun(const InitialRun&) = delete;
  InitialRun& operator=(const InitialRun&) = delete;

  bool has(const Field& field) const { return saved_.find(field.dataset, field.face_axis) != nullptr; }
  /// SI value of a field that it has, at an owned node whose cell or face lies in the region.
  double value(const Lattice& grid, const Field& field, const Index& I) const;
  /// For the log: where it comes from, and which of `fields` it has not.
  std::string remark(const std::vector<Field>& fields) const;

 private:
  NodeBlock wanted(const Lattice& grid, const Box& box) const;
  double particles_at(int face_axis, const Index& place) const;

  const InitialRegion& region_;
  SavedState saved_;
};

/// Collective. Reads the runs that regions name, as a run of this case would: for -check. Throws InputError.
void check_initial_runs(MPI_Comm comm, const Case& the_case);

}  // namespace scree
