/// Checkpoints: everything a run needs to go on, in HDF5, readable on any number of ranks.
#pragma once

#include <petscdmda.h>

#include <map>
#include <memory>
#include <stdexcept>
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
};

/// Adds the members of `owner` to `scalars`, as prefix + name. `owner` lists its members once, for writing and reading:
///     template <class Visit> void each_member(Visit&& visit) { visit("steps", steps); visit("guess", guess); }
/// They may be numbers, bool or enums.
template <class Owner>
void store_members(Owner&& owner, const std::string& prefix, NamedScalars& scalars) {
  owner.each_member([&](const char* name, const auto& member) {
    if (!scalars.emplace(prefix + name, static_cast<double>(member)).second)
      throw std::logic_error("two members of a checkpoint are called " + prefix + name);
  });
}

/// Sets the members of `owner` from what store_members left under `prefix`. A member that the file lacks keeps its
/// value: the version that wrote it did not know it.
template <class Owner>
void restore_members(const Checkpoint& checkpoint, const std::string& prefix, Owner& owner) {
  owner.each_member([&](const char* name, auto& member) {
    using Member = std::decay_t<decltype(member)>;
    const auto found = checkpoint.scalars.find(prefix + name);
    if (found == checkpoint.scalars.end()) return;
    if constexpr (std::is_enum_v<Member>)
      member = static_cast<Member>(static_cast<int>(found->second));
    else
      member = static_cast<Member>(found->second);
  });
}

/// Collective. Reads the newest sound checkpoint of `source`: an output directory, its checkpoints/, or one file.
/// If the newest is damaged, the one before is taken, with a remark. Throws std::runtime_error, the same on all ranks,
/// naming the file and what is wrong: none there, not a checkpoint, another version, truncated, checksum, NaN, or a
/// grid or fields (name, component, place, scale) other than `box`, `dm` and `fields`.
Checkpoint read_checkpoint(const std::string& source, const Box& box, DM dm, const std::vector<Field>& fields);

}  // namespace scree
