/// What closes the box: named segments of its sides and named internal plates, each with a condition of some kind
/// (kind.hpp).
#pragma once

#include <array>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "scree/boundary/inlet_variation.hpp"
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

/// What happens at a face of a side or plate.
struct Condition {
  std::string name;
  BoundaryKind kind = BoundaryKind::wall_johnson_jackson;
  std::array<double, max_dim> velocity{0, 0, 0};  ///< of the wall, or of the particles that an inlet brings [m/s]
  std::vector<std::pair<const Unknown*, double>> brings;  ///< scalars that come in where the kind prescribes them [SI]
  WallParameters wall;                                    ///< wall_johnson_jackson only
  double gas_velocity = 0;         ///< inlet and gas_inlet: superficial velocity of the gas into the box [m/s]
  InletVariation variation;        ///< inlet: of the velocity of the particles
  InletVariation gas_variation;    ///< inlet and gas_inlet: of gas_velocity
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

/// Superficial velocity of the gas that `condition` lets into the box through a face at a time [m/s].
double gas_inflow(const Condition& condition, const FaceExtent& face, double time);

/// Component `axis` of the velocity that `condition` prescribes to the particles at a face and a time: of a wall, or of
/// what an inlet brings there [m/s].
double solids_velocity(const Condition& condition, int axis, const FaceExtent& face, double time);

/// A part of one side of the box. Where segments overlap, the later one in the list holds.
struct Segment {
  Condition condition;
  int axis = 0;        ///< axis normal to the side
  bool upper = false;  ///< false: lower side, true: upper side
  Patch patch;
};

/// A zero-thickness wall on a grid plane inside the box, with openings; both of its sides follow the condition. It is
/// there in the time window of the condition, and may slide in its plane as a whole, span and openings.
struct Plate {
  Condition condition;  ///< one of the wall kinds
  int axis = 1;         ///< axis normal to the plate
  double position = 0;  ///< coordinate along that axis, on a grid plane [m]
  Patch span;           ///< where the plate is; default: everywhere
  std::vector<Patch> openings;
  int slide_axis = 0;                                                            ///< in its plane
  double slide_speed = 0;                                                        ///< along that axis; 0: it stays [m/s]
  double slide_from = 0, slide_until = std::numeric_limits<double>::infinity();  ///< when it slides [s]

  bool slides() const { return slide_speed != 0; }
  bool present(double time) const { return time >= condition.from && time < condition.until; }
  /// As it is at a time: moved, and with the speed at which it slides added to its velocity.
  Plate at(double time) const;
  /// Times at which it comes, goes, begins or ends to slide, or at which one of its edges passes the centre of a cell,
  /// `centres` being those along slide_axis: between them no face opens or closes. Unordered, all finite.
  std::vector<double> events(const std::vector<double>& centres) const;
};

}  // namespace scree
