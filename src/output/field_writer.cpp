#include "scree/output/field_writer.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "scree/grid/axis_name.hpp"
#include "scree/grid/ghosted.hpp"
#include "scree/output/atomic_file.hpp"
#include "scree/output/directory.hpp"
#include "scree/output/errors.hpp"
#include "scree/output/hdf5_file.hpp"
#include "scree/output/node_block.hpp"

namespace scree {

namespace {

const std::string collection_head =
    "<?xml version=\"1.0\" ?>\n"
    "<Xdmf Version=\"3.0\">\n"
    "  <Domain>\n"
    "    <Grid Name=\"fields\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
const std::string collection_tail = "    </Grid>\n  </Domain>\n</Xdmf>\n";
const std::string entry_begin = "      <Grid Name=\"";
const std::string entry_end = "      </Grid>\n";

std::string file_name(int index) {
  char name[32];
  std::snprintf(name, sizeof name, "fields/%06d.h5", index);
  return name;
}

Index cells_of(const Box& box) {
  Index shape{{1, 1, 1}};
  for (int axis = 0; axis < box.dim; ++axis) shape[axis] = box.cells(axis);
  return shape;
}

/// The first field of each vector, in order.
std::vector<Field> vectors_of(const std::vector<Field>& fields) {
  std::vector<Field> vectors;
  for (const Field& field : fields) {
    const bool known =
        std::any_of(vectors.begin(), vectors.end(), [&](const Field& other) { return other.dataset == field.dataset; });
    if (field.face_axis >= 0 && !known) vectors.push_back(field);
  }
  return vectors;
}

/// The fields of a mean over time.
std::vector<Field> means_of(std::vector<Field> fields) {
  for (Field& field : fields) {
    field.dataset = "mean_" + field.dataset;
    field.text = "mean over time: " + field.text;
  }
  return fields;
}

/// The datasets of one file, from one state.
class FieldFile {
 public:
  FieldFile(Hdf5Writer& file, const Box& box, DM dm, Vec state)
      : file_(file), box_(box), grid_(checked_lattice(box, dm)), unknowns_(unknowns_of(dm)) {
    check_petsc(state_.open(dm, state), "ghost values");
  }

  void coordinates() {
    for (int axis = 0; axis < box_.dim; ++axis) {
      const std::string name = axis_name(axis) + "_faces";
      file_.dataset(name, box_.faces[axis]);
      describe(name, "m", "positions of the cell faces along " + axis_name(axis), axis_name(axis));
    }
  }

  /// All that is stored: raw, and vectors at the cell centres.
  void unknowns(const std::vector<Field>& fields) {
    for (const Field& field : fields) raw(field);
    for (const Field& first : vectors_of(fields)) vector(first, fields);
  }

  /// A cell-centred field that is no unknown.
  void derived(const CellField& field) {
    const Index shape = cells_of(box_);
    const NodeBlock part = part_of(grid_, shape);
    std::vector<double> values;
    values.reserve(part.size());
    for_each_node(part.first, part.count, [&](const Index& node) {
      values.push_back(field.values[static_cast<std::size_t>(grid_.owned(node))]);
    });
    const std::string name = column_name(field.field);
    file_.dataset(name, slab_of(box_.dim, shape, part), std::move(values));
    describe(name, field.field.unit, field.field.text, field.field.symbol);
  }

 private:
  /// A cell-centred field, or the raw values of a component at its faces.
  void raw(const Field& field) {
    Index shape = cells_of(box_);
    if (field.face_axis >= 0) ++shape[field.face_axis];
    const NodeBlock part = part_of(grid_, shape);
    std::vector<double> values;
    values.reserve(part.size());
    for_each_node(part.first, part.count,
                  [&](const Index& node) { values.push_back(field.scale * stored(node, field.component)); });
    const std::string name = column_name(field) + (field.face_axis < 0 ? "" : "_face");
    file_.dataset(name, slab_of(box_.dim, shape, part), std::move(values));
    const std::string place = field.face_axis < 0 ? "" : ", at the faces of axis " + axis_name(field.face_axis);
    describe(name, field.unit, field.text + place, field.symbol);
  }

