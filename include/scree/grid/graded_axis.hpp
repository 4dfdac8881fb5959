/// Faces along an axis from the sizes that cells are to have: small at some places, growing away from them.
#pragma once

#include <array>
#include <stdexcept>
#include <vector>

namespace scree {

/// What is wanted of the cells along an axis.
struct CellSizes {
  double lower = 0, upper = 1;  ///< ends of the axis [m]
  bool periodic = false;
  double finest = 0;           ///< size of the cells at the places `fine` [m]
  double coarsest = 0;         ///< greatest size, at least `finest` [m]
  double growth = 1.2;         ///< greatest ratio of neighbours, > 1 [-]
  std::vector<double> planes;  ///< where faces have to lie, in any order; those beyond the ends are left out [m]
  std::vector<double> fine;    ///< such planes at which cells have the size `finest`; an end may be one [m]
};

/// The part of `finest` by which a cell may be smaller, so that a whole number fits between two planes.
constexpr double finest_slack = 0.05;

/// Planes closer than this part of `finest` are one.
constexpr double same_plane = 5e-7;

/// No cells of the sizes that are wanted fit between two planes.
struct GradingError : std::runtime_error {
  GradingError(double lower_, double upper_);
  double lower, upper;  ///< the planes [m]
};

/// The size of the cells as a function of place, h(x). It is continuous, |dh/dx| <= ln(growth), and the integral of
/// dx/h between two planes is a whole number. Faces lie where the integral from a plane is whole: neighbours then
/// differ by `growth` at most, across planes and round a periodic axis too, and each cell is at least (1 -
/// finest_slack) `finest` and at most `coarsest`.
///
/// h is `finest` over the first cell beside a fine plane, and grows from there as fast as it may, up to a level: the
/// greatest, at most `coarsest`, with which the number of cells between two planes is whole. Where planes are so close
/// that there is none, h at these planes is less than it could be, or more than `finest`, as far as needed.
///
/// What is wanted symmetrically about 0 gives faces that are so to the last bit.
class GradedAxis {
 public:
  /// Throws GradingError.
  explicit GradedAxis(const CellSizes& wanted);

  /// Their number, which may be greater than an int.
  double cells() const;
  /// Positions of the faces, ascending [m]. With `refine`, each cell is cut into so many along the same h(x).
  std::vector<double> faces(int refine = 1) const;

  /// Between two planes: h at each, the length over which it stays so, and the level in between.
  struct Span {
    double lower, upper;
    std::array<double, 2> size, flat;
    double level = 0, number = 0;
  };

 private:
  double slope_;
  std::vector<Span> spans_;
};

}  // namespace scree
