#include "scree/app/initial_state.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "scree/app/initial_run.hpp"
#include "scree/balances/layout.hpp"
#include "scree/config/input_error.hpp"
#include "scree/config/quantity.hpp"

namespace scree {

namespace {

/// The root of p_c(nu) (1 + loss/2) = carried + weight nu/2 in (nu_min, nu_max): p_c rises from 0 to infinity.
double solids_fraction_under(double carried, double weight, double loss, const FrictionParameters& friction) {
  double low = friction.nu_min, high = friction.nu_max;
  for (int k = 0; k < 200 && high - low > 1e-16 * high; ++k) {
    const double nu = 0.5 * (low + high);
    (critical_pressure(nu, friction) * (1 + loss) < carried + weight * nu ? low : high) = nu;
  }
  return 0.5 * (low + high);
}

int gravity_axis(const std::array<double, max_dim>& gravity) {
  int axis = 0;
  for (int a = 1; a < max_dim; ++a)
    if (std::abs(gravity[a]) > std::abs(gravity[axis])) axis = a;
  return axis;
}

/// Solids fraction of a region as a function of place.
class SolidsFraction {
 public:
  SolidsFraction(const InitialRegion& region, const Case& the_case, const Lattice& grid)
      : region_(region), axis_(region.table_axis) {
    if (region.profile != InitialRegion::Profile::equilibrium) return;
    axis_ = gravity_axis(the_case.model.gravity);
    const double g = the_case.model.gravity[axis_];
    column_ = equilibrium_column(grid.axes[axis_], std::abs(g), g < 0 ? -1 : 1, region.surface, region.janssen_width,
                                 the_case);
  }
  double at(const Lattice& grid, const Index& I, double uniform) const {
    if (!region_.has_own_solids_fraction()) return uniform;
    if (!column_.empty()) return column_[static_cast<std::size_t>(I[axis_])];
    return region_.table_values.value(grid.axes[axis_].centre(I[axis_]));
  }

 private:
  const InitialRegion& region_;
  int axis_;
  std::vector<double> column_;
};

/// A component of v: `uniform` with the gradient of the region; on walls that of the wall [m/s].
double initial_velocity(const InitialRegion& region, const DiscreteProblem& problem, int axis, const Index& I,
                        const std::array<double, max_dim>& at, double uniform) {
  if (problem.barriers().wall(axis, I)) return problem.barriers().condition(axis, I).velocity[axis];
  for (int b = 0; b < problem.box().dim; ++b)
    uniform += region.velocity_gradient[max_dim * axis + b] * (at[b] - problem.box().lower(b));
  return uniform;
}

/// Sets what the region gives, at the owned nodes in it.
void fill_region(const Case& the_case, const InitialRegion& region, const DiscreteProblem& problem,
                 const InitialRun* run, Vec state) {
  const Lattice& grid = problem.lattice();
  const Model& model = problem.model();
  const SolidsFraction solids_fraction(region, the_case, grid);
  double* x;
  PetscCallAbort(PETSC_COMM_SELF, VecGetArray(state, &x));
  for (const Field& field : model.fields()) {
    const InitialValue* given = region.find(*field.unknown);
    const bool from_run = run && run->has(field) && (!given || field.is<SolidsContinuity>());
    if (!given && !from_run && !(field.is<SolidsContinuity>() && region.has_own_solids_fraction())) continue;
    for_each_node(grid.owned_first, grid.owned_count, [&](const Index& I) {
      if (field.face_axis < 0 ? !grid.inside(I) : !grid.is_face(field.face_axis, I)) return;
      std::array<double, max_dim> at{};
      for (int a = 0; a < grid.dim; ++a)
        at[a] = a == field.face_axis ? grid.axes[a].face(I[a]) : grid.axes[a].centre(I[a]);
      if (!region.holds(at, grid.dim)) return;
      double value = given ? given->value[static_cast<std::size_t>(std::max(field.face_axis, 0))] : 0;
      if (from_run)
        value = run->value(grid, field, I);
      else if (field.is<SolidsContinuity>())
        value = solids_fraction.at(grid, I, value);
      if (field.is<SolidsMomentum>()) value = initial_velocity(region, problem, field.face_axis, I, at, value);
      x[grid.owned(I) * model.unknowns() + field.component] = value / field.scale;
    });
  }
  PetscCallAbort(PETSC_COMM_SELF, VecRestoreArray(state, &x));
}

/// A run with another nu_max may be packed more densely than this case bears.
void check_packing(const Case& the_case, const InitialRegion& region, const DiscreteProblem& problem, Vec state) {
  double greatest;
  PetscCallAbort(PETSC_COMM_SELF, VecStrideMax(state, Model::solids_fraction, nullptr, &greatest));
  if (greatest < the_case.kinetic.nu_max) return;
  throw InputError("initial_" + region.name + "_run", region.run,
                   "a run with solids fractions below solids_fraction_max = " + number_text(the_case.kinetic.nu_max) +
                       "; that one has up to " + number_text(greatest * problem.model().fields()[0].scale));
}

}  // namespace

std::vector<double> equilibrium_column(const Axis& axis, double gravity, int down, double surface, double janssen_width,
                                       const Case& the_case) {
  const double buoyancy = the_case.gas.model == GasModel::none ? 0 : the_case.gas.rho_g;
  const double weight = (the_case.kinetic.rho_s - buoyancy) * gravity;
  const double loss_rate = janssen_width > 0 ? 2 * std::tan(the_case.wall.delta) / janssen_width : 0;
  std::vector<double> nu(static_cast<std::size_t>(axis.cells()), 0.0);
  double p_above = 0, nu_above = 0;
  bool first = true;
  const int start = down < 0 ? axis.cells() - 1 : 0;
  for (int i = start; i >= 0 && i < axis.cells(); i += down) {
    const double depth = (axis.centre(i) - surface) * down;
    if (depth <= 0) continue;
    const int face = down < 0 ? i + 1 : i;
    const double distance = first ? depth : axis.distance(face);
    // Shares of the two cells in the weight of the control volume between their centres.
    const double own = first ? 1 : (down < 0 ? axis.lower_share(face) : 1 - axis.lower_share(face));
    const double loss = 0.5 * loss_rate * distance;
    const double carried = p_above * (1 - loss) + weight * distance * (1 - own) * nu_above;
    nu_above = nu[static_cast<std::size_t>(i)] =
        solids_fraction_under(carried, weight * distance * own, loss, the_case.friction);
    p_above = critical_pressure(nu_above, the_case.friction);
    first = false;
  }
  return nu;
}

std::vector<std::string> set_initial_state(const Case& the_case, const DiscreteProblem& problem, Vec state) {
  std::vector<std::string> remarks;
  PetscCallAbort(PETSC_COMM_SELF, VecZeroEntries(state));
  for (const InitialRegion& region : the_case.initial) {
    std::unique_ptr<InitialRun> run;
    if (!region.run.empty()) {
      const MPI_Comm comm = PetscObjectComm(reinterpret_cast<PetscObject>(problem.dm()));
      run = std::make_unique<InitialRun>(comm, the_case, region, problem.lattice());
      remarks.push_back(run->remark(problem.model().fields()));
    }
    fill_region(the_case, region, problem, run.get(), state);
    if (run) check_packing(the_case, region, problem, state);
  }
  return remarks;
}

}  // namespace scree
