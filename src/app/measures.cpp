#include "scree/app/measures.hpp"

#include <algorithm>
#include <cmath>

#include "scree/app/derived_cells.hpp"
#include "scree/app/wall_stress.hpp"
#include "scree/balances/layout.hpp"
#include "scree/grid/axis_name.hpp"
#include "scree/model/derived_fields.hpp"
#include "scree/output/errors.hpp"
#include "scree/stepping/gas_flow.hpp"

namespace scree {

namespace {

double reduced(double value, MPI_Op operation, DM dm) {
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, operation, PetscObjectComm(reinterpret_cast<PetscObject>(dm)));
  return value;
}

}  // namespace

Measures::Measures(const Case& the_case, const DiscreteProblem& problem)
    : case_(the_case),
      problem_(problem),
      with_gas_(problem.model().component<GasContinuity>() >= 0),
      has_gas_velocity_(problem.model().component<GasMomentum>() >= 0),
      T_(problem.model().component<GranularEnergy>()),
      derived_(derived_fields(problem.setup().model, problem.setup().solids)) {
  const double missing =
      std::pow(the_case.output.depth, max_dim - the_case.box.dim);  // extent of the axes that are not there
  mass_per_volume_ = the_case.kinetic.rho_s * missing * the_case.output.mirror;
}

std::vector<Quantity> Measures::quantities(double time, Vec state) const {
  std::vector<Quantity> list;
  const auto add = [&](const std::string& name, const std::string& unit, const std::string& text, auto&& measure) {
    list.push_back({{name, unit, text}, state ? measure() : 0.0});
  };
  const auto flux = [&](Phase phase, auto&& through) {
    double value;
    check_petsc(through(phase, &value), "flux");
    return value * mass_per_volume_ / (phase == Phase::gas ? case_.kinetic.rho_s : 1);
  };
  const std::vector<CellField> derived = state ? derived_cells(problem_, state) : std::vector<CellField>();
  const Motion moving = state ? motion(state, derived) : Motion();

  add("discharge_rate", "kg/s", "mass of particles that leaves through the sides, less what comes in", [&] {
    return flux(Phase::solids, [&](Phase p, double* value) { return problem_.outflow(time, state, p, value); });
  });
  add("mass", "kg", "mass of the particles in the box", [&] {
    double volume;
    check_petsc(problem_.solids_volume(state, &volume), "solids volume");
    return volume * mass_per_volume_;
  });
  add("bed_height", "m", "mean over the columns of the highest place where nu falls through bed_solids_fraction",
      [&] { return bed_height(state); });
  add("speed_max", "m/s", "greatest component of v at any face, voids included",
      [&] { return greatest_speed(state, SolidsMomentum::unknown); });
  add("speed_max_weighted", "m/s", "square root of the greatest nu v^2/nu_max of a cell: v where particles are",
      [&] { return moving.speed; });
  if (has_gas_velocity_)
    add("gas_speed_max", "m/s", "greatest component of u at any face",
        [&] { return greatest_speed(state, GasMomentum::unknown); });
  add("kinetic_energy", "J", "sum of rho_s nu v^2/2", [&] { return moving.kinetic * mass_per_volume_; });
  if (has_temperature()) {
    add("fluctuation_energy", "J", "sum of 3/2 rho_s nu T", [&] { return moving.fluctuation * mass_per_volume_; });
    add("granular_temperature_max_weighted", "m2/s2", "greatest nu T/nu_max of a cell: T where particles are",
        [&] { return moving.temperature; });
  }
  const auto add_range = [&](const Field& field, auto&& measure) {
    const Range r = state ? measure() : Range{0, 0};
    add(field.dataset + "_min", field.unit, "least value of a cell: " + field.text, [&] { return r.least; });
    add(field.dataset + "_max", field.unit, "greatest value of a cell: " + field.text, [&] { return r.greatest; });
  };
  for (const Field& field : problem_.model().fields())
    if (field.face_axis < 0) add_range(field, [&] { return range(state, field); });
  for (const Field& field : derived_)
    add_range(field, [&] { return range(derived[static_cast<std::size_t>(field.component)]); });
  for (int axis = 0; with_gas_ && axis < case_.box.dim; ++axis) {
    if (!case_.box.periodic[axis]) continue;
    add("mean_pressure_gradient_" + axis_name(axis), "Pa/m",
        "part of grad p_g along " + axis_name(axis) + " beside that of p_g itself, for the step to come",
        [&] { return problem_.setup().model.mean_pressure_gradient[axis]; });
    add("mean_gas_velocity_" + axis_name(axis), "m/s",
        "superficial velocity of the gas along " + axis_name(axis) + ", mean over the box", [&] {
          double velocity;
          check_petsc(mean_gas_velocity(problem_, time, state, axis, &velocity), "flow of gas");
          return velocity;
        });
  }
  for (const FluxPlane& plane : case_.flux_planes) {
    const auto through = [&](Phase phase, double* value) {
      return problem_.plane_flux(time, state, phase, plane.axis, plane.position, plane.patch, value);
    };
    const int sign = plane.upward ? 1 : -1;
    add("flux_" + plane.name, "kg/s", "mass of particles through flux plane " + plane.name,
        [&] { return sign * flux(Phase::solids, through); });
    if (with_gas_)
      add("gas_flux_" + plane.name, "m3/s", "volume of gas through flux plane " + plane.name,
          [&] { return sign * flux(Phase::gas, through); });
  }
  if (case_.output.wall_stress) {
    const WallStress walls(case_, problem_);
    const auto forces = state ? walls.forces(time, state) : std::vector<std::array<double, max_dim>>();
    const double extent = mass_per_volume_ / case_.kinetic.rho_s;
    for (std::size_t w = 0; w < walls.names().size(); ++w)
      for (int a = 0; a < case_.box.dim; ++a)
        add("force_" + walls.names()[w] + "_" + axis_name(a), "N",
            "force of the particles on " + walls.names()[w] + " along " + axis_name(a),
            [&] { return forces[w][static_cast<std::size_t>(a)] * extent; });
  }
  return list;
}

