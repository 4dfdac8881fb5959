/// The kinds of boundary as a table: what each does to every unknown. Kernels ask the table, never which kind it is, so
/// that a kind is a row of answers and nothing else.
#pragma once

#include <array>
#include <stdexcept>
#include <string_view>

namespace scree {

/// Velocity of the particles normal to the face: that of the wall; zero; from (3) with no stress outside, they leave;
/// prescribed.
enum class SolidsNormal { wall, zero, open, prescribed };
/// What shears the particles along the face: nothing, by symmetry or a smooth wall; Coulomb friction and collisions
/// (25), (26); a wall that they stick to; nothing of its own, the shear goes on as inside.
enum class SolidsTangential { free, johnson_jackson, no_slip, continued };
/// nu, T, chi and other scalars of the particles: no flux; carried out, inflow brings nothing; prescribed values come
/// in.
enum class Scalars { closed, outflow, prescribed };
/// Velocity of the gas normal to the face: that of the wall; zero; from (4); prescribed superficial velocity.
enum class GasNormal { wall, zero, open, prescribed };
/// What shears the gas along the face: the wall, if it is one to which gas sticks; nothing; inlets blow straight in.
enum class GasTangential { wall, free, none };
/// p_g at the face: no condition; prescribed, over that of still gas outside.
enum class GasPressure { free, prescribed };

/// One row of the table. There is no default: a kind that leaves an answer out does not compile.
struct BoundaryKind {
  std::string_view name;
  std::string_view text;
  SolidsNormal solids_normal;
  SolidsTangential solids_tangential;
  Scalars scalars;
  GasNormal gas_normal;
  GasTangential gas_tangential;
  GasPressure gas_pressure;

  constexpr BoundaryKind(std::string_view name_, std::string_view text_, SolidsNormal solids_normal_,
                         SolidsTangential solids_tangential_, Scalars scalars_, GasNormal gas_normal_,
                         GasTangential gas_tangential_, GasPressure gas_pressure_)
      : name(name_),
        text(text_),
        solids_normal(solids_normal_),
        solids_tangential(solids_tangential_),
        scalars(scalars_),
        gas_normal(gas_normal_),
        gas_tangential(gas_tangential_),
        gas_pressure(gas_pressure_) {
    // In a constant expression a throw does not compile.
    if (!consistent()) throw std::logic_error("a kind of boundary whose answers contradict each other");
  }

  /// Gas passes freely just where a pressure outside drives it, and scalars do as the particles do.
  constexpr bool consistent() const {
    const bool gas = (gas_normal == GasNormal::open) == (gas_pressure == GasPressure::prescribed);
    const bool in = (solids_normal == SolidsNormal::prescribed) == (scalars == Scalars::prescribed);
    const bool out = (solids_normal == SolidsNormal::open) == (scalars == Scalars::outflow);
    return gas && in && out;
  }

  constexpr bool stops_solids() const {
    return solids_normal == SolidsNormal::wall || solids_normal == SolidsNormal::zero;
  }
  constexpr bool lets_solids_out() const { return solids_normal == SolidsNormal::open; }
  constexpr bool brings_solids() const { return scalars == Scalars::prescribed; }
  constexpr bool shears_solids() const {
    return solids_tangential == SolidsTangential::johnson_jackson || solids_tangential == SolidsTangential::no_slip;
  }
  constexpr bool stops_gas() const { return gas_normal == GasNormal::wall || gas_normal == GasNormal::zero; }
  constexpr bool open_to_gas() const { return gas_normal == GasNormal::open; }
  constexpr bool brings_gas() const { return gas_normal == GasNormal::prescribed; }
  /// Whether it can be an internal plate: it keeps particles and gas on their side.
  constexpr bool is_wall() const { return solids_normal == SolidsNormal::wall && gas_normal == GasNormal::wall; }
  /// Whether it has a velocity of its own.
  constexpr bool moves() const {
    return solids_normal == SolidsNormal::wall || solids_normal == SolidsNormal::prescribed;
  }

  friend constexpr bool operator==(const BoundaryKind& a, const BoundaryKind& b) { return a.name == b.name; }
  friend constexpr bool operator!=(const BoundaryKind& a, const BoundaryKind& b) { return !(a == b); }

  static const BoundaryKind wall_johnson_jackson, wall_free_slip, wall_no_slip, symmetry, open, inlet, gas_inlet;
};

// clang-format off
inline constexpr BoundaryKind BoundaryKind::wall_johnson_jackson{
    "wall_johnson_jackson", "wall with Coulomb friction and collisions, (25) and (26)",
    SolidsNormal::wall, SolidsTangential::johnson_jackson, Scalars::closed,
    GasNormal::wall, GasTangential::wall, GasPressure::free};
inline constexpr BoundaryKind BoundaryKind::wall_free_slip{
    "wall_free_slip", "smooth wall",
    SolidsNormal::wall, SolidsTangential::free, Scalars::closed,
    GasNormal::wall, GasTangential::wall, GasPressure::free};
inline constexpr BoundaryKind BoundaryKind::wall_no_slip{
    "wall_no_slip", "wall to which particles stick",
    SolidsNormal::wall, SolidsTangential::no_slip, Scalars::closed,
    GasNormal::wall, GasTangential::wall, GasPressure::free};
inline constexpr BoundaryKind BoundaryKind::symmetry{
    "symmetry", "plane of symmetry",
    SolidsNormal::zero, SolidsTangential::free, Scalars::closed,
    GasNormal::zero, GasTangential::free, GasPressure::free};
inline constexpr BoundaryKind BoundaryKind::open{
    "open", "particles leave, gas passes at a given pressure outside",
    SolidsNormal::open, SolidsTangential::continued, Scalars::outflow,
    GasNormal::open, GasTangential::free, GasPressure::prescribed};
inline constexpr BoundaryKind BoundaryKind::inlet{
    "inlet", "particles and gas come in",
    SolidsNormal::prescribed, SolidsTangential::continued, Scalars::prescribed,
    GasNormal::prescribed, GasTangential::none, GasPressure::free};
inline constexpr BoundaryKind BoundaryKind::gas_inlet{
    "gas_inlet", "gas comes in, particles stay",
    SolidsNormal::zero, SolidsTangential::free, Scalars::closed,
    GasNormal::prescribed, GasTangential::none, GasPressure::free};
// clang-format on

/// The kinds that every case may name, in the order of the tables.
inline constexpr std::array<const BoundaryKind*, 7> standard_boundary_kinds{&BoundaryKind::wall_johnson_jackson,
                                                                            &BoundaryKind::wall_free_slip,
                                                                            &BoundaryKind::wall_no_slip,
                                                                            &BoundaryKind::symmetry,
                                                                            &BoundaryKind::open,
                                                                            &BoundaryKind::inlet,
                                                                            &BoundaryKind::gas_inlet};

}  // namespace scree
