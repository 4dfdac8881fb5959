/// What particles press on a wall with, and their fraction there, from what is known in the cells before it.
#pragma once

#include "scree/math/rounded.hpp"

namespace scree {

/// A frictional stress normal to a wall [Pa], from that of the cell beside it: p varies along the normal as p_c does,
/// whose slope is that between the cell and the next one. To second order in the cell, which p of the cell alone is
/// not: the weight of half a cell is missing on a floor. `to_wall` is the distance from the cell's centre to the wall
/// over that to the next centre [-]. p_c of the next cell counts with no more than 1.8 times that of this one, since
/// p_c is no straight line where it grows by more.
template <class Number>
Number pressure_at_wall(const Number& p, const Number& p_c, const Number& p_c_next, double to_wall) {
  constexpr double steepest = 1.8, soft = 0.2, nothing = 1e-9;  // -, -, Pa
  if (!(p_c > nothing)) return p;
  return p * (1.0 + to_wall * (1.0 - rounded_minimum(Number(p_c_next / p_c), steepest, soft)));
}

/// A frictional stress normal to a floor under a cell, from that in the cell [Pa]: p, or what a layer no thicker than
/// the cell presses on the floor with. At rest that is its whole weight, twice `weight`, of which the cell carries
/// half: by p, or by sigma above where it is filled in part. Deep beds keep p.
template <class Number>
Number pressure_on_floor(const Number& p, const Number& sigma, const Number& weight) {
  constexpr double soft = 0.1, nothing = 1e-9;  // Pa
  if (!(weight > nothing) || p > (2 + soft) * weight) return p;
  const Number carried = rounded_minimum(Number((p + sigma) / weight), 1.0, soft);
  const Number missing = 2 * carried - p / weight;
  return p + weight * (p < weight ? missing : rounded_maximum(missing, 0, soft));
}

/// The solids fraction on a wall, from that of the cell beside it and of the next one; `to_wall` as above. The space
/// between particles over their own goes on by the same factor as between the cells, so that it neither ends nor
/// fills: second order in the cell. Where nu changes by more than half from cell to cell, as at surfaces, nothing is
/// known of the wall, and it is that of the cell.
template <class Number>
Number solids_fraction_at_wall(const Number& nu, const Number& nu_next, double nu_max, double to_wall) {
  constexpr double nothing = 1e-9;  // -
  if (!(nu > nothing && nu_next > nothing && nu < nu_max && nu_next < nu_max)) return nu;
  const Number change = (nu - nu_next) / (nu + nu_next);
  const Number smooth = integer_power(Number(1.0 - change * change), 3);
  const Number space = (nu_max - nu) / nu, space_next = (nu_max - nu_next) / nu_next;
  return nu_max / (1.0 + space * exp(to_wall * smooth * log(Number(space / space_next))));
}

}  // namespace scree
