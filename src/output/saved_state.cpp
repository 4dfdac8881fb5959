#include "scree/output/saved_state.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "scree/grid/axis_name.hpp"
#include "scree/output/checkpoint_file.hpp"
#include "scree/output/checksum.hpp"
#include "scree/output/errors.hpp"

namespace scree {

namespace {

using Json = nlohmann::ordered_json;

Box box_from(const Json& grid) {
  Box box;
  box.dim = grid.at("dim");
  for (int axis = 0; axis < box.dim; ++axis) {
    box.faces[axis] = grid.at(axis_name(axis) + "_faces").get<std::vector<double>>();
    box.periodic[axis] = grid.at("periodic").at(static_cast<std::size_t>(axis)).get<bool>();
  }
  return box;
}

std::vector<Field> fields_from(const Json& list) {
  std::vector<Field> fields;
  for (const Json& entry : list) {
    Field field;
    field.dataset = entry.at("dataset");
    field.component = entry.at("component");
    field.face_axis = entry.at("face_axis");
    field.scale = entry.at("scale");
    field.unit = entry.at("unit");
    fields.push_back(field);
  }
  return fields;
}

/// This rank's share of all nodes, cut along the last axis.
NodeBlock share_of(MPI_Comm comm, const Box& box) {
  int rank, ranks;
  MPI_Comm_rank(comm, &rank);
  MPI_Comm_size(comm, &ranks);
  NodeBlock share{{}, nodes_of(box)};
  const int last = box.dim - 1, nodes = share.count[last];
  share.first[last] = static_cast<int>(static_cast<long>(nodes) * rank / ranks);
  share.count[last] = static_cast<int>(static_cast<long>(nodes) * (rank + 1) / ranks) - share.first[last];
  return share;
}

/// Collective. Reads the whole state once, each rank a share.
void check_state(MPI_Comm comm, const CheckpointFile& file, const SavedState& saved, const std::string& checksum) {
  const Index nodes = nodes_of(saved.box);
  const NodeBlock share = share_of(comm, saved.box);
  std::vector<double> values(share.size() * static_cast<std::size_t>(saved.unknowns));
  const bool read = file.read("state", slab_of(saved.box.dim, nodes, share, saved.unknowns), values.data());
  agree(comm, read, file.complaint("vector state is missing or damaged"));
  std::uint64_t part = checksum_part(nodes, share, saved.unknowns, values.data()), total = 0;
  MPI_Allreduce(&part, &total, 1, MPI_UINT64_T, MPI_SUM, comm);
  agree(comm, hexadecimal(total) == checksum, file.complaint("checksum of vector state differs"));
  const bool finite = std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
  agree(comm, finite, file.complaint("vector state holds a NaN or an infinity"));
}

}  // namespace

const Field* SavedState::find(const std::string& dataset, int face_axis) const {
  for (const Field& field : fields)
    if (field.dataset == dataset && field.face_axis == face_axis) return &field;
  return nullptr;
}

double SavedState::value(const Field& field, Index node) const {
  std::size_t place = 0;
  for (int axis = max_dim - 1; axis >= 0; --axis) {
    const int period = axis < box.dim && box.periodic[axis] ? box.cells(axis) : 0;
    if (period > 0) node[axis] = (node[axis] % period + period) % period;
    place =
        place * static_cast<std::size_t>(block.count[axis]) + static_cast<std::size_t>(node[axis] - block.first[axis]);
  }
  return field.scale * values[place * static_cast<std::size_t>(unknowns) + static_cast<std::size_t>(field.component)];
}

Index nodes_of(const Box& box) {
  Index nodes{{1, 1, 1}};
  for (int axis = 0; axis < box.dim; ++axis) nodes[axis] = box.cells(axis) + (box.periodic[axis] ? 0 : 1);
  return nodes;
}

SavedState read_state(MPI_Comm comm, const std::string& source, const std::function<NodeBlock(const Box&)>& wanted) {
  std::string complaints;
  for (const std::string& path : checkpoint_files(comm, source)) {
    SavedState saved;
    saved.file = path;
    Json header;
    try {
      header = checkpoint_header(comm, path);
      saved.box = box_from(header.at("grid"));
      saved.fields = fields_from(header.at("fields"));
      saved.unknowns = header.at("dof");
      saved.time = header.at("scalars").at("time");
      const CheckpointFile file(comm, path);
      check_state(comm, file, saved, header.at("vectors").at("state"));
    } catch (const std::runtime_error& error) {
      complaints += (complaints.empty() ? "" : "; ") + std::string(error.what());
      continue;
    } catch (const Json::exception&) {
      complaints += (complaints.empty() ? "" : "; ") + ("checkpoint '" + path + "' lacks what a state needs");
      continue;
    }
    saved.block = wanted(saved.box);
    saved.values.resize(saved.block.size() * static_cast<std::size_t>(saved.unknowns));
    const CheckpointFile file(comm, path);
    const Slab slab = slab_of(saved.box.dim, nodes_of(saved.box), saved.block, saved.unknowns);
    agree(comm, file.read("state", slab, saved.values.data()), file.complaint("vector state is damaged"));
    if (!complaints.empty()) saved.remark = complaints + "; taking '" + path + "'";
    return saved;
  }
  throw std::runtime_error(complaints);
}

}  // namespace scree
