/// Left-hand sides of all balances at a point of an exact solution: the strong form of src/MODEL.md, written here once
/// more and without a grid. Closures are those of the program, which have tests of their own.
#pragma once

#include "exact_fields.hpp"
#include "scree/assembly/parameters.hpp"
#include "scree/closures/drag.hpp"
#include "scree/closures/stress.hpp"
#include "scree/closures/wall.hpp"

namespace scree::test {

/// SI values of the balances, in the forms in which the program keeps them.
struct Sources {
  double nu = 0, p = 0, T = 0, chi = 0;
  std::array<double, max_dim> v{}, u{};
};

/// The balances about one point.
class StrongForm {
 public:
  using Number = Dual<Jet::axes>;

  StrongForm(const Point& q, int dim, const ModelParameters& model, const SolidsParameters& solids)
      : q_(q), dim_(dim), model_(model), solids_(solids), nu_(q.nu.number()), T_(q.T.number()), chi_(q.chi.number()) {
    for (int a = 0; a < dim_; ++a) {
      div_v_ += q_.v[a].slope(a);
      for (int b = 0; b < dim_; ++b) {
        const Number D = strain(a, b);
        S_S_ += D * D;
      }
    }
    S_S_ -= div_v_ * div_v_ / 3.0;
    slip_squared_ = find_slip_squared();
    closure_ = cell_closure(nu_, T_, chi_, div_v_, S_S_, slip_squared_, solids_);
  }

  Sources sources() const {
    Sources r;
    const double rho_s = solids_.kinetic.rho_s, rho_g = has_gas() ? solids_.gas.rho_g : 0, nu = q_.nu.value;
    r.nu = q_.nu.first[3];
    r.T = 1.5 * rho_s * nu * material(q_.T, q_.v) - closure_[CellClosure::energy_source].value;
    r.chi =
        nu * (material(q_.chi, q_.v) - (closure_[CellClosure::chi_star].value - q_.chi.value) / solids_.friction.tau);
    for (int a = 0; a < dim_; ++a) {
      r.nu += Number(nu_ * q_.v[a].number()).derivative[a];
      r.T += heat_flux(a).derivative[a];
      r.p += Number(nu_ * q_.v[a].number() + gas_flux(a)).derivative[a];
      r.v[a] = rho_s * nu * material(q_.v[a], q_.v) - (rho_s - rho_g) * nu * model_.gravity[a];
      for (int b = 0; b < dim_; ++b) r.v[a] += stress(a, b).derivative[b];
      if (!has_gas()) continue;
      const double gradient = q_.p.first[a];
      if (!has_u()) {  // drag is -(1-nu) grad p_g, over the solids fraction that darcy_flow takes
        const double floor = model_.darcy_solids_fraction;
        r.v[a] += nu * (1 + (1 - nu) / std::sqrt(nu * nu + floor * floor)) * gradient;
        continue;
      }
      const double drag = closure_[CellClosure::drag].value * (q_.u[a].value - q_.v[a].value);
      const double viscous = model_.gas_viscous_stress ? viscous_force(a) : 0;
      r.v[a] += nu * (gradient - viscous) - drag;
      r.u[a] = rho_g * (1 - nu) * material(q_.u[a], q_.u) + (1 - nu) * (gradient - viscous) + drag;
    }
    return r;
  }

  /// What momentum `a` of the particles on an open side gets beyond that of a point inside, `length` being the half
  /// cell of its control volume and `outwards` -1 on a lower side: the stress, which outside is 0 and here is not, and
  /// the weight of what has left and moves with it.
  double on_open_side(int a, int outwards, double length) const {
    const auto& g = model_.gravity;
    const double slow = 1e-1 * std::sqrt(std::hypot(g[0], g[1], g[2]) * solids_.kinetic.d);
    const double outflow = outwards * q_.v[a].value, left = q_.nu.value * outflow / (outflow + slow);
    const double rho_g = has_gas() ? solids_.gas.rho_g : 0;
    return -outwards * stress(a, a).value / length - (solids_.kinetic.rho_s - rho_g) * left * g[a];
  }