bool Measures::has_temperature() const { return T_ >= 0 || case_.model.temperature == TemperatureModel::algebraic; }

Measures::Motion Measures::motion(Vec state, const std::vector<CellField>& derived) const {
  const Lattice& grid = problem_.lattice();
  const Model& model = problem_.model();
  const auto entries = derived_entries(problem_.setup().model, problem_.setup().solids);
  const auto T = std::find(entries.begin(), entries.end(), CellClosure::temperature);
  GhostedArray u;
  check_petsc(u.open(problem_.dm(), state), "energies");
  const auto value = [&](const Field& field, const Index& I) {
    return field.scale * u.data()[grid.ghosted(I) * model.unknowns() + field.component];
  };
  const std::vector<Field>& fields = model.fields();
  double sums[2]{0, 0}, greatest[2]{0, 0};
  for_each_node(grid.owned_first, grid.owned_count, [&](const Index& I) {
    if (!grid.inside(I)) return;
    const double nu = value(fields[Model::solids_fraction], I);
    double v_squared = 0;
    for (const Field& field : fields) {
      if (!field.is<SolidsMomentum>()) continue;
      const double below = value(field, I), above = value(field, I + unit(field.face_axis));
      v_squared += 0.5 * (below * below + above * above);
    }
    double T_cell = 0;
    if (T_ >= 0) T_cell = value(fields[static_cast<std::size_t>(T_)], I);
    if (T != entries.end())
      T_cell = derived[static_cast<std::size_t>(T - entries.begin())].values[static_cast<std::size_t>(grid.owned(I))];
    sums[0] += grid.volume(I) * 0.5 * nu * v_squared;
    sums[1] += grid.volume(I) * 1.5 * nu * T_cell;
    greatest[0] = std::max(greatest[0], nu * v_squared / case_.kinetic.nu_max);
    greatest[1] = std::max(greatest[1], nu * T_cell / case_.kinetic.nu_max);
  });
  check_petsc(u.close(), "energies");
  const MPI_Comm comm = PetscObjectComm(reinterpret_cast<PetscObject>(problem_.dm()));
  MPI_Allreduce(MPI_IN_PLACE, sums, 2, MPI_DOUBLE, MPI_SUM, comm);
  MPI_Allreduce(MPI_IN_PLACE, greatest, 2, MPI_DOUBLE, MPI_MAX, comm);
  return {sums[0], sums[1], std::sqrt(greatest[0]), greatest[1]};
}

