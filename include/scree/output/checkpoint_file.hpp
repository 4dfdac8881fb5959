/// The file of a checkpoint as whoever reads one sees it: where it is found, its header, blocks of its vectors.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "scree/output/hdf5_file.hpp"
#include "scree/output/node_block.hpp"

namespace scree {

inline constexpr const char* checkpoint_format = "scree checkpoint";
inline constexpr int checkpoint_version = 2;

/// Collective. Checkpoints of `source`, the newest first: an output directory, its checkpoints/, or one file. Throws
/// std::runtime_error if there is none.
std::vector<std::string> checkpoint_files(MPI_Comm comm, const std::string& source);

/// Keeps the checkpoint `newest` and the one before in its directory; the future of an abandoned run and older files
/// go. One rank.
void remove_other_checkpoints(const std::string& newest);

/// Collective. The header of a sound file, on all ranks; std::runtime_error on all says what is wrong with it.
nlohmann::ordered_json checkpoint_header(MPI_Comm comm, const std::string& path);

/// Of a text, such as the header.
std::string text_checksum(const std::string& text);

/// Sum over the numbers of a block of nodes, `dof` a node, of their places in the whole grid and their bits: those of
/// blocks add up to that of the grid, however it is cut.
std::uint64_t checksum_part(const Index& nodes, const NodeBlock& block, int dof, const double* values);

/// A checkpoint, open for all ranks.
class CheckpointFile {
 public:
  /// Collective. Throws std::runtime_error on all ranks if the file cannot be opened.
  CheckpointFile(MPI_Comm comm, const std::string& path);

  /// The values of vector `name`, of this shape, on a part of it; false if HDF5 cannot give them.
  bool read(const std::string& name, const Slab& slab, double* values) const;
  /// "checkpoint '...' cannot be used: " + what.
  std::string complaint(const std::string& what) const;

 private:
  std::string path_;
  QuietHdf5 quiet_;
  Hdf5Handle access_, file_;
};

}  // namespace scree
