/// A list of unknowns as a type: how many components a node has, and where each stands. An absent unknown has no place:
/// it is not stored, not differentiated, not solved for.
#pragma once

#include <type_traits>
#include <vector>

#include "scree/grid/box.hpp"
#include "scree/grid/unknown.hpp"

namespace scree {

/// The components of unknowns with names, units and scales.
inline std::vector<Field> fields_of(const std::vector<const Unknown*>& unknowns, int dim, const Scales& scales) {
  std::vector<Field> list;
  for (const Unknown* u : unknowns)
    for (int axis = 0; axis < (u->place == Place::face ? dim : 1); ++axis)
      list.push_back({u->dataset, u->symbol, u->unit, u->text, static_cast<int>(list.size()),
                      u->place == Place::face ? axis : -1, u->scale(scales), u});
  return list;
}

/// `Balances` each have a member `unknown`; they stand in a node in this order, vectors axis by axis.
template <int Dim, class... Balances>
struct UnknownList {
  static constexpr int dim = Dim;
  static constexpr int extent(const Unknown& unknown) { return unknown.place == Place::face ? dim : 1; }
  static constexpr int count = (0 + ... + extent(Balances::unknown));  ///< components of a node

  template <class Balance>
  static constexpr bool has = (std::is_same_v<Balance, Balances> || ...);

  /// First component of an unknown in the node; -1 where it is absent.
  template <class Balance>
  static constexpr int first() {
    int at = 0, found = -1;
    ((found = std::is_same_v<Balance, Balances> ? at : found, at += extent(Balances::unknown)), ...);
    return found;
  }
  template <class Balance>
  static constexpr bool is(int component) {
    return has<Balance> && component >= first<Balance>() && component < first<Balance>() + extent(Balance::unknown);
  }
  static constexpr bool is_velocity(int component) {
    return ((Balances::unknown.place == Place::face && is<Balances>(component)) || ...);
  }
  /// Axis of a component that is a velocity.
  static constexpr int axis_of(int component) {
    int axis = -1;
    ((axis = is<Balances>(component) ? component - first<Balances>() : axis), ...);
    return axis;
  }

  /// Calls work(Balance{}) for each, in their order.
  template <class Work>
  static void for_each(Work&& work) {
    (work(Balances{}), ...);
  }

  static std::vector<Field> fields(const Scales& scales) { return fields_of({&Balances::unknown...}, dim, scales); }
};

}  // namespace scree