Measures::Range Measures::range(const std::function<double(const Index&)>& value) const {
  const Lattice& grid = problem_.lattice();
  Range r{HUGE_VAL, -HUGE_VAL};
  for_each_node(grid.owned_first, grid.owned_count, [&](const Index& I) {
    if (!grid.inside(I)) return;
    r.least = std::min(r.least, value(I));
    r.greatest = std::max(r.greatest, value(I));
  });
  return {reduced(r.least, MPI_MIN, problem_.dm()), reduced(r.greatest, MPI_MAX, problem_.dm())};
}

Measures::Range Measures::range(Vec state, const Field& field) const {
  const double* x;
  check_petsc(VecGetArrayRead(state, &x), "range");
  const Range r = range([&](const Index& I) {
    return field.scale * x[problem_.lattice().owned(I) * problem_.model().unknowns() + field.component];
  });
  check_petsc(VecRestoreArrayRead(state, &x), "range");
  return r;
}

Measures::Range Measures::range(const CellField& field) const {
  return range([&](const Index& I) { return field.values[static_cast<std::size_t>(problem_.lattice().owned(I))]; });
}

double Measures::greatest_speed(Vec state, const Unknown& velocity) const {
  const Lattice& grid = problem_.lattice();
  const double* x;
  check_petsc(VecGetArrayRead(state, &x), "speed");
  double greatest = 0;
  for (const Field& field : problem_.model().fields())
    if (field.unknown == &velocity)
      for_each_node(grid.owned_first, grid.owned_count, [&](const Index& I) {
        if (grid.is_face(field.face_axis, I))
          greatest = std::max(greatest,
                              field.scale * std::abs(x[grid.owned(I) * problem_.model().unknowns() + field.component]));
      });
  check_petsc(VecRestoreArrayRead(state, &x), "speed");
  return reduced(greatest, MPI_MAX, problem_.dm());
}

/// Mean over the columns of the highest place, against gravity, where nu falls through bed_solids_fraction.
double Measures::bed_height(Vec state) const {
  const auto& g = case_.model.gravity;
  const auto by_size = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const int up = static_cast<int>(std::max_element(g.begin(), g.end(), by_size) - g.begin());
  if (g[up] == 0 || up >= case_.box.dim) return 0;
  const int sign = g[up] < 0 ? 1 : -1;
  const Lattice& grid = problem_.lattice();
  const Axis& vertical = grid.axes[up];
  const double mark = case_.output.bed_solids_fraction;

  std::array<int, max_dim> extent{1, 1, 1};
  for (int a = 0; a < grid.dim; ++a)
    if (a != up) extent[a] = grid.axes[a].cells();
  std::vector<double> top(static_cast<std::size_t>(extent[0]) * extent[1] * extent[2],
                          sign * (sign > 0 ? vertical.face(0) : vertical.face(vertical.cells())));
  GhostedArray u;
  check_petsc(u.open(problem_.dm(), state), "bed height");
  const auto nu = [&](const Index& I) {
    return u.data()[grid.ghosted(I) * problem_.model().unknowns() + Model::solids_fraction];
  };
  for_each_node(grid.owned_first, grid.owned_count, [&](const Index& I) {
    const Index above = I + sign * unit(up);
    if (!grid.inside(I) || nu(I) < mark || (grid.inside(above) && nu(above) >= mark)) return;
    const double here = vertical.centre(I[up]);
    const double z = grid.inside(above)
                         ? here + (nu(I) - mark) / (nu(I) - nu(above)) * (vertical.centre(above[up]) - here)
                         : vertical.face(sign > 0 ? I[up] + 1 : I[up]);
    Index column = I;
    column[up] = 0;
    double& highest = top[(static_cast<std::size_t>(column[2]) * extent[1] + column[1]) * extent[0] + column[0]];
    highest = std::max(highest, sign * z);
  });
  check_petsc(u.close(), "bed height");
  MPI_Allreduce(MPI_IN_PLACE, top.data(), static_cast<int>(top.size()), MPI_DOUBLE, MPI_MAX,
                PetscObjectComm(reinterpret_cast<PetscObject>(problem_.dm())));

  double sum = 0, area = 0;
  for_each_node({}, Index{extent}, [&](const Index& column) {
    double share = 1;
    for (int a = 0; a < grid.dim; ++a)
      if (a != up) share *= grid.axes[a].width(column[a]);
    sum += share * top[(static_cast<std::size_t>(column[2]) * extent[1] + column[1]) * extent[0] + column[0]];
    area += share;
  });
  return sign * sum / area;
}

}  // namespace scree
