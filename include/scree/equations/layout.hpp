/// Which unknowns a scene has and where they stand in a node of the grid. An absent unknown has no place: it is not
/// stored, not differentiated, not solved for.
#pragma once

#include <cstddef>
#include <vector>

#include "scree/equations/parameters.hpp"
#include "scree/grid/field.hpp"

namespace scree {

/// Unknowns of a node: nu, v per axis, T if it is transported, chi if it relaxes.
template <int Dim, bool TransportsT, bool RelaxesChi>
struct Layout {
  static constexpr int dim = Dim;
  static constexpr bool has_T = TransportsT;
  static constexpr bool has_chi = RelaxesChi;

  static constexpr int nu = 0;
  static constexpr int v(int axis) { return 1 + axis; }
  static constexpr int T = has_T ? 1 + dim : -1;
  static constexpr int chi = has_chi ? 1 + dim + (has_T ? 1 : 0) : -1;
  static constexpr int count = 1 + dim + (has_T ? 1 : 0) + (has_chi ? 1 : 0);

  static constexpr bool is_velocity(int component) { return component >= 1 && component <= dim; }
  static constexpr int axis_of(int component) { return component - 1; }
};

/// The unknowns of a layout with names, units and scales, in the order of their components.
template <class L>
std::vector<Field> fields_of(const Scales& scales) {
  std::vector<Field> fields;
  fields.push_back({"solids_fraction", "nu", "1", "solids volume fraction, (1)", L::nu, -1, 1});
  for (int axis = 0; axis < L::dim; ++axis)
    fields.push_back({"velocity", "v", "m/s", "particle velocity, (3)", L::v(axis), axis, scales.velocity});
  if (L::has_T)
    fields.push_back({"granular_temperature", "T", "m2/s2", "granular temperature, (9)", L::T, -1,
                      scales.velocity * scales.velocity});
  if (L::has_chi) fields.push_back({"frictional_pressure_ratio", "chi", "1", "p_f/p_c, (23)", L::chi, -1, 1});
  return fields;
}

}  // namespace scree
