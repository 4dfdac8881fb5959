/// A rheology: the frictional stress law together with the variable that relaxes in it, if it has one. It is chosen
/// once for a case; the closures of a cell and of an edge are compiled for each, without a branch inside. As a type:
///
///     struct MyRheology {
///       static constexpr const char *name = "my_rheology", *source = "Author (year), equation";
///       static constexpr bool has_friction = true;  // false: the functions below are not called
///       static constexpr bool has_unknown = false;  // true: chi is transported and relaxes to steady, eq. (23)
///       static constexpr bool uses_flow_rule = false;  // true: its stress has the exponent n of (14)
///       template <class Number>
///       static FrictionalStress<Number> stress(const FrictionalPoint<Number>& q, const FrictionParameters& p);
///       template <class Number>
///       static Number steady(const FrictionalPoint<Number>& q, const FrictionParameters& p);  // see CellClosure
///     };
///     friction_models().push_back(FrictionModel(rheology<MyRheology>));  // solids_closures.hpp; before reading a case
///
/// Its own parameters are static members. `stress` is smooth, finite for T, S:S -> 0, any chi and either sign of div v,
/// and its viscosity is not negative.
#pragma once

#include <array>
#include <cstddef>

#include "scree/closures/friction.hpp"

namespace scree {

/// What a rheology depends on at a point.
template <class Number>
struct FrictionalPoint {
  Number nu;        ///< solids fraction [-]
  Number T;         ///< granular temperature, by whatever model [m2/s2]
  Number chi;       ///< the transported variable, any constant where the rheology has none [-]
  Number div_v;     ///< [1/s]
  Number S_S;       ///< S:S of the three-dimensional deviator [1/s2]
  Number p_c;       ///< critical_pressure; on an edge the mean over its cells [Pa]
  Number gamma;     ///< fluctuating_strain_rate [1/s]
  Number g_f{1.0};  ///< fluidity, where the friction coefficient is that; any positive constant elsewhere [1/s]
};

/// sigma_f = pressure I - 2 viscosity S.
template <class Number>
struct FrictionalStress {
  Number pressure;   ///< p_f [Pa]
  Number viscosity;  ///< mu_f = -A/(2 gamma) [Pa s]
};

/// Names of the entries of cell_closure's result.
struct CellClosure {
  enum Entry : std::size_t {
    pressure,              ///< p of sigma_s = p I - 2 mu S, with the bulk term -eta mu_b div v [Pa]
    viscosity,             ///< mu of the same, kinetic + frictional [Pa s]
    energy_source,         ///< -sigma_k : grad v - J_coll - J_vis of (9); 0 up to floors where T is algebraic [W/m3]
    chi_star,              ///< (21); 1 or 0 for models critical_state and none [-]
    frictional_pressure,   ///< p_f [Pa]
    frictional_viscosity,  ///< sigma_f = p_f I - 2 mu_f S [Pa s]
    temperature,           ///< T of the temperature model [m2/s2]
    sqrt_temperature,      ///< regularised sqrt(T) [m/s]
    drag,                  ///< beta, 0 without gas [kg/(m3 s)]
    drag_over_nu,          ///< beta/nu, 0 without gas [kg/(m3 s)]
    count
  };
};

struct SolidsParameters;  // stress.hpp

template <class Number>
using CellClosures = std::array<Number, CellClosure::count>;

/// cell_closure of (nu, T, chi, div_v, S_S, slip_squared, g_f, p).
template <class Number>
using CellClosureFunction = CellClosures<Number> (*)(const Number&, const Number&, const Number&, const Number&,
                                                     const Number&, const Number&, const Number&,
                                                     const SolidsParameters&);

/// edge_closure of (nu, p_c, T, chi, div_v, S_S, slip_squared, g_f, p).
template <class Number>
using EdgeClosureFunction = Number (*)(const Number&, const Number&, const Number&, const Number&, const Number&,
                                       const Number&, const Number&, const Number&, const SolidsParameters&);

/// A rheology that a case can choose, with the closures compiled for it.
struct Rheology {
  const char *name, *source;
  bool has_friction, has_unknown, uses_flow_rule;
  PerNumber<CellClosureFunction, double, Dual<3>, Dual<4>, Dual<5>, Dual<6>> cell;
  PerNumber<EdgeClosureFunction, double, Dual<4>, Dual<5>, Dual<6>, Dual<7>> edge;
};

}  // namespace scree
