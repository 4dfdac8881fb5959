/// The unknowns of the balances, and which of them a scene has.
#pragma once

#include <array>
#include <vector>

#include "scree/balances/layout.hpp"

namespace scree {

/// All, in the order in which they stand in a node.
inline constexpr std::array<const Unknown*, 7> standard_unknowns{
    &SolidsContinuity::unknown, &SolidsMomentum::unknown,     &GasMomentum::unknown, &GasContinuity::unknown,
    &GranularEnergy::unknown,   &FrictionRelaxation::unknown, &Fluidity::unknown};

/// Whether the balance of this unknown is solved; false for unknowns that are none of these.
inline bool is_present(const Unknown& unknown, const ModelParameters& model, const SolidsParameters& solids) {
  if (&unknown == &SolidsContinuity::unknown || &unknown == &SolidsMomentum::unknown) return true;
  if (&unknown == &GasMomentum::unknown) return solids.gas.model == GasModel::incompressible;
  if (&unknown == &GasContinuity::unknown) return solids.gas.model != GasModel::none;
  if (&unknown == &GranularEnergy::unknown) return model.temperature == TemperatureModel::transport;
  if (&unknown == &FrictionRelaxation::unknown) return solids.friction.model->has_unknown;
  if (&unknown == &Fluidity::unknown) return has_fluidity(solids.friction);
  return false;
}

inline std::vector<const Unknown*> present_unknowns(const ModelParameters& model, const SolidsParameters& solids) {
  std::vector<const Unknown*> present;
  for (const Unknown* unknown : standard_unknowns)
    if (is_present(*unknown, model, solids)) present.push_back(unknown);
  return present;
}

}  // namespace scree
