/// Frictional stress, eqs. (10)-(24): parameters, p_c, and the yield surface and flow rule that rheologies share.
#pragma once

#include <limits>
#include <vector>

#include "scree/closures/fluidity.hpp"
#include "scree/closures/friction_pressure.hpp"
#include "scree/math/dual.hpp"
#include "scree/math/rounded.hpp"

namespace scree {

struct Rheology;  // rheology.hpp

/// The frictional model of a case: a rheology, by reference. The four of the paper have names here; FrictionModel(
/// rheology<R>) of solids_closures.hpp is one from outside.
class FrictionModel {
 public:
  constexpr explicit FrictionModel(const Rheology& rheology) : rheology_(&rheology) {}
  static const FrictionModel none, critical_state, instantaneous, relaxed;

  const Rheology* operator->() const { return rheology_; }
  friend bool operator==(FrictionModel a, FrictionModel b) { return a.rheology_ == b.rheology_; }
  friend bool operator!=(FrictionModel a, FrictionModel b) { return a.rheology_ != b.rheology_; }

 private:
  const Rheology* rheology_;
};

/// The models that options offer: none, critical_state, instantaneous, relaxed and what was appended.
std::vector<FrictionModel>& friction_models();

/// M of the yield surface, sin(phi) in the paper. constant: sin(phi). mu_i: M(I) with the flow rule (13) as it is;
/// cidr: with the one that belongs to it; mu_i_regularised: as mu_i, with another M at small and great I
/// (inertial.hpp). fluidity: the rate of shear over a fluidity that has a balance of its own (fluidity.hpp).
enum class FrictionCoefficient { constant, mu_i, cidr, mu_i_regularised, fluidity };

/// Parameters of the frictional closures (SI units).
struct FrictionParameters {
  FrictionModel model = FrictionModel::relaxed;
  const FrictionPressure* pressure = default_friction_pressure();  ///< p_c, one of friction_pressures()
  double phi = 0.49741883681838395;                                ///< angle of internal friction [rad], 28.5 deg
  double n_dilation = 1.8149628088422;  ///< exponent n where div v >= 0: sqrt(3)/(2 sin phi) [-]
  double n_compaction = 1.03;           ///< exponent n where div v < 0 [-]
  FrictionCoefficient coefficient = FrictionCoefficient::constant;
  double mu_2 = 0.6435;  ///< M of fast flow; that of slow flow is sin(phi) [-]
  double I_0 = 0.278;    ///< inertial number at which M is half way [-]
  FluidityParameters fluidity;
  double rho_s = 2900.0;            ///< solids density, in the inertial number [kg/m3]
  double F = 0.05;                  ///< constant of (18) [Pa]
  double r = 2.0;                   ///< exponent of (18) [-]
  double s = 5.0;                   ///< exponent of (18) [-]
  double nu_min = 0.5;              ///< threshold of (18) [-]
  double nu_max = 0.65;             ///< maximum packing [-]
  double tau = 1e-3;                ///< relaxation time of chi, (23) [s]
  double fluctuation = 1;           ///< c of S:S + c T/d^2: 1 as in (20)-(22), 0 as in (15)-(17) [-]
  double d = 1e-3;                  ///< particle diameter [m]
  bool lagged = false;              ///< chi of a step from the state before it, as segregated codes have it
  double strain_rate_floor = 1e-4;  ///< regularisation of sqrt(S:S + c T/d^2 + floor^2) [1/s]
  double flow_rule_floor = 0;       ///< rate of shear below which the flow rule (21) asks less and less [1/s]
};

/// Whether friction has a fluidity: fluidity.hpp.
inline bool has_fluidity(const FrictionParameters& p) { return p.coefficient == FrictionCoefficient::fluidity; }

/// Whether M is a function of the inertial number: inertial.hpp.
inline bool has_inertial_coefficient(const FrictionParameters& p) {
  return p.coefficient != FrictionCoefficient::constant && !has_fluidity(p);
}

// Widths of the rounded clips below, in the clipped quantity itself; outside of them the formulas are exact.
inline constexpr double dilation_clip_width = 1e-2;   ///< of the base of (21) at 0: chi* < 0.024 there
inline constexpr double compaction_clip_width = 0.1;  ///< of the same base at n/(n-1), relative
inline constexpr double yield_clip_width = 1e-2;      ///< of the braces of (14) at 0

/// base^exponent for base >= width, 0 for base <= 0, and between them the cubic that meets both with their slopes:
/// a power below one has an infinite slope at 0. 0 < exponent < 3.
template <class Number>
Number clipped_power(const Number& base, double exponent, double width) {
  if (base <= 0.0) return Number(0.0);
  if (base >= width) return exponent == 1 ? base : pow(base, exponent);
  const Number t = base / width;
  return std::pow(width, exponent) * (t * t * ((3 - exponent) + (exponent - 2) * t));
}

/// x^exponent for x > 0, by multiplications where the exponent is a small integer.
template <class Number>
Number real_power(const Number& x, double exponent) {
  const int whole = static_cast<int>(exponent);
  return exponent >= 0 && exponent == whole && whole <= 16 ? integer_power(x, whole) : Number(pow(x, exponent));
}

/// Critical-state pressure p_c by the variant of the case, eq. (18) by default [Pa]; 0 up to nu_min, where it starts
/// with zero slope. Infinite from nu_max on: such a trial state is for the solver to refuse, it is not capped here.
template <class Number>
Number critical_pressure(const Number& nu, const FrictionParameters& p) {
  if (nu <= p.nu_min) return Number(0.0);
  if (nu >= p.nu_max) return Number(std::numeric_limits<double>::infinity());
  return by_one_argument<FrictionPressureFunction>(p.pressure->p_c, nu, p);
}

/// Exponent n of (21): the one of dilation or of compaction by the sign of div v. (21) is continuous across the switch,
/// its slope jumps.
template <class Number>
double yield_exponent(const Number& div_v, const FrictionParameters& p) {
  return div_v >= 0.0 ? p.n_dilation : p.n_compaction;
}

/// Tip of the yield surface in compaction, (n/(n-1))^(n-1), where A of (14) vanishes: chi stays below [-].
inline double maximum_chi(const FrictionParameters& p) {
  const double n = p.n_compaction;
  return std::pow(n / (n - 1), n - 1);
}

/// sqrt(2) sin(phi) [-]: ratio of the norm of the frictional deviator to p_f at the critical state.
inline double friction_coefficient(const FrictionParameters& p) { return std::sqrt(2.0) * std::sin(p.phi); }

/// Strain rate of (20) and (21): sqrt(S:S + c T/d^2 + floor^2), with c = 0 that of the unmodified forms (15)-(17)
/// [1/s].
template <class Number>
Number fluctuating_strain_rate(const Number& S_S, const Number& T, const FrictionParameters& p) {
  const double floor = p.strain_rate_floor * p.strain_rate_floor;
  return Number(sqrt(S_S + p.fluctuation * T / (p.d * p.d) + floor));
}

/// 1 - div v/(n sqrt(2) sin(phi) gamma) of (21), bounded above by n/(n-1), the tip of the yield surface [-].
/// It equals chi*^(1/(n-1)). Negative where the dilation is faster than the flow rule allows. Without T/d^2 both rates
/// vanish in a bed at rest and their ratio is anything: flow_rule_floor adds to gamma, so that such a bed is at its
/// critical state.
template <class Number>
Number chi_star_base(const Number& div_v, const Number& gamma, const FrictionParameters& p) {
  const double n = yield_exponent(div_v, p);
  const Number rate = sqrt(gamma * gamma + p.flow_rule_floor * p.flow_rule_floor);
  const Number base = 1.0 - div_v / (n * friction_coefficient(p) * rate);
  const double tip = n / (n - 1);
  return rounded_minimum(base, tip, compaction_clip_width * tip);
}

/// Scaled frictional pressure in steady state, chi*, eq. (21)/(24) [-], gamma from fluctuating_strain_rate.
/// Exponent n-1 follows from (13) on (14); the scan prints 1/(n-1), see src/MODEL.md.
/// Dilation clips at 0, compaction stays below (n/(n-1))^(n-1); both clips are rounded, see the widths above.
template <class Number>
Number chi_star(const Number& div_v, const Number& gamma, const FrictionParameters& p) {
  return clipped_power(chi_star_base(div_v, gamma, p), yield_exponent(div_v, p) - 1, dilation_clip_width);
}

/// -A/p_f of (14): sqrt(2) sin(phi) {n - (n-1) chi^(1/(n-1))} with chi^(1/(n-1)) given as `base` [-].
/// 0 from the tip of the yield surface on, rounded.
template <class Number>
Number yield_factor_of_base(const Number& base, double n, const FrictionParameters& p) {
  return friction_coefficient(p) * clipped_power(Number(n - (n - 1) * base), 1, yield_clip_width);
}

/// The same from chi with the n of one branch. Beyond the tip of the yield surface it is 0 without a power: chi^33
/// overflows.
template <class Number>
Number yield_factor_of_branch(const Number& chi, double n, const FrictionParameters& p) {
  if (chi <= 0.0) return Number(friction_coefficient(p) * n);
  if (chi >= 2.0 * n) return Number(0.0);  // (n/(n-1))^(n-1) < 2 n for every n > 1
  return yield_factor_of_base(Number(pow(chi, 1 / (n - 1))), n, p);
}

/// The same on the whole yield surface: for chi < 1 the branch of dilation, for chi > 1 that of compaction. By (13) it
/// is the branch that the sign of div v chooses wherever the flow rule holds, and both have one slope at chi = 1. With
/// the sign of div v the stress would jump at div v = 0 where chi has not relaxed to 1, and Newton's method with it in
/// a bed that hardly moves.
template <class Number>
Number yield_factor(const Number& chi, const FrictionParameters& p) {
  return yield_factor_of_branch(chi, chi < 1.0 ? p.n_dilation : p.n_compaction, p);
}

}  // namespace scree
