/// The gas phase as the closures know it.
#pragma once

namespace scree {

/// none: particles in vacuum. darcy: the gas has no inertia; drag balances its pressure gradient at each face, so that
/// its velocity is no unknown. incompressible: (2) and (4) in full.
enum class GasModel { none, darcy, incompressible };

/// Properties of the gas (SI units).
struct GasParameters {
  GasModel model = GasModel::none;
  double rho_g = 1.3;    ///< density, constant [kg/m3]
  double mu_g = 1.8e-5;  ///< viscosity [Pa s]
};

}  // namespace scree
