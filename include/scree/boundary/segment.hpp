/// What closes the box: named segments of its sides and named internal plates, each with a condition of some kind
/// (kind.hpp).
#pragma once

#include <array>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "scree/boundary/kind.hpp"
#include "scree/closures/wall.hpp"
#include "scree/grid/box.hpp"
#include "scree/grid/unknown.hpp"

namespace scree {

/// A rectangle in the plane of a side or plate; an interval in two dimensions. The entries of the normal axis are
/// unused.
struct Patch {
  std::array<double, max_dim> lower;
  std::array<double, max_dim> upper;
  Patch() {
    lower.fill(-std::numeric_limits<double>::infinity());
    upper.fill(std::numeric_limits<double>::infinity());
  }
};

/// A factor that is piecewise linear in a coordinate or in time and constant beyond its ends; 1 if it has no points.
struct Ramp {
  std::vector<double> at;      ///< ascending [m or s]
  std::vector<double> factor;  ///< as many [-]

  double value(double x) const;
};

/// What happens at a face of a side or plate.
struct Condition {
  std::string name;
  BoundaryKind kind = BoundaryKind::wall_johnson_jackson;
  std::array<double, max_dim> velocity{0, 0, 0};  ///< of the wall, or of the particles that an inlet brings [m/s]
  std::vector<std::pair<const Unknown*, double>> brings;  ///< scalars that come in where the kind prescribes them [SI]
  WallParameters wall;                                    ///< wall_johnson_jackson only
  double gas_velocity = 0;         ///< inlet and gas_inlet: superficial velocity of the gas into the box [m/s]
  int gas_profile_axis = 0;        ///< axis along the side in which that varies
  Ramp gas_profile;                ///< its factor along that axis
  Ramp gas_history;                ///< its factor in time
  double gas_pressure = 0;         ///< open only: p_g outside, over that of still gas [Pa]
  bool gas_enters_at_rest = true;  ///< open only: what comes in has lost its dynamic head rho_g u^2/2
  bool gas_no_slip = false;        ///< walls only: the gas sticks to the wall; acts where the gas has viscous stress
  double from = -std::numeric_limits<double>::infinity();  ///< start of the time window [s]
  double until = std::numeric_limits<double>::infinity();  ///< end of the time window [s]

  /// What comes in of a scalar of the particles [SI].
  double brought(const Unknown& unknown) const {
    for (const auto& [of, value] : brings)
      if (of == &unknown) return value;
    return unknown.inlet.otherwise;
  }
  void bring(const Unknown& unknown, double value) {
    for (auto& [of, brought] : brings)
      if (of == &unknown) return void(brought = value);
    brings.emplace_back(&unknown, value);
  }
};

/// Superficial velocity of the gas that `condition` lets into the box at a place on its side and a time [m/s].
double gas_inflow(const Condition& condition, const std::array<double, max_dim>& place, double time);

/// A part of one side of the box. Where segments overlap, the later one in the list holds.
struct Segment {
  Condition condition;
  int axis = 0;        ///< axis normal to the side
  bool upper = false;  ///< false: lower side, true: upper side
  Patch patch;
};

/// A zero-thickness wall on a grid plane inside the box, with openings; both of its sides follow the condition.
struct Plate {
  Condition condition;  ///< one of the wall kinds
  int axis = 1;         ///< axis normal to the plate
  double position = 0;  ///< coordinate along that axis, on a grid plane [m]
  Patch span;           ///< where the plate is; default: everywhere
  std::vector<Patch> openings;
};

}  // namespace scree
