/// Checkpoints: everything a run needs to go on, in HDF5, readable on any number of ranks.
#pragma once

#include <petscdmda.h>

#include <map>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "scree/grid/box.hpp"
#include "scree/grid/unknown.hpp"

namespace scree {

using NamedVecs = std::vector<std::pair<std::string, Vec>>;
using NamedScalars = std::map<std::string, double>;
using NamedStrings = std::map<std::string, std::string>;

/// Collective. Writes <directory>/checkpoints/<index as 8 digits>.h5 and returns its path. `index` is the step number:
/// it must grow during a run. Vectors are global vectors of `dm`, stored bit by bit in natural ordering as
/// /vectors/NAME (nz, ny, nx, dof), padding included; grid, fields, scalars, strings and checksums stand in /header;
/// the file is sealed (seal.hpp).
/// The file appears complete or not at all; then the two newest up to `index` stay, the others go.
/// Throws std::runtime_error on all ranks (disk full ...); earlier checkpoints are untouched then.
std::string write_checkpoint(const std::string& directory, int index, const Box& box, DM dm,
                             const std::vector<Field>& fields, const NamedVecs& vectors, const NamedScalars& scalars,
                             const NamedStrings& strings);

/// What a checkpoint held. Owns its vectors.
class Checkpoint {
 public:
  using OwnedVec = std::shared_ptr<std::remove_pointer_t<Vec>>;

  std::string file;    ///< where it came from
  std::string remark;  ///< empty, or one line for the log: which newer file was damaged, and how
  NamedScalars scalars;
  NamedStrings strings;
  std::map<std::string, OwnedVec> vectors;  ///< global vectors of the dm given to read_checkpoint

  bool has(const std::string& name) const { return vectors.count(name) > 0; }
  Vec vector(const std::string& name) const;     ///< borrowed; throws std::runtime_error if the file has none
  double scalar(const std::string& name) const;  ///< throws std::runtime_error if the file has none
  /// `otherwise` if the file, of an earlier version, has none.
  double scalar(const std::string& name, double otherwise) const {
    return scalars.count(name) > 0 ? scalars.at(name) : otherwise;
  }
};

/// Collective. Reads the newest sound checkpoint of `source`: an output directory, its checkpoints/, or one file.
/// If the newest is damaged, the one before is taken, with a remark. Throws std::runtime_error, the same on all ranks,
/// naming the file and what is wrong: none there, not a checkpoint, another version, truncated, checksum, NaN, or a
/// grid or fields (name, component, place, scale) other than `box`, `dm` and `fields`.
Checkpoint read_checkpoint(const std::string& source, const Box& box, DM dm, const std::vector<Field>& fields);

}  // namespace scree
