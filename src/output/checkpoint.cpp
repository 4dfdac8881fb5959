#include "scree/output/checkpoint.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "scree/grid/axis_name.hpp"
#include "scree/output/checksum.hpp"
#include "scree/output/errors.hpp"
#include "scree/output/hdf5_file.hpp"
#include "scree/output/node_block.hpp"
#include "scree/output/seal.hpp"

namespace scree {

namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr const char* format_name = "scree checkpoint";
constexpr int format_version = 2;

// ---- checksums: position and bits of each number, added up, hence independent of the number of ranks

/// Collective. Checksum of an array over the owned nodes, `dof` numbers a node.
std::string checksum(MPI_Comm comm, const Lattice& grid, int dof, const double* values) {
  std::uint64_t sum = 0, total = 0;
  const Index nodes = nodes_of(grid);
  for_each_node(grid.owned_first, grid.owned_count, [&](const Index& node) {
    const std::uint64_t row = static_cast<std::uint64_t>(node[2]) * nodes[1] + node[1];
    std::uint64_t place = (row * nodes[0] + node[0]) * dof;
    for (int component = 0; component < dof; ++component, ++place) {
      std::uint64_t bits;
      std::memcpy(&bits, values++, sizeof bits);
      sum += spread(bits ^ spread(place));
    }
  });
  MPI_Allreduce(&sum, &total, 1, MPI_UINT64_T, MPI_SUM, comm);
  return hexadecimal(total);
}

std::string checksum(const std::string& text) {
  ByteSum sum;
  sum.add(text.data(), text.size());
  return sum.text();
}

// ---- the header: all but the vectors, as JSON

Json grid_json(const Box& box) {
  Json grid;
  grid["dim"] = box.dim;
  for (int axis = 0; axis < box.dim; ++axis) {
    const std::string name = axis_name(axis);
    grid["periodic"].push_back(box.periodic[axis]);
    grid[name + "_faces"] = box.faces[axis];
  }
  return grid;
}

Json fields_json(const std::vector<Field>& fields) {
  Json list = Json::array();
  for (const Field& field : fields) {
    list.push_back({{"dataset", field.dataset},
                    {"component", field.component},
                    {"face_axis", field.face_axis},
                    {"scale", field.scale},
                    {"unit", field.unit}});
  }
  return list;
}

/// JSON has no NaN and no infinity: these go as text.
Json scalar_json(double value) {
  if (std::isfinite(value)) return value;
  return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
}

double scalar_from(const Json& value) {
  return value.is_string() ? std::strtod(value.get<std::string>().c_str(), nullptr) : value.get<double>();
}

bool close(double a, double b) { return std::abs(a - b) <= 1e-12 * std::max(std::abs(a), std::abs(b)); }

/// What is different between the grid of the file and `box`; empty: nothing.
std::string grid_difference(const Json& grid, const Box& box) {
  if (grid.at("dim") != box.dim) return "the file has another dimension";
  for (int axis = 0; axis < box.dim; ++axis) {
    const std::string name = axis_name(axis);
    const auto faces = grid.at(name + "_faces").get<std::vector<double>>();
    const auto& wanted = box.faces[axis];
    if (faces.size() != wanted.size()) {
      return "the file has " + std::to_string(faces.size() - 1) + " cells along " + name + ", the case " +
             std::to_string(wanted.size() - 1);
    }
    const double span = box.upper(axis) - box.lower(axis);
    for (size_t i = 0; i < faces.size(); ++i) {
      if (std::abs(faces[i] - wanted[i]) > 1e-12 * span) return "the cell faces along " + name + " lie elsewhere";
    }
    if (grid.at("periodic").at(axis) != box.periodic[axis]) return "axis " + name + " is periodic in one only";
  }
  return "";
}

std::string fields_difference(const Json& list, const std::vector<Field>& fields) {
  if (list.size() != fields.size()) {
    return "the file has " + std::to_string(list.size()) + " fields, the case " + std::to_string(fields.size());
  }
  for (size_t i = 0; i < fields.size(); ++i) {
    const std::string name = list[i].at("dataset");
    if (name != fields[i].dataset) return "the file has " + name + " where the case has " + fields[i].dataset;
    if (list[i].at("component") != fields[i].component || list[i].at("face_axis") != fields[i].face_axis) {
      return name + " has another place in the file";
    }
    if (!close(list[i].at("scale"), fields[i].scale)) {
      return name + " has another scale (" + list[i].at("scale").dump() + " in the file, " +
             Json(fields[i].scale).dump() + " in the case)";
    }
  }
  return "";
}

// ---- the directory of checkpoints

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

/// Keeps `newest` and the one before; the future of an abandoned run and older files go.
void remove_others(const fs::path& newest) {
  int kept_before = 0;
  const auto step = std::stoull(newest.stem().string());
  for (const fs::path& file : checkpoints_in(newest.parent_path())) {
    const auto other = std::stoull(file.stem().string());
    if (other == step || (other < step && kept_before++ == 0)) continue;
    std::error_code ignored;  // a file too many does no harm
    fs::remove(file, ignored);
  }
}

/// Collective. Files to try, the best first.
std::vector<std::string> candidates(MPI_Comm comm, const std::string& source) {
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

// ---- reading: rank 0 looks at the file alone first, so that all ranks judge alike

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
  const auto wrong = [&](const std::string& what) {
    return std::runtime_error("checkpoint '" + path + "' cannot be used: " + what);
  };
  const std::string complaint = seal_complaint(path);
  if (!complaint.empty()) throw wrong(complaint);
  const QuietHdf5 quiet;
  const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (!file.valid()) throw wrong("not an HDF5 file");
  if (read_text_attribute(file.id(), "format") != format_name) throw wrong("not a checkpoint of Scree");
  const std::string version = read_text_attribute(file.id(), "version");
  if (version != std::to_string(format_version)) {
    throw wrong("format version '" + version + "', expected " + std::to_string(format_version));
  }
  std::string header = read_text_dataset(file.id(), "header");
  if (checksum(header) != read_text_attribute(file.id(), "header_checksum")) throw wrong("checksum of header differs");
  return header;
}

Checkpoint::OwnedVec new_vector(DM dm) {
  Vec vector = nullptr;
  check_petsc(DMCreateGlobalVector(dm, &vector), "vector of a checkpoint");
  return Checkpoint::OwnedVec(vector, [](Vec owned) { (void)VecDestroy(&owned); });
}

/// The values of one vector on this rank's nodes; false if HDF5 cannot give them.
bool read_slab(hid_t file, const std::string& name, const Slab& slab, double* values) {
  const Hdf5Handle data(H5Dopen2(file, ("vectors/" + name).c_str(), H5P_DEFAULT), H5Dclose);
  if (!data.valid()) return false;
  const Hdf5Handle space(H5Dget_space(data.id()), H5Sclose);
  std::vector<hsize_t> shape(slab.shape.size());
  if (H5Sget_simple_extent_ndims(space.id()) != static_cast<int>(shape.size())) return false;
  H5Sget_simple_extent_dims(space.id(), shape.data(), nullptr);
  if (shape != slab.shape) return false;
  const Hdf5Handle memory(H5Screate_simple(static_cast<int>(shape.size()), slab.count.data(), nullptr), H5Sclose);
  H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, slab.start.data(), nullptr, slab.count.data(), nullptr);
  return H5Dread(data.id(), H5T_NATIVE_DOUBLE, memory.id(), space.id(), H5P_DEFAULT, values) >= 0;
}

