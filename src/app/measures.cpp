#include "scree/app/measures.hpp"

#include <algorithm>
#include <cmath>

#include "scree/output/errors.hpp"

namespace scree {

namespace {

double reduced(double value, MPI_Op operation, DM dm) {
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, operation, PetscObjectComm(reinterpret_cast<PetscObject>(dm)));
  return value;
}

}  // namespace

Measures::Measures(const Case& scene, const DiscreteProblem& problem) : scene_(scene), problem_(problem) {
  const double missing =
      std::pow(scene.output.depth, max_dim - scene.box.dim);  // extent of the axes that are not there
  mass_per_volume_ = scene.kinetic.rho_s * missing * scene.output.mirror;
  with_gas_ = problem.model().gas_pressure() >= 0;
  has_gas_velocity_ = problem.model().gas_velocity(0) >= 0;
  columns_ = {{"discharge_rate", "kg/s"}, {"mass", "kg"}, {"bed_height", "m"}, {"speed_max", "m/s"}};
  if (has_gas_velocity_) columns_.push_back({"gas_speed_max", "m/s"});
  for (const Field& field : problem.model().fields()) {
    if (field.face_axis >= 0) continue;
    columns_.push_back({field.dataset + "_min", field.unit});
    columns_.push_back({field.dataset + "_max", field.unit});
  }
  for (const FluxPlane& plane : scene.flux_planes) {
    columns_.push_back({"flux_" + plane.name, "kg/s"});
    if (with_gas_) columns_.push_back({"gas_flux_" + plane.name, "m3/s"});
  }
}

std::vector<double> Measures::values(double time, Vec state) const {
  double flux, volume;
  check_petsc(problem_.outflow(time, state, Phase::solids, &flux), "outflow");
  check_petsc(problem_.solids_volume(state, &volume), "solids volume");
  std::vector<double> values{flux * mass_per_volume_, volume * mass_per_volume_, bed_height(state),
                             greatest_speed(state, "v")};
  if (has_gas_velocity_) values.push_back(greatest_speed(state, "u"));
  for (const Field& field : problem_.model().fields()) {
    if (field.face_axis >= 0) continue;
    const Range r = range(state, field);
    values.insert(values.end(), {r.least, r.greatest});
  }
  for (const FluxPlane& plane : scene_.flux_planes) {
    const auto through = [&](Phase phase) {
      check_petsc(problem_.plane_flux(time, state, phase, plane.axis, plane.position, plane.patch, &flux),
                  "flux plane");
      return (plane.upward ? 1 : -1) * flux;
    };
    values.push_back(through(Phase::solids) * mass_per_volume_);
    if (with_gas_) values.push_back(through(Phase::gas) * mass_per_volume_ / scene_.kinetic.rho_s);
  }
  return values;
}

Measures::Range Measures::range(Vec state, const Field& field) const {
  const Lattice& grid = problem_.lattice();
  const double* x;
  check_petsc(VecGetArrayRead(state, &x), "range");
  Range r{HUGE_VAL, -HUGE_VAL};
  for_each_node(grid.owned_first, grid.owned_count, [&](const Index& I) {
    if (!grid.inside(I)) return;
    const double value = field.scale * x[grid.owned(I) * problem_.model().unknowns() + field.component];
    r.least = std::min(r.least, value);
    r.greatest = std::max(r.greatest, value);
  });
  check_petsc(VecRestoreArrayRead(state, &x), "range");
  return {reduced(r.least, MPI_MIN, problem_.dm()), reduced(r.greatest, MPI_MAX, problem_.dm())};
}

double Measures::greatest_speed(Vec state, const std::string& symbol) const {
  const Lattice& grid = problem_.lattice();
  const double* x;
  check_petsc(VecGetArrayRead(state, &x), "speed");
  double greatest = 0;
  for (const Field& field : problem_.model().fields())
    if (field.symbol == symbol)
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
  const auto& g = scene_.model.gravity;
  const auto by_size = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const int up = static_cast<int>(std::max_element(g.begin(), g.end(), by_size) - g.begin());
  if (g[up] == 0 || up >= scene_.box.dim) return 0;
  const int sign = g[up] < 0 ? 1 : -1;
  const Lattice& grid = problem_.lattice();
  const Axis& vertical = grid.axes[up];
  const double mark = scene_.output.bed_solids_fraction;

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
