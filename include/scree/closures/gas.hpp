/// The gas phase as the closures know it.
#pragma once

namespace scree {

struct DragLaw;  // drag.hpp

/// wen_yu, eqs. (6) and (7).
const DragLaw* default_drag_law();

/// none: particles in vacuum. darcy: the gas has no inertia; drag balances its pressure gradient at each face, so that
/// its velocity is no unknown. incompressible: (2) and (4) in full.
enum class GasModel { none, darcy, incompressible };

/// Properties of the gas (SI units).
struct GasParameters {
  GasModel model = GasModel::none;
  double rho_g = 1.3;                            ///< density, constant [kg/m3]
  double mu_g = 1.8e-5;                          ///< viscosity [Pa s]
  const DragLaw* drag_law = default_drag_law();  ///< one of drag_laws()
};

}  // namespace scree
