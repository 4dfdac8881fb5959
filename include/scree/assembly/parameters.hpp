/// Choices and numbers of the balances that concern more than one closure.
#pragma once

#include <array>

#include "scree/closures/stress.hpp"
#include "scree/grid/box.hpp"

namespace scree {

enum class AdvectionScheme { upwind, van_albada };

/// Choices of physics that concern more than one closure.
struct ModelParameters {
  TemperatureModel temperature = TemperatureModel::transport;
  double temperature_value = 1e-4;   ///< T where the model is `constant` [m2/s2]
  double temperature_floor = 1e-14;  ///< added to T under square roots [m2/s2]
  AdvectionScheme advection = AdvectionScheme::upwind;
  std::array<double, max_dim> gravity{0, 0, 0};                 ///< [m/s2]
  std::array<double, max_dim> mean_pressure_gradient{0, 0, 0};  ///< part of grad p_g beside that of p_g itself [Pa/m]
  std::array<double, max_dim> vibration_amplitude{0, 0, 0};     ///< the box moves as this times sin(2 pi f t) [m]
  double vibration_frequency = 0;                               ///< f [1/s]
  bool solids_moving = true;                                    ///< false: nu and v are frozen at their initial values
  bool gas_alone = false;               ///< T and chi are frozen too: used to make p_g and u consistent with the rest
  bool gas_viscous_stress = false;      ///< sigma_g of (5) in full; false: sigma_g = p_g I
  double darcy_solids_fraction = 1e-3;  ///< gas darcy: drag in voids is that of this solids fraction [-]
  double solids_fraction_floor = 1e-5;  ///< eps added to nu in storage, and in the void drag eps rho_s v/t_d [-]
  double void_drag_time = 1e-2;         ///< t_d of that drag [s]
};

}  // namespace scree
