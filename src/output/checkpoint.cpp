#include "scree/output/checkpoint.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "scree/grid/axis_name.hpp"
#include "scree/output/checkpoint_file.hpp"
#include "scree/output/checksum.hpp"
#include "scree/output/errors.hpp"
#include "scree/output/hdf5_file.hpp"
#include "scree/output/node_block.hpp"

namespace scree {

namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

/// Collective. Checksum of an array over the owned nodes, `dof` numbers a node.
std::string checksum(MPI_Comm comm, const Lattice& grid, int dof, const double* values) {
  const std::uint64_t part = checksum_part(nodes_of(grid), owned_block(grid), dof, values);
  std::uint64_t total = 0;
  MPI_Allreduce(&part, &total, 1, MPI_UINT64_T, MPI_SUM, comm);
  return hexadecimal(total);
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

bool nearly(double a, double b) { return std::abs(a - b) <= 1e-12 * std::max(std::abs(a), std::abs(b)); }

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
    if (!nearly(list[i].at("scale"), fields[i].scale)) {
      return name + " has another scale (" + list[i].at("scale").dump() + " in the file, " +
             Json(fields[i].scale).dump() + " in the case)";
    }
  }
  return "";
}

Checkpoint::OwnedVec new_vector(DM dm) {
  Vec vector = nullptr;
  check_petsc(DMCreateGlobalVector(dm, &vector), "vector of a checkpoint");
  return Checkpoint::OwnedVec(vector, [](Vec owned) { (void)VecDestroy(&owned); });
}

/// Collective. Reads and verifies all vectors that the header names; the same std::runtime_error on all ranks.
void read_vectors(Checkpoint& checkpoint, const Json& header, const Lattice& grid, DM dm) {
  const MPI_Comm comm = communicator(dm);
  const CheckpointFile file(comm, checkpoint.file);
  const int dof = unknowns_of(dm);
  const Slab slab = slab_of(grid.dim, nodes_of(grid), owned_block(grid), dof);
  for (const auto& [name, sum] : header.at("vectors").items()) {
    const Checkpoint::OwnedVec vector = new_vector(dm);
    PetscScalar* values = nullptr;
    check_petsc(VecGetArray(vector.get(), &values), "vector of a checkpoint");
    const bool read = file.read(name, slab, values);
    const std::string found = checksum(comm, grid, dof, values);
    const bool finite = std::all_of(values, values + static_cast<std::size_t>(grid.owned_size()) * dof,
                                    [](PetscScalar value) { return std::isfinite(value); });
    check_petsc(VecRestoreArray(vector.get(), &values), "vector of a checkpoint");
    agree(comm, read, file.complaint("vector " + name + " is missing or damaged"));
    agree(comm, found == sum.get<std::string>(), file.complaint("checksum of vector " + name + " differs"));
    agree(comm, finite, file.complaint("vector " + name + " holds a NaN or an infinity"));
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

  Json header{{"format", checkpoint_format}, {"version", checkpoint_version}, {"index", index}};
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
  file.attribute("/", "format", checkpoint_format);
  file.attribute("/", "version", std::to_string(checkpoint_version));
  file.attribute("/", "header_checksum", text_checksum(text));
  file.seal();
  file.commit();
  on_first_rank(comm, [&] { remove_other_checkpoints(path); });
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
  for (const std::string& path : checkpoint_files(comm, source)) {
    Json header;
    Checkpoint checkpoint;
    checkpoint.file = path;
    std::string complaint = complaint_of([&] { header = checkpoint_header(comm, path); });
    if (complaint.empty()) {
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
