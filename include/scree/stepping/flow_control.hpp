/// Holds the flow of gas along a periodic axis by the mean gradient of p_g: numbers in, numbers out.
#pragma once

#include <array>

#include "scree/grid/box.hpp"

namespace scree {

/// What the gas in the box answers to a change of the gradient along an axis with, as if it were one:
///     inertia dU/dt + drag U + gradient = what else acts.
struct GasResistance {
  double inertia = 0;  ///< [kg/m3]
  double drag = 0;     ///< [kg/(m3 s)]
};

/// The gradient is constant in a step. After it, it is adjusted so that the next step would end with the velocity that
/// is wanted if all else that acts stayed: with U the superficial velocity, by
///     drag (U - wanted) + inertia (U - U_before)/dt + inertia (U - wanted)/dt_next,
/// of which half is taken, since the answer of the gas is known roughly. Where the flow is steady, U is exactly what is
/// wanted.
class FlowControl {
 public:
  explicit FlowControl(const std::array<double, max_dim>& gradient = {}) : gradient_(gradient) {}

  /// After a step of dt with the superficial velocity U [m/s]; dt_next is the step to come [s].
  void adjust(int axis, double U, double wanted, double dt, double dt_next, const GasResistance& gas) {
    const double before = started_[axis] ? velocity_[axis] : U;
    const double change = gas.drag * (U - wanted) + gas.inertia * ((U - before) / dt + (U - wanted) / dt_next);
    gradient_[axis] += share * change;
    velocity_[axis] = U;
    started_[axis] = true;
  }
  const std::array<double, max_dim>& gradient() const { return gradient_; }  ///< [Pa/m]

  /// For checkpoints: calls visit(name, member) for each number.
  template <class Visitor>
  void each_member(Visitor&& visit) {
    constexpr const char* names[max_dim][3] = {{"mean_pressure_gradient_x", "mean_gas_velocity_x", "flow_started_x"},
                                               {"mean_pressure_gradient_y", "mean_gas_velocity_y", "flow_started_y"},
                                               {"mean_pressure_gradient_z", "mean_gas_velocity_z", "flow_started_z"}};
    for (int axis = 0; axis < max_dim; ++axis) {
      visit(names[axis][0], gradient_[axis]);
      visit(names[axis][1], velocity_[axis]);
      visit(names[axis][2], started_[axis]);
    }
  }

 private:
  static constexpr double share = 0.5;
  std::array<double, max_dim> gradient_, velocity_{0, 0, 0};
  std::array<bool, max_dim> started_{false, false, false};  ///< whether velocity_ is that of a step before
};

}  // namespace scree
