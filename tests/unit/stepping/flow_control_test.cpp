/// Plants of the form inertia dU/dt + drag U + gradient = force, in implicit steps.
#include "scree/stepping/flow_control.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace scree {
namespace {

struct Plant {
  double inertia, drag, force, U = 0;

  void step(double dt, double gradient) { U = (inertia * U / dt + force - gradient) / (inertia / dt + drag); }
};

/// Runs to the end; the greatest error of U over the last steps, and the gradient.
struct Held {
  double error = 0, gradient = 0;
};
Held hold(Plant plant, double wanted, const GasResistance& estimate) {
  FlowControl control({0, 0, 0});
  Held held;
  double dt = 1e-3;
  for (int step = 0; step < 400; ++step) {
    plant.step(dt, control.gradient()[1]);
    const double next = step % 7 == 0 ? 0.5 * dt : 1.12 * dt;  // steps that change
    control.adjust(1, plant.U, wanted, dt, next, estimate);
    dt = next;
    if (step > 350) held.error = std::max(held.error, std::abs(plant.U - wanted));
  }
  held.gradient = control.gradient()[1];
  return held;
}

TEST(FlowControl, HoldsTheFlowExactlyWhereItIsSteady) {
  for (const auto& [inertia, drag] : {std::pair(1.3, 0.0), std::pair(0.0, 5e3), std::pair(1.3, 400.0)}) {
    const Held held = hold({inertia, drag, -900}, 0.4, {inertia, drag});
    EXPECT_LT(held.error, 1e-10) << inertia << " " << drag;
    EXPECT_NEAR(held.gradient, -900 - 0.4 * drag, 1e-6 * 900);
  }
}

TEST(FlowControl, StandsARoughEstimate) {
  for (const double factor : {0.4, 1.6}) {
    const Held held = hold({1.3, 400, -900}, 0.4, {1.3 * factor, 400 * factor});
    EXPECT_LT(held.error, 1e-8) << factor;
  }
}

TEST(FlowControl, LeavesOtherAxesAlone) {
  FlowControl control({7, 8, 9});
  control.adjust(1, 1, 2, 0.1, 0.1, {1, 1});
  EXPECT_EQ(control.gradient()[0], 7);
  EXPECT_EQ(control.gradient()[2], 9);
  EXPECT_DOUBLE_EQ(control.gradient()[1], 8 + 0.5 * (-1 - 10));
}

}  // namespace
}  // namespace scree
