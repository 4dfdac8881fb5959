#include "scree/model/derived_fields.hpp"

namespace scree {

std::vector<CellClosure::Entry> derived_entries(const ModelParameters& model, const SolidsParameters& solids) {
  std::vector<CellClosure::Entry> list;
  if (model.temperature == TemperatureModel::algebraic) list.push_back(CellClosure::temperature);
  if (solids.friction.model->has_friction) list.push_back(CellClosure::frictional_pressure);
  return list;
}

std::vector<Field> derived_fields(const ModelParameters& model, const SolidsParameters& solids) {
  std::vector<Field> fields;
  for (const CellClosure::Entry entry : derived_entries(model, solids)) {
    const int place = static_cast<int>(fields.size());
    if (entry == CellClosure::temperature)
      fields.push_back(
          {"granular_temperature", "T", "m2/s2", "granular temperature, (9) without storage and fluxes", place, -1, 1});
    else
      fields.push_back({"frictional_pressure", "p_f", "Pa", "frictional pressure chi p_c, (10)", place, -1, 1});
  }
  return fields;
}

}  // namespace scree