  /// A vector at the cell centres: the mean of the two faces; absent components are zero.
  void vector(const Field& first, const std::vector<Field>& fields) {
    const Index shape = cells_of(box_);
    const NodeBlock part = part_of(grid_, shape);
    std::vector<double> values(part.size() * max_dim, 0.0);
    for (const Field& field : fields) {
      if (field.dataset != first.dataset || field.face_axis < 0) continue;
      size_t cell = 0;
      for_each_node(part.first, part.count, [&](const Index& node) {
        const double sum = stored(node, field.component) + stored(node + unit(field.face_axis), field.component);
        values[max_dim * cell++ + field.face_axis] = 0.5 * field.scale * sum;
      });
    }
    file_.dataset(first.dataset, slab_of(box_.dim, shape, part, max_dim), std::move(values));
    describe(first.dataset, first.unit, first.text + ", at cell centres", first.symbol);
  }

  double stored(const Index& node, int component) const {
    return state_.data()[grid_.ghosted(node) * unknowns_ + component];
  }
  void describe(const std::string& name, const std::string& unit, const std::string& text, const std::string& symbol) {
    file_.attribute(name, "unit", unit);
    file_.attribute(name, "text", text);
    file_.attribute(name, "symbol", symbol);
  }

  Hdf5Writer& file_;
  const Box& box_;
  Lattice grid_;
  int unknowns_;
  GhostedArray state_;
};

std::string data_item(const std::string& dimensions, const std::string& reference) {
  return "<DataItem Dimensions=\"" + dimensions + "\" NumberType=\"Float\" Precision=\"8\" Format=\"HDF\">" +
         reference + "</DataItem>";
}

/// "nz ny nx" with `more` added to each.
std::string dimensions_text(const Box& box, int more) {
  std::string text;
  for (int axis = box.dim - 1; axis >= 0; --axis) {
    text += std::to_string(box.cells(axis) + more) + (axis > 0 ? " " : "");
  }
  return text;
}

}  // namespace

FieldWriter::FieldWriter(std::string directory, const Box& box, DM dm, std::vector<Field> fields,
                         std::optional<double> restart_time)
    : directory_(std::move(directory)), box_(box), dm_(dm), fields_(std::move(fields)) {
  checked_lattice(box, dm);  // throws if they do not fit
  on_first_rank(communicator(dm), [this] { std::filesystem::create_directories(directory_ + "/fields"); });
  if (!restart_time) return;
  entries_ = read_collection();
  const double last = *restart_time + 1e-14 * std::abs(*restart_time);
  entries_.erase(std::remove_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return !(e.time <= last); }),
                 entries_.end());
  if (entries_.empty()) return;  // of another directory, or without a collection: no word on which files are later
  on_first_rank(communicator(dm), [this] { write_collection(); });
  remove_later_outputs(communicator(dm), directory_, next_index());
}

int FieldWriter::next_index() const { return entries_.empty() ? 0 : entries_.back().index + 1; }

std::optional<double> FieldWriter::last_time() const {
  if (entries_.empty()) return std::nullopt;
  return entries_.back().time;
}

int FieldWriter::write(double time, Vec state, const std::vector<CellField>& derived, Vec mean) {
  const bool again = last_time() == time;
  const int index = again ? entries_.back().index : next_index();
  Hdf5Writer file(communicator(dm_), directory_ + "/" + file_name(index));
  FieldFile datasets(file, box_, dm_, state);
  file.attribute("/", "time", time);
  datasets.coordinates();
  datasets.unknowns(fields_);
  std::vector<Field> written = fields_;
  for (const CellField& field : derived) {
    datasets.derived(field);
    written.push_back(field.field);
  }
  if (mean) {
    const std::vector<Field> means = means_of(fields_);
    FieldFile(file, box_, dm_, mean).unknowns(means);
    written.insert(written.end(), means.begin(), means.end());
  }
  file.commit();
  if (again) entries_.pop_back();
  entries_.push_back({index, time, entry_xml(index, time, written)});
  on_first_rank(communicator(dm_), [this] { write_collection(); });
  return index;
}

