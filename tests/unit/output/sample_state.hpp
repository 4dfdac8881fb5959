/// A small scene for the tests of `output`: a box, a state on it and its fields; a scratch directory.
#pragma once

#include <gtest/gtest.h>
#include <petscdmda.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "scree/grid/box.hpp"
#include "scree/grid/unknown.hpp"
#include "scree/output/errors.hpp"
#include "scree/output/node_block.hpp"

namespace scree::test {

inline int this_rank() {
  int rank = 0;
  MPI_Comm_rank(PETSC_COMM_WORLD, &rank);
  return rank;
}

inline void barrier() { MPI_Barrier(PETSC_COMM_WORLD); }

/// A directory of its own for each test, the same on all ranks, removed at the end.
class Scratch {
 public:
  Scratch() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    path_ = std::filesystem::temp_directory_path() / ("scree_" + broadcast(PETSC_COMM_WORLD, std::to_string(getpid())) +
                                                      "_" + info->test_suite_name() + "_" + info->name());
    if (this_rank() == 0) std::filesystem::create_directories(path_);
    barrier();
  }
  ~Scratch() {
    barrier();
    std::error_code ignored;
    if (this_rank() == 0) std::filesystem::remove_all(path_, ignored);
  }
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

inline std::string content(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Rank 0 writes, all wait.
inline void put(const std::string& path, const std::string& text) {
  if (this_rank() == 0) {
    std::filesystem::create_directories(std::filesystem::path(path).parent_path());
    std::ofstream(path) << text;
  }
  barrier();
}

/// Message of the std::runtime_error that `work` throws; "" if it throws none.
template <class Work>
std::string message_of(Work work) {
  try {
    work();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

/// Cells of uneven size; last axis periodic if asked for. Unknowns: a cell field, and a velocity at the faces.
struct Scene {
  Box box;
  DM dm = nullptr;
  Vec state = nullptr;
  std::vector<Field> fields;

  explicit Scene(int dim, bool last_periodic = false) {
    const int cells[max_dim] = {6, 5, 4};
    box.dim = dim;
    PetscInt nodes[max_dim] = {1, 1, 1};
    DMBoundaryType boundary[max_dim] = {DM_BOUNDARY_NONE, DM_BOUNDARY_NONE, DM_BOUNDARY_NONE};
    for (int axis = 0; axis < dim; ++axis) {
      for (int i = 0; i <= cells[axis]; ++i) box.faces[axis].push_back(0.1 * i + 0.01 * i * i);
      box.periodic[axis] = last_periodic && axis == dim - 1;
      if (box.periodic[axis]) boundary[axis] = DM_BOUNDARY_PERIODIC;
      nodes[axis] = cells[axis] + (box.periodic[axis] ? 0 : 1);
    }
    fields.push_back({"solids_fraction", "nu", "1", "volume fraction of the particles", 0, -1, 2.0});
    for (int axis = 0; axis < dim; ++axis) {
      fields.push_back({"velocity", "v", "m/s", "velocity of the particles", 1 + axis, axis, 10.0 * (axis + 1)});
    }
    make_dm(nodes, boundary);
  }
  ~Scene() {
    (void)VecDestroy(&state);
    (void)DMDestroy(&dm);
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  /// Sets all stored values to value(node, component).
  template <class Value>
  void fill(Vec vector, Value value) const {
    const Lattice grid = checked_lattice(box, dm);
    const int unknowns = unknowns_of(dm);
    PetscScalar* stored = nullptr;
    check_petsc(VecGetArray(vector, &stored), "fill");
    PetscScalar* next = stored;
    for_each_node(grid.owned_first, grid.owned_count, [&](const Index& node) {
      for (int component = 0; component < unknowns; ++component) *next++ = value(node, component);
    });
    check_petsc(VecRestoreArray(vector, &stored), "fill");
  }

  /// A number that tells node and component.
  static double code(const Index& node, int component) {
    return 1000 * component + 100 * node[2] + 10 * node[1] + node[0] + 0.1;
  }

 private:
  void make_dm(const PetscInt* nodes, const DMBoundaryType* boundary) {
    const PetscInt dof = 1 + box.dim;
    check_petsc(DMDACreate(PETSC_COMM_WORLD, &dm), "scene");
    check_petsc(DMSetDimension(dm, box.dim), "scene");
    check_petsc(DMDASetSizes(dm, nodes[0], nodes[1], nodes[2]), "scene");
    check_petsc(DMDASetBoundaryType(dm, boundary[0], boundary[1], boundary[2]), "scene");
    check_petsc(DMDASetDof(dm, dof), "scene");
    check_petsc(DMDASetStencilType(dm, DMDA_STENCIL_STAR), "scene");
    check_petsc(DMDASetStencilWidth(dm, 1), "scene");
    check_petsc(DMSetUp(dm), "scene");
    check_petsc(DMCreateGlobalVector(dm, &state), "scene");
    fill(state, code);
  }
};

}  // namespace scree::test