/// Collective. Reads and verifies all vectors that the header names; the same std::runtime_error on all ranks.
void read_vectors(Checkpoint& checkpoint, const Json& header, const Lattice& grid, DM dm) {
  const MPI_Comm comm = communicator(dm);
  const QuietHdf5 quiet;
  const Hdf5Handle access = shared_access(comm);
  const Hdf5Handle file(H5Fopen(checkpoint.file.c_str(), H5F_ACC_RDONLY, access.id()), H5Fclose);
  const std::string complaint = "checkpoint '" + checkpoint.file + "' cannot be used: ";
  agree(comm, file.valid(), complaint + "it cannot be opened by all ranks");
  const int dof = unknowns_of(dm);
  const Slab slab = slab_of(grid.dim, nodes_of(grid), owned_block(grid), dof);
  for (const auto& [name, sum] : header.at("vectors").items()) {
    const Checkpoint::OwnedVec vector = new_vector(dm);
    PetscScalar* values = nullptr;
    check_petsc(VecGetArray(vector.get(), &values), "vector of a checkpoint");
    const bool read = read_slab(file.id(), name, slab, values);
    const std::string found = checksum(comm, grid, dof, values);
    const bool finite = std::all_of(values, values + static_cast<std::size_t>(grid.owned_size()) * dof,
                                    [](PetscScalar value) { return std::isfinite(value); });
    check_petsc(VecRestoreArray(vector.get(), &values), "vector of a checkpoint");
    agree(comm, read, complaint + "vector " + name + " is missing or damaged");
    agree(comm, found == sum.get<std::string>(), complaint + "checksum of vector " + name + " differs");
    agree(comm, finite, complaint + "vector " + name + " holds a NaN or an infinity");
    checkpoint.vectors[name] = vector;
  }
}