std::string FieldWriter::entry_xml(int index, double time, const std::vector<Field>& fields) const {
  char name[16], value[32];
  std::snprintf(name, sizeof name, "%06d", index);
  std::snprintf(value, sizeof value, "%.17g", time);
  const std::string file = file_name(index) + ":/";
  // XDMF has no rectilinear mesh of one dimension: that one is flat in y, which ParaView's Xdmf3 readers understand.
  const int mesh_dim = std::max(2, box_.dim);
  const std::string points = (mesh_dim > box_.dim ? "1 " : "") + dimensions_text(box_, 1);
  const std::string cells = dimensions_text(box_, 0);
  std::ostringstream xml;
  xml << entry_begin << name << "\" GridType=\"Uniform\">\n"
      << "        <Time Value=\"" << value << "\"/>\n"
      << "        <Topology TopologyType=\"" << mesh_dim << "DRectMesh\" Dimensions=\"" << points << "\"/>\n"
      << "        <Geometry GeometryType=\"" << (mesh_dim == 2 ? "VXVY" : "VXVYVZ") << "\">\n";
  for (int axis = 0; axis < mesh_dim; ++axis) {
    const bool flat = axis >= box_.dim;
    xml << "          "
        << (flat ? "<DataItem Dimensions=\"1\" NumberType=\"Float\" Precision=\"8\" Format=\"XML\">0</DataItem>"
                 : data_item(std::to_string(box_.cells(axis) + 1), file + axis_name(axis) + "_faces"))
        << "\n";
  }
  xml << "        </Geometry>\n";
  const auto attribute = [&](const std::string& dataset, const char* type, const std::string& dimensions) {
    xml << "        <Attribute Name=\"" << dataset << "\" AttributeType=\"" << type << "\" Center=\"Cell\">"
        << data_item(dimensions, file + dataset) << "</Attribute>\n";
  };
  for (const Field& field : fields) {
    if (field.face_axis < 0) attribute(field.dataset, "Scalar", cells);
  }
  for (const Field& first : vectors_of(fields)) attribute(first.dataset, "Vector", cells + " 3");
  xml << entry_end;
  return xml.str();
}

void FieldWriter::write_collection() const {
  std::string text = collection_head;
  for (const Entry& entry : entries_) text += entry.xml;
  write_text_atomically(directory_ + "/fields.xdmf", text + collection_tail);
}

/// Entries of the fields.xdmf of an earlier run of ours; none if there is no such file.
std::vector<FieldWriter::Entry> FieldWriter::read_collection() const {
  std::string text;
  int rank = 0;
  MPI_Comm_rank(communicator(dm_), &rank);
  if (rank == 0) {
    std::ifstream file(directory_ + "/fields.xdmf");
    std::ostringstream content;
    content << file.rdbuf();
    text = content.str();
  }
  text = broadcast(communicator(dm_), text);
  std::vector<Entry> entries;
  const std::string time_tag = "<Time Value=\"";
  for (size_t begin = text.find(entry_begin); begin != std::string::npos; begin = text.find(entry_begin, begin + 1)) {
    const size_t end = text.find(entry_end, begin), time = text.find(time_tag, begin);
    const char* name = text.c_str() + begin + entry_begin.size();
    if (end == std::string::npos || time > end || *name < '0' || *name > '9') continue;
    const double value = std::strtod(text.c_str() + time + time_tag.size(), nullptr);
    entries.push_back({std::atoi(name), value, text.substr(begin, end + entry_end.size() - begin)});
  }
  return entries;
}

}  // namespace scree
