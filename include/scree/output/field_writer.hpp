/// Fields over time: one HDF5 file an output time (fields/000012.h5), and fields.xdmf, which ParaView opens.
#pragma once

#include <petscdmda.h>

#include <optional>
#include <string>
#include <vector>

#include "scree/grid/box.hpp"
#include "scree/grid/unknown.hpp"

namespace scree {

/// A cell-centred field that is no unknown: its values at the nodes of this rank, in the order of Lattice::owned, SI.
struct CellField {
  Field field;
  std::vector<double> values;
};

/// Writes the fields of a state in SI, and the collection that lists the files.
///
/// Each file holds x_faces, y_faces, z_faces [m]; cell-centred fields as (nz, ny, nx), in 2-D (ny, nx), in 1-D (nx);
/// each vector at cell centres, the mean of the two faces, as (.., 3), and raw as velocity_x_face, ... with one entry
/// more along its axis (on a periodic axis the last is the first again). Attributes: time of the file; unit, text and
/// symbol of each dataset.
class FieldWriter {
 public:
  /// Collective. `dm` as described in grid: interlaced, stencil width >= 1, cells + 1 nodes on an axis that is not
  /// periodic. With `restart_time` the existing collection goes on; entries after that time are
  /// dropped, their files and those of lines removed.
  /// Throws std::runtime_error when grid and dm do not belong together.
  FieldWriter(std::string directory, const Box& box, DM dm, std::vector<Field> fields,
              std::optional<double> restart_time = std::nullopt);

  /// Collective. Writes fields/<index>.h5 and renews fields.xdmf; returns the index. A second call for the same time
  /// replaces the first. Throws std::runtime_error on all ranks (disk full ...); earlier files are untouched then.
  /// `derived` are written beside the unknowns, as cell-centred fields; `mean`, a state too, as mean_solids_fraction,
  /// mean_velocity, mean_velocity_x_face and so on.
  int write(double time, Vec state, const std::vector<CellField>& derived = {}, Vec mean = nullptr);

  int next_index() const;                   ///< the index that write() takes at a new time
  std::optional<double> last_time() const;  ///< time of the last entry [s]

 private:
  /// One <Grid> of the collection.
  struct Entry {
    int index;
    double time;
    std::string xml;
  };
  std::vector<Entry> read_collection() const;
  void write_collection() const;
  std::string entry_xml(int index, double time, const std::vector<Field>& fields) const;

  std::string directory_;
  Box box_;
  DM dm_;
  std::vector<Field> fields_;
  std::vector<Entry> entries_;
};

}  // namespace scree
