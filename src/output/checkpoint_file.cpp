#include "scree/output/checkpoint_file.hpp"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "scree/output/checksum.hpp"
#include "scree/output/errors.hpp"
#include "scree/output/seal.hpp"

namespace scree {

namespace {

namespace fs = std::filesystem;

std::string complaint_about(const std::string& path, const std::string& what) {
  return "checkpoint '" + path + "' cannot be used: " + what;
}

/// Complete checkpoints in a directory, newest first. Names are steps of 8 digits, longer ones beyond.
std::vector<fs::path> checkpoints_in(const fs::path& directory) {
  std::vector<fs::path> files;
  if (!fs::is_directory(directory)) return files;
  for (const auto& entry : fs::directory_iterator(directory)) {
    const std::string stem = entry.path().stem().string();
    const bool number = stem.size() >= 8 && stem.find_first_not_of("0123456789") == std::string::npos;
    if (entry.path().extension() == ".h5" && number) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    return std::stoull(a.stem().string()) > std::stoull(b.stem().string());
  });
  return files;
}

std::string read_text_attribute(hid_t file, const char* name) {
  const Hdf5Handle attribute(H5Aopen(file, name, H5P_DEFAULT), H5Aclose);
  if (!attribute.valid()) return "";
  const Hdf5Handle type(H5Aget_type(attribute.id()), H5Tclose);
  if (H5Tget_class(type.id()) != H5T_STRING || H5Tis_variable_str(type.id()) > 0) return "";
  std::string text(H5Tget_size(type.id()), '\0');
  if (H5Aread(attribute.id(), type.id(), text.data()) < 0) return "";
  return text.c_str();
}

std::string read_text_dataset(hid_t file, const char* name) {
  const Hdf5Handle data(H5Dopen2(file, name, H5P_DEFAULT), H5Dclose);
  if (!data.valid()) return "";
  const Hdf5Handle type(H5Dget_type(data.id()), H5Tclose), space(H5Dget_space(data.id()), H5Sclose);
  const bool plain = H5Tget_class(type.id()) == H5T_STRING && H5Tis_variable_str(type.id()) == 0;
  if (!plain || H5Sget_simple_extent_npoints(space.id()) != 1) return "";
  std::string text(H5Tget_size(type.id()), '\0');
  if (H5Dread(data.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()) < 0) return "";
  return text.c_str();
}

/// The header of a file; throws std::runtime_error saying what is wrong with it. One rank.
std::string header_of(const std::string& path) {
  const auto wrong = [&](const std::string& what) { return std::runtime_error(complaint_about(path, what)); };
  const std::string complaint = seal_complaint(path);
  if (!complaint.empty()) throw wrong(complaint);
  const QuietHdf5 quiet;
  const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (!file.valid()) throw wrong("not an HDF5 file");
  if (read_text_attribute(file.id(), "format") != checkpoint_format) throw wrong("not a checkpoint of Scree");
  const std::string version = read_text_attribute(file.id(), "version");
  if (version != std::to_string(checkpoint_version)) {
    throw wrong("format version '" + version + "', expected " + std::to_string(checkpoint_version));
  }
  std::string header = read_text_dataset(file.id(), "header");
  if (text_checksum(header) != read_text_attribute(file.id(), "header_checksum"))
    throw wrong("checksum of header differs");
  return header;
}

}  // namespace

std::vector<std::string> checkpoint_files(MPI_Comm comm, const std::string& source) {
  std::string list;
  on_first_rank(comm, [&] {
    if (fs::is_regular_file(source)) {
      list = source + '\n';
      return;
    }
    for (const fs::path& directory : {fs::path(source) / "checkpoints", fs::path(source)}) {
      if (!list.empty()) return;
      for (const fs::path& file : checkpoints_in(directory)) list += file.string() + '\n';
    }
    if (!fs::exists(source)) throw std::runtime_error("no checkpoint: '" + source + "' does not exist");
    if (list.empty()) throw std::runtime_error("no checkpoint in '" + source + "'");
  });
  list = broadcast(comm, list);
  std::vector<std::string> files;
  for (size_t begin = 0, end; (end = list.find('\n', begin)) != std::string::npos; begin = end + 1) {
    files.push_back(list.substr(begin, end - begin));
  }
  return files;
}

void remove_other_checkpoints(const std::string& newest) {
  int kept_before = 0;
  const fs::path path(newest);
  const auto step = std::stoull(path.stem().string());
  for (const fs::path& file : checkpoints_in(path.parent_path())) {
    const auto other = std::stoull(file.stem().string());
    if (other == step || (other < step && kept_before++ == 0)) continue;
    std::error_code ignored;  // a file too many does no harm
    fs::remove(file, ignored);
  }
}

/// Rank 0 looks at the file alone first, so that all ranks judge alike.
nlohmann::ordered_json checkpoint_header(MPI_Comm comm, const std::string& path) {
  std::string text;
  on_first_rank(comm, [&] { text = header_of(path); });
  return nlohmann::ordered_json::parse(broadcast(comm, text));
}

std::string text_checksum(const std::string& text) {
  ByteSum sum;
  sum.add(text.data(), text.size());
  return sum.text();
}

std::uint64_t checksum_part(const Index& nodes, const NodeBlock& block, int dof, const double* values) {
  std::uint64_t sum = 0;
  for_each_node(block.first, block.count, [&](const Index& node) {
    const std::uint64_t row = static_cast<std::uint64_t>(node[2]) * nodes[1] + node[1];
    std::uint64_t place = (row * nodes[0] + node[0]) * dof;
    for (int component = 0; component < dof; ++component, ++place) {
      std::uint64_t bits;
      std::memcpy(&bits, values++, sizeof bits);
      sum += spread(bits ^ spread(place));
    }
  });
  return sum;
}

CheckpointFile::CheckpointFile(MPI_Comm comm, const std::string& path)
    : path_(path), access_(shared_access(comm)), file_(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access_.id()), H5Fclose) {
  agree(comm, file_.valid(), complaint("it cannot be opened by all ranks"));
}

std::string CheckpointFile::complaint(const std::string& what) const { return complaint_about(path_, what); }

bool CheckpointFile::read(const std::string& name, const Slab& slab, double* values) const {
  const Hdf5Handle data(H5Dopen2(file_.id(), ("vectors/" + name).c_str(), H5P_DEFAULT), H5Dclose);
  if (!data.valid()) return false;
  const Hdf5Handle space(H5Dget_space(data.id()), H5Sclose);
  std::vector<hsize_t> shape(slab.shape.size());
  if (H5Sget_simple_extent_ndims(space.id()) != static_cast<int>(shape.size())) return false;
  H5Sget_simple_extent_dims(space.id(), shape.data(), nullptr);
  if (shape != slab.shape) return false;
  const bool nothing = std::find(slab.count.begin(), slab.count.end(), hsize_t{0}) != slab.count.end();
  if (nothing) return true;
  const Hdf5Handle memory(H5Screate_simple(static_cast<int>(shape.size()), slab.count.data(), nullptr), H5Sclose);
  H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, slab.start.data(), nullptr, slab.count.data(), nullptr);
  return H5Dread(data.id(), H5T_NATIVE_DOUBLE, memory.id(), space.id(), H5P_DEFAULT, values) >= 0;
}

}  // namespace scree
