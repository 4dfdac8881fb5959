/// Which unknowns a scene has and where they stand in a node of the grid. An absent unknown has no place: it is not
/// stored, not differentiated, not solved for.
#pragma once

#include <cstddef>
#include <vector>

#include "scree/assembly/parameters.hpp"
#include "scree/grid/field.hpp"

namespace scree {

/// The unknowns that stand at the same places in all layouts with this gas: nu, v per axis, u per axis if the gas is
/// incompressible, p_g. Kernels that need no others are written for it, and compiled once for all these layouts.
template <int Dim, GasModel Gas>
struct CoreLayout {
  static constexpr int dim = Dim;
  static constexpr bool has_gas = Gas != GasModel::none;          ///< and p_g
  static constexpr bool has_u = Gas == GasModel::incompressible;  ///< otherwise u follows from p_g (darcy)

  static constexpr int nu = 0;
  static constexpr int v(int axis) { return 1 + axis; }
  static constexpr int u(int axis) { return has_u ? 1 + dim + axis : -1; }
  static constexpr int p = has_gas ? 1 + dim + (has_u ? dim : 0) : -1;
  static constexpr int core_count = 1 + dim + (has_u ? dim : 0) + has_gas;

  static constexpr bool is_v(int component) { return component >= 1 && component <= dim; }
  static constexpr bool is_u(int component) { return has_u && component > dim && component <= 2 * dim; }
  static constexpr bool is_velocity(int component) { return is_v(component) || is_u(component); }
  static constexpr int axis_of(int component) { return (component - 1) % dim; }
};

/// Unknowns of a node: those of the core, T if it is transported, chi if it relaxes.
template <int Dim, bool TransportsT, bool RelaxesChi, GasModel Gas>
struct Layout : CoreLayout<Dim, Gas> {
  using Core = CoreLayout<Dim, Gas>;
  static constexpr bool has_T = TransportsT;
  static constexpr bool has_chi = RelaxesChi;

  static constexpr int T = has_T ? Core::core_count : -1;
  static constexpr int chi = has_chi ? Core::core_count + has_T : -1;
  static constexpr int count = Core::core_count + has_T + has_chi;
};

/// The unknowns of a layout with names, units and scales, in the order of their components.
template <class L>
std::vector<Field> fields_of(const Scales& scales) {
  std::vector<Field> fields;
  const double V = scales.velocity;
  fields.push_back({"solids_fraction", "nu", "1", "solids volume fraction, (1)", L::nu, -1, 1});
  for (int axis = 0; axis < L::dim; ++axis)
    fields.push_back({"velocity", "v", "m/s", "particle velocity, (3)", L::v(axis), axis, V});
  for (int axis = 0; axis < L::dim && L::has_u; ++axis)
    fields.push_back({"gas_velocity", "u", "m/s", "gas velocity between the particles, (4)", L::u(axis), axis, V});
  if (L::has_gas)
    fields.push_back(
        {"gas_pressure", "p_g", "Pa", "gas pressure over that of still gas, (2)", L::p, -1, scales.density * V * V});
  if (L::has_T) fields.push_back({"granular_temperature", "T", "m2/s2", "granular temperature, (9)", L::T, -1, V * V});
  if (L::has_chi) fields.push_back({"frictional_pressure_ratio", "chi", "1", "p_f/p_c, (23)", L::chi, -1, 1});
  return fields;
}

}  // namespace scree