  /// Normal gradient of slip with which shear brings what the wall law (25) takes, axis 1 pointing from the wall [1/s].
  double shear_of_wall_law(const WallParameters& wall) const {
    const double slip = std::sqrt(slip_speed_squared());
    const double S_nn = strain(1, 1).value - div_v_.value / 3;
    const double N =
        closure_[CellClosure::frictional_pressure].value - 2 * closure_[CellClosure::frictional_viscosity].value * S_nn;
    return slip / closure_[CellClosure::viscosity].value *
           wall_traction_coefficient(q_.nu.value, closure_[CellClosure::sqrt_temperature].value, N, slip * slip,
                                     solids_.kinetic, wall);
  }
  /// Normal gradient of T with which conduction brings what (26) takes [m/s2].
  double T_gradient_of_wall_law(const WallParameters& wall) const {
    const double kappa = face_conductivity(q_.nu.value, q_.T.value, slip_squared_.value, solids_);
    return -wall_heat_flux(q_.nu.value, closure_[CellClosure::temperature].value,
                           closure_[CellClosure::sqrt_temperature].value, slip_speed_squared(), solids_.kinetic, wall) /
           kappa;
  }

 private:
  bool has_gas() const { return solids_.gas.model != GasModel::none; }
  bool has_u() const { return solids_.gas.model == GasModel::incompressible; }

  /// Relative to a wall at rest across axis 1.
  double slip_speed_squared() const {
    double sum = 0;
    for (int a = 0; a < dim_; ++a)
      if (a != 1) sum += q_.v[a].value * q_.v[a].value;
    return sum;
  }

  double material(const Jet& f, const std::array<Jet, max_dim>& velocity) const {
    double rate = f.first[3];
    for (int a = 0; a < dim_; ++a) rate += velocity[a].value * f.first[a];
    return rate;
  }
  Number strain(int a, int b) const { return 0.5 * (q_.v[a].slope(b) + q_.v[b].slope(a)); }

  Number find_slip_squared() const {
    Number sum(0.0);
    if (!has_gas()) return sum;
    for (int a = 0; a < dim_; ++a) {
      const Number w = has_u() ? q_.u[a].number() - q_.v[a].number() : q_.p.slope(a);
      sum += w * w;
    }
    if (has_u()) return sum;
    return darcy_slip_squared(nu_, sum, model_.darcy_solids_fraction, solids_.kinetic.d, solids_.gas);
  }
  /// sigma_ab of (8).
  Number stress(int a, int b) const {
    const Number deviator = a == b ? strain(a, a) - div_v_ / 3.0 : strain(a, b);
    const Number shear = -2.0 * closure_[CellClosure::viscosity] * deviator;
    return a == b ? closure_[CellClosure::pressure] + shear : shear;
  }
  /// (1.3).
  Number heat_flux(int a) const {
    const Number kappa = through(
        [&](const auto& nu, const auto& T, const auto& slip) { return face_conductivity(nu, T, slip, solids_); }, nu_,
        T_, slip_squared_);
    return -kappa * q_.T.slope(a);
  }
  /// (1-nu) u.
  Number gas_flux(int a) const {
    if (!has_gas()) return Number(0.0);
    if (has_u()) return (1.0 - nu_) * q_.u[a].number();
    Number squared(0.0);
    for (int b = 0; b < dim_; ++b) squared += q_.p.slope(b) * q_.p.slope(b);
    const Number mobility = darcy_mobility(nu_, squared, model_.darcy_solids_fraction, solids_.kinetic.d, solids_.gas);
    return (1.0 - nu_) * (q_.v[a].number() - mobility * q_.p.slope(a));
  }
  /// -div of the viscous part of (5), along a.
  double viscous_force(int a) const {
    double sum = 0;
    for (int b = 0; b < dim_; ++b) sum += q_.u[a].second[b][b] + q_.u[b].second[a][b] / 3;
    return solids_.gas.mu_g * sum;
  }

  const Point& q_;
  int dim_;
  const ModelParameters& model_;
  const SolidsParameters& solids_;
  Number nu_, T_, chi_, div_v_{0.0}, S_S_{0.0}, slip_squared_{0.0};
  std::array<Number, CellClosure::count> closure_;
};

}  // namespace scree::test
