/// The balances of a scene as a list, and their unknowns by the names that kernels use.
#pragma once

#include "scree/assembly/parameters.hpp"
#include "scree/assembly/unknown_list.hpp"
#include "scree/balances/fluidity.hpp"
#include "scree/balances/friction_relaxation.hpp"
#include "scree/balances/gas_continuity.hpp"
#include "scree/balances/gas_momentum.hpp"
#include "scree/balances/granular_energy.hpp"
#include "scree/balances/solids_continuity.hpp"
#include "scree/balances/solids_momentum.hpp"

namespace scree {

/// The places of a list of balances by the symbols of MODEL.md; -1 for what the list does not hold.
template <class List>
struct Named : List {
  static constexpr bool has_gas = List::template has<GasContinuity>;  ///< and p_g
  static constexpr bool has_u = List::template has<GasMomentum>;      ///< otherwise u follows from p_g (darcy)
  static constexpr bool has_T = List::template has<GranularEnergy>;
  static constexpr bool has_chi = List::template has<FrictionRelaxation>;
  static constexpr bool has_g_f = List::template has<Fluidity>;

  static constexpr int nu = List::template first<SolidsContinuity>();
  static constexpr int v(int axis) { return List::template first<SolidsMomentum>() + axis; }
  static constexpr int u(int axis) { return has_u ? List::template first<GasMomentum>() + axis : -1; }
  static constexpr int p = List::template first<GasContinuity>();
  static constexpr int T = List::template first<GranularEnergy>();
  static constexpr int chi = List::template first<FrictionRelaxation>();
  static constexpr int g_f = List::template first<Fluidity>();

  static constexpr bool is_v(int component) { return List::template is<SolidsMomentum>(component); }
  static constexpr bool is_u(int component) { return List::template is<GasMomentum>(component); }
};

/// Two lists, one after the other.
template <class List, class... More>
struct Extended;
template <int dim, class... Balances, class... More>
struct Extended<UnknownList<dim, Balances...>, More...> {
  using type = UnknownList<dim, Balances..., More...>;
};

/// `More` where the condition holds.
template <bool condition, class List, class More>
using ExtendedIf = typename std::conditional_t<condition, Extended<List, More>, Extended<List>>::type;

template <int dim, GasModel gas>
using CoreList = ExtendedIf<
    gas != GasModel::none,
    ExtendedIf<gas == GasModel::incompressible, UnknownList<dim, SolidsContinuity, SolidsMomentum>, GasMomentum>,
    GasContinuity>;

template <bool transports_T, bool relaxes_chi, class Core, class... Scalars>
using FullList =
    typename Extended<ExtendedIf<relaxes_chi, ExtendedIf<transports_T, Core, GranularEnergy>, FrictionRelaxation>,
                      Scalars...>::type;

/// The unknowns that stand at the same places in all layouts with this gas. Kernels that need no others are written for
/// it, and compiled once for all these layouts.
template <int dim, GasModel gas>
struct CoreLayout : Named<CoreList<dim, gas>> {};

/// The unknowns of a scene: those of the core, T if it is transported, chi if it relaxes, and scalars that are carried
/// by the particles (kernels/carried_scalar.hpp), such as the fluidity.
template <int dim, bool transports_T, bool relaxes_chi, GasModel gas, class... Scalars>
struct Layout : Named<FullList<transports_T, relaxes_chi, CoreList<dim, gas>, Scalars...>> {
  using Core = CoreLayout<dim, gas>;

  /// Calls work(Scalar{}) for each of the further scalars.
  template <class Work>
  static void for_each_scalar(Work&& work) {
    (work(Scalars{}), ...);
  }
};

}  // namespace scree