/// Collective. `work` throws std::runtime_error on all ranks alike or not at all; returns what it said.
std::string complaint_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

std::string write_checkpoint(const std::string& directory, int index, const Box& box, DM dm,
                             const std::vector<Field>& fields, const NamedVecs& vectors, const NamedScalars& scalars,
                             const NamedStrings& strings) {
  const MPI_Comm comm = communicator(dm);
  const Lattice grid = checked_lattice(box, dm);
  const int dof = unknowns_of(dm);
  char name[24];
  std::snprintf(name, sizeof name, "%08d.h5", index);
  std::string path = directory + "/checkpoints/" + name;
  on_first_rank(comm, [&] { fs::create_directories(directory + "/checkpoints"); });

  Json header{{"format", format_name}, {"version", format_version}, {"index", index}};
  header["grid"] = grid_json(box);
  header["dof"] = dof;
  header["fields"] = fields_json(fields);
  header["scalars"] = Json::object();
  for (const auto& [key, value] : scalars) header["scalars"][key] = scalar_json(value);
  header["strings"] = strings;
  header["vectors"] = Json::object();
  Hdf5Writer file(comm, path);
  const Slab slab = slab_of(grid.dim, nodes_of(grid), owned_block(grid), dof);
  for (const auto& [key, vector] : vectors) {
    const PetscScalar* values = nullptr;
    check_petsc(VecGetArrayRead(vector, &values), "vector of a checkpoint");
    std::vector<double> copy(values, values + static_cast<std::size_t>(grid.owned_size()) * dof);
    check_petsc(VecRestoreArrayRead(vector, &values), "vector of a checkpoint");
    header["vectors"][key] = checksum(comm, grid, dof, copy.data());
    file.dataset("vectors/" + key, slab, std::move(copy));
  }
  const std::string text = header.dump();
  file.text("header", text);
  file.attribute("/", "format", format_name);
  file.attribute("/", "version", std::to_string(format_version));
  file.attribute("/", "header_checksum", checksum(text));
  file.seal();
  file.commit();
  on_first_rank(comm, [&] { remove_others(path); });
  return path;
}

Vec Checkpoint::vector(const std::string& name) const {
  const auto found = vectors.find(name);
  if (found == vectors.end()) throw std::runtime_error("checkpoint '" + file + "' has no vector " + name);
  return found->second.get();
}

double Checkpoint::scalar(const std::string& name) const {
  const auto found = scalars.find(name);
  if (found == scalars.end()) throw std::runtime_error("checkpoint '" + file + "' has no number " + name);
  return found->second;
}

Checkpoint read_checkpoint(const std::string& source, const Box& box, DM dm, const std::vector<Field>& fields) {
  const MPI_Comm comm = communicator(dm);
  const Lattice grid = checked_lattice(box, dm);
  std::string complaints;
  for (const std::string& path : candidates(comm, source)) {
    std::string text;
    Checkpoint checkpoint;
    checkpoint.file = path;
    std::string complaint = complaint_of([&] { on_first_rank(comm, [&] { text = header_of(path); }); });
    if (complaint.empty()) {
      const Json header = Json::parse(broadcast(comm, text));
      std::string difference = grid_difference(header.at("grid"), box);
      if (difference.empty()) difference = fields_difference(header.at("fields"), fields);
      if (difference.empty() && header.at("dof") != unknowns_of(dm)) difference = "other unknowns in the nodes";
      if (!difference.empty()) throw std::runtime_error("checkpoint '" + path + "' is of another case: " + difference);
      complaint = complaint_of([&] { read_vectors(checkpoint, header, grid, dm); });
      if (complaint.empty()) {
        for (const auto& [key, value] : header.at("scalars").items()) checkpoint.scalars[key] = scalar_from(value);
        for (const auto& [key, value] : header.at("strings").items()) checkpoint.strings[key] = value;
        if (!complaints.empty()) checkpoint.remark = complaints + "; going on from '" + path + "'";
        return checkpoint;
      }
    }
    complaints += (complaints.empty() ? "" : "; ") + complaint;
  }
  throw std::runtime_error(complaints);
}

}  // namespace scree
