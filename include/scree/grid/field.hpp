/// What output, norms and probes need to know of one unknown of the model: its names, its place and its unit.
#pragma once

#include <string>

namespace scree {

/// One physical field of the model. Cell-centred fields stand alone; fields that share `dataset` and have
/// face_axis 0, 1, 2 are the components of one vector.
struct Field {
  std::string dataset;  ///< name in files, e.g. "solids_fraction"; all components of a vector say "velocity"
  std::string symbol;   ///< as in src/MODEL.md
  std::string unit;     ///< SI
  std::string text;     ///< one line for readers of the file
  int component = 0;    ///< in the DMDA node
  int face_axis = -1;   ///< -1: at cell centres; else at the lower faces of that axis
  double scale = 1;     ///< SI value = scale * stored value
};

/// Name of a field as a column or a dataset of its own: "solids_fraction", "velocity_x", "velocity_y", ...
inline std::string column_name(const Field& field) {
  if (field.face_axis < 0) return field.dataset;
  return field.dataset + '_' + "xyz"[field.face_axis];
}

}  // namespace scree
