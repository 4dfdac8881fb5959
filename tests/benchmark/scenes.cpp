#include "scenes.hpp"

#include <cmath>
#include <stdexcept>

#include "scree/app/initial_state.hpp"
#include "scree/app/problem_setup.hpp"
#include "scree/config/command_line.hpp"
#include "scree/config/read_case.hpp"

namespace scree::benchmarks {
namespace {

/// A wave over a few cells along each axis, different for each component; from -1 to 1.
double wave(const Index& I, int component) {
  const double phase = 0.37 * I[0] + 0.23 * I[1] + 0.31 * I[2];
  return std::sin(phase + 1.3 * component) * std::cos(0.11 * I[0] - 0.17 * I[1] + 0.7 * component);
}

/// A dense flow at some cm/s on top of the initial state: its beds stay beds, its voids stay voids.
double disturbed(const Field& field, double initial, double z) {
  if (field.symbol == "nu") return initial * (0.96 + 0.06 * z);
  if (field.symbol == "v") return initial + 0.05 * z;
  if (field.symbol == "u") return initial + 0.2 * z;
  if (field.symbol == "T") return 1e-4 * std::exp(1.5 * z);
  if (field.symbol == "chi") return 0.9 + 0.15 * z;
  return 200 * z;  // p_g
}

void disturb(const DiscreteProblem& problem, Vec state) {
  const Lattice& grid = problem.lattice();
  const Model& model = problem.model();
  double* x;
  check(VecGetArray(state, &x));
  for_each_node(grid.owned_first, grid.owned_count, [&](const Index& I) {
    for (const Field& field : model.fields()) {
      if (!model.is_balance(field.component, I)) continue;
      double& value = x[grid.owned(I) * model.unknowns() + field.component];
      value = disturbed(field, value * field.scale, wave(I, field.component)) / field.scale;
    }
  });
  check(VecRestoreArray(state, &x));
}

}  // namespace

void check(PetscErrorCode code) {
  if (code != 0) throw std::runtime_error("PETSc error " + std::to_string(code));
}

std::vector<Scene> scenes(const std::string& cases) {
  const std::string bin = cases + "/bin_discharge/coarse.yaml", bubble = cases + "/bubble_rise/paper.yaml",
                    third = cases + "/../tests/benchmark/bin_3d.yaml";
  return {{"bin", bin, {}, {1, 2, 4}},
          {"bin_van_albada", bin, {{"advection", "van_albada"}}, {1, 2, 4}},
          {"critical_state", bin, {{"friction_model", "critical_state"}}, {1, 2, 4}},
          {"bubble", bubble, {}, {1, 2, 4}},
          {"darcy", bubble, {{"gas", "darcy"}}, {1, 2, 4}},
          {"bin_3d", third, {}, {1, 2}},
          {"bin_3d_gas", third, {{"gas", "incompressible"}}, {1, 2}}};
}

Case read_scene(const Scene& scene, int refine) {
  check(PetscOptionsClear(nullptr));
  CommandLine line{scene.file, scene.options};
  line.options.push_back({"grid_refine", std::to_string(refine)});
  return read_case(case_input(line));
}

Sample::Sample(const Scene& scene, int refine) : problem_(problem_setup(read_scene(scene, refine))) {
  const Case read = read_scene(scene, refine);
  check(problem_.create(PETSC_COMM_SELF, 0));
  check(DMCreateGlobalVector(problem_.dm(), &state_));
  check(VecDuplicate(state_, &rate_));
  check(VecDuplicate(state_, &residual_));
  (void)set_initial_state(read, problem_, state_);
  disturb(problem_, state_);
  check(VecCopy(state_, rate_));
}

Sample::~Sample() {
  for (Vec* vector : {&state_, &rate_, &residual_}) (void)VecDestroy(vector);
}

void Sample::residual() { check(problem_.residual(0, state_, rate_, residual_)); }

void Sample::jacobian() { check(problem_.jacobian(0, state_, rate_, 100, problem_.matrix())); }

int Sample::cells() const {
  int cells = 1;
  for (int axis = 0; axis < problem_.box().dim; ++axis) cells *= problem_.box().cells(axis);
  return cells;
}

double Sample::unknowns() const { return problem_.model().unknowns(); }

double Sample::entries() const {
  MatInfo info;
  check(MatGetInfo(problem_.matrix(), MAT_LOCAL, &info));
  return info.nz_used / cells();
}

}  // namespace scree::benchmarks
