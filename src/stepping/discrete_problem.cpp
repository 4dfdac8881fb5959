#include "scree/stepping/discrete_problem.hpp"

#include <algorithm>
#include <cmath>

#include "scree/balances/layout.hpp"
#include "scree/stepping/grid_of_nodes.hpp"

namespace scree {

namespace {

/// Collects the columns of each row.
class RowColumns : public EntrySink {
 public:
  RowColumns(int rows, const PetscInt* global) : columns(static_cast<std::size_t>(rows)), global_(global) {}
  void entry(int row, int ghosted_column) override {
    const PetscInt column = global_[ghosted_column];
    auto& list = columns[static_cast<std::size_t>(row)];
    if (column >= 0 && std::find(list.begin(), list.end(), column) == list.end()) list.push_back(column);
  }
  std::vector<std::vector<PetscInt>> columns;

 private:
  const PetscInt* global_;
};

/// Looks up where each entry of the sweep stands in the arrays of an assembled matrix.
class PlaceFinder : public EntrySink {
 public:
  PlaceFinder(const PetscInt* global, EntryPlaces& places) : global_(global), places_(places) {}

  PetscErrorCode open(Mat A) {
    PetscFunctionBeginUser;
    PetscBool parallel;
    PetscCall(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(A), MATMPIAIJ, &parallel));
    diagonal_ = A;
    if (parallel) PetscCall(MatMPIAIJGetSeqAIJ(A, &diagonal_, &off_diagonal_, &compressed_));
    PetscCall(MatGetOwnershipRangeColumn(A, &first_, &end_));
    PetscBool done;
    PetscInt rows;
    PetscCall(MatGetRowIJ(diagonal_, 0, PETSC_FALSE, PETSC_FALSE, &rows, &d_row_, &d_column_, &done));
    if (off_diagonal_) {
      PetscCall(MatGetRowIJ(off_diagonal_, 0, PETSC_FALSE, PETSC_FALSE, &rows, &o_row_, &o_column_, &done));
      PetscCall(MatGetSize(off_diagonal_, nullptr, &compressed_size_));
    }
    PetscFunctionReturn(0);
  }
  PetscErrorCode close() {
    PetscFunctionBeginUser;
    PetscBool done;
    PetscInt rows;
    PetscCall(MatRestoreRowIJ(diagonal_, 0, PETSC_FALSE, PETSC_FALSE, &rows, &d_row_, &d_column_, &done));
    if (off_diagonal_)
      PetscCall(MatRestoreRowIJ(off_diagonal_, 0, PETSC_FALSE, PETSC_FALSE, &rows, &o_row_, &o_column_, &done));
    PetscFunctionReturn(0);
  }

  void entry(int row, int ghosted_column) override {
    const PetscInt column = global_[ghosted_column];
    if (column < 0) {
      places_.push_back(-1);
    } else if (column >= first_ && column < end_) {
      places_.push_back(static_cast<std::int32_t>(find(d_row_, d_column_, row, column - first_)));
    } else {
      const PetscInt local = std::lower_bound(compressed_, compressed_ + compressed_size_, column) - compressed_;
      places_.push_back(static_cast<std::int32_t>(-2 - find(o_row_, o_column_, row, local)));
    }
  }

 private:
  static PetscInt find(const PetscInt* rows, const PetscInt* columns, int row, PetscInt column) {
    return std::lower_bound(columns + rows[row], columns + rows[row + 1], column) - columns;
  }

  const PetscInt* global_;
  EntryPlaces& places_;
  Mat diagonal_ = nullptr, off_diagonal_ = nullptr;
  PetscInt first_ = 0, end_ = 0, compressed_size_ = 0;
  const PetscInt *compressed_ = nullptr, *d_row_ = nullptr, *d_column_ = nullptr, *o_row_ = nullptr,
                 *o_column_ = nullptr;
};

/// Global numbers of the ghosted unknowns, -1 beyond the box.
class GlobalNumbers {
 public:
  explicit GlobalNumbers(DM dm) {
    PetscCallAbort(PETSC_COMM_SELF, DMGetLocalToGlobalMapping(dm, &map_));
    PetscCallAbort(PETSC_COMM_SELF, ISLocalToGlobalMappingGetIndices(map_, &numbers_));
  }
  ~GlobalNumbers() { PetscCallAbort(PETSC_COMM_SELF, ISLocalToGlobalMappingRestoreIndices(map_, &numbers_)); }
  GlobalNumbers(const GlobalNumbers&) = delete;
  GlobalNumbers& operator=(const GlobalNumbers&) = delete;
  const PetscInt* data() const { return numbers_; }

 private:
  ISLocalToGlobalMapping map_ = nullptr;
  const PetscInt* numbers_ = nullptr;
};

}  // namespace

DiscreteProblem::~DiscreteProblem() {
  PetscCallAbort(PETSC_COMM_SELF, MatDestroy(&matrix_));
  PetscCallAbort(PETSC_COMM_SELF, DMDestroy(&dm_));
}

PetscErrorCode DiscreteProblem::create(MPI_Comm comm, double time) {
  const auto [unknowns, stencil_width] = setup_.models.extent(setup_.box.dim, setup_.model, setup_.solids);
  PetscCall(create_dm(comm, setup_.box, unknowns, stencil_width, &dm_));
  PetscFunctionBeginUser;  // behind what may throw
  lattice_ = std::make_unique<Lattice>(setup_.box, dm_);
  PetscCall(update_conditions(time));
  for (const Field& field : model_->fields())
    PetscCall(DMDASetFieldName(dm_, field.component, column_name(field).c_str()));
  PetscFunctionReturn(0);
}

PetscErrorCode DiscreteProblem::update_conditions(double time) {
  PetscFunctionBeginUser;
  barriers_ = std::make_unique<Barriers>(*lattice_, setup_.segments, setup_.plates, time);
  gas_projection_.reset();
  model_ = setup_.models.make({*lattice_, *barriers_, setup_.model, setup_.solids, setup_.scales});
  if (model_->component<GasMomentum>() >= 0) {
    gas_projection_ = std::make_unique<GasProjection>(*lattice_, *barriers_, *model_);
    PetscCall(gas_projection_->create(dm_));
  }
  PetscCall(MatDestroy(&matrix_));
  PetscCall(create_matrix());
  PetscCall(find_places());
  PetscFunctionReturn(0);
}

PetscErrorCode DiscreteProblem::create_matrix() {
  PetscFunctionBeginUser;
  const GlobalNumbers global(dm_);
  const int rows = lattice_->owned_size() * model_->unknowns();
  RowColumns pattern(rows, global.data());
  model_->sparsity(pattern);

  PetscCall(MatCreate(PetscObjectComm(reinterpret_cast<PetscObject>(dm_)), &matrix_));
  PetscCall(MatSetSizes(matrix_, rows, rows, PETSC_DETERMINE, PETSC_DETERMINE));
  PetscCall(MatSetBlockSize(matrix_, model_->unknowns()));
  // Blocks are a third full: BAIJ holds 3.1 times the entries, and a system with ILU takes twice as long.
  PetscCall(MatSetType(matrix_, MATAIJ));
  PetscInt first, end;
  PetscCall(MatSetUp(matrix_));
  PetscCall(MatGetOwnershipRange(matrix_, &first, &end));
  std::vector<PetscInt> inner(static_cast<std::size_t>(rows)), outer(static_cast<std::size_t>(rows));
  for (std::size_t row = 0; row < pattern.columns.size(); ++row) {
    auto& columns = pattern.columns[row];
    std::sort(columns.begin(), columns.end());
    inner[row] = std::count_if(columns.begin(), columns.end(), [&](PetscInt c) { return c >= first && c < end; });
    outer[row] = static_cast<PetscInt>(columns.size()) - inner[row];
  }
  PetscCall(MatSeqAIJSetPreallocation(matrix_, 0, inner.data()));
  PetscCall(MatMPIAIJSetPreallocation(matrix_, 0, inner.data(), 0, outer.data()));
  for (std::size_t row = 0; row < pattern.columns.size(); ++row) {
    const auto& columns = pattern.columns[row];
    const std::vector<PetscScalar> zeros(columns.size(), 0.0);
    const PetscInt global_row = first + static_cast<PetscInt>(row);
    PetscCall(MatSetValues(matrix_, 1, &global_row, static_cast<PetscInt>(columns.size()), columns.data(), zeros.data(),
                           INSERT_VALUES));
  }
  PetscCall(MatAssemblyBegin(matrix_, MAT_FINAL_ASSEMBLY));
  PetscCall(MatAssemblyEnd(matrix_, MAT_FINAL_ASSEMBLY));
  PetscCall(MatSetOption(matrix_, MAT_NEW_NONZERO_LOCATION_ERR, PETSC_TRUE));
  PetscCall(set_grid_of_nodes(matrix_, dm_));
  PetscFunctionReturn(0);
}

PetscErrorCode DiscreteProblem::find_places() {
  PetscFunctionBeginUser;
  const GlobalNumbers global(dm_);
  places_.clear();
  PlaceFinder finder(global.data(), places_);
  PetscCall(finder.open(matrix_));
  model_->sparsity(finder);
  PetscCall(finder.close());
  places_.shrink_to_fit();
  PetscFunctionReturn(0);
}

PetscErrorCode DiscreteProblem::residual(double time, Vec state, Vec rate, Vec residual) const {
  PetscFunctionBeginUser;
  GhostedArray u, u_dot;
  PetscCall(u.open(dm_, state));
  PetscCall(u_dot.open(dm_, rate));
  double* f;
  PetscCall(VecGetArrayWrite(residual, &f));
  model_->residual(time, u.data(), u_dot.data(), f);
  PetscCall(VecRestoreArrayWrite(residual, &f));
  PetscCall(u_dot.close());
  PetscCall(u.close());
  PetscFunctionReturn(0);
}

PetscErrorCode DiscreteProblem::jacobian(double time, Vec state, Vec rate, double shift, Mat jacobian) const {
  PetscFunctionBeginUser;
  GhostedArray u, u_dot;
  PetscCall(u.open(dm_, state));
  PetscCall(u_dot.open(dm_, rate));

  PetscCall(MatZeroEntries(jacobian));
  PetscBool parallel;
  PetscCall(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(jacobian), MATMPIAIJ, &parallel));
  Mat blocks[2] = {jacobian, nullptr};
  if (parallel) PetscCall(MatMPIAIJGetSeqAIJ(jacobian, &blocks[0], &blocks[1], nullptr));
  double* entries[2] = {nullptr, nullptr};
  for (int k = 0; k < 2 && blocks[k]; ++k) PetscCall(MatSeqAIJGetArray(blocks[k], &entries[k]));
  model_->jacobian(time, u.data(), u_dot.data(), shift, places_, entries[0], entries[1]);
  for (int k = 0; k < 2 && blocks[k]; ++k) PetscCall(MatSeqAIJRestoreArray(blocks[k], &entries[k]));
  PetscCall(MatAssemblyBegin(jacobian, MAT_FINAL_ASSEMBLY));
  PetscCall(MatAssemblyEnd(jacobian, MAT_FINAL_ASSEMBLY));
  PetscCall(u_dot.close());
  PetscCall(u.close());
  PetscFunctionReturn(0);
}

PetscErrorCode DiscreteProblem::solids_volume(Vec state, double* volume) const {
  PetscFunctionBeginUser;
  const double* x;
  PetscCall(VecGetArrayRead(state, &x));
  double sum = 0;
  for_each_node(lattice_->owned_first, lattice_->owned_count, [&](const Index& I) {
    if (lattice_->inside(I))
      sum += lattice_->volume(I) * x[lattice_->owned(I) * model_->unknowns() + Model::solids_fraction];
  });
  PetscCall(VecRestoreArrayRead(state, &x));
  PetscCallMPI(
      MPI_Allreduce(&sum, volume, 1, MPI_DOUBLE, MPI_SUM, PetscObjectComm(reinterpret_cast<PetscObject>(dm_))));
  PetscFunctionReturn(0);
}

PetscErrorCode DiscreteProblem::outflow(double time, Vec state, Phase phase, double* total) const {
  PetscFunctionBeginUser;
  GhostedArray u;
  PetscCall(u.open(dm_, state));
  double sum = 0;
  for_each_node(lattice_->owned_first, lattice_->owned_count, [&](const Index& I) {
    for (int axis = 0; axis < lattice_->dim; ++axis) {
      const bool lower = !lattice_->inside(I - unit(axis)), upper = !lattice_->inside(I);
      if (lower == upper || !barriers_->at(axis, I)) continue;
      sum += (upper ? 1 : -1) * lattice_->face_area(axis, I) * flux(time, phase, u.data(), axis, I);
    }
  });
  PetscCall(u.close());
  PetscCallMPI(MPI_Allreduce(&sum, total, 1, MPI_DOUBLE, MPI_SUM, PetscObjectComm(reinterpret_cast<PetscObject>(dm_))));
  PetscFunctionReturn(0);
}

PetscErrorCode DiscreteProblem::plane_flux(double time, Vec state, Phase phase, int axis, double position,
                                           const Patch& patch, double* total) const {
  PetscFunctionBeginUser;
  const Axis& normal = lattice_->axes[axis];
  int plane = 0;
  for (int i = 0; i <= normal.cells(); ++i)
    if (std::abs(normal.face(i) - position) < std::abs(normal.face(plane) - position)) plane = i;
  if (normal.periodic() && plane == normal.cells()) plane = 0;
  GhostedArray u;
  PetscCall(u.open(dm_, state));
  double sum = 0;
  for_each_node(lattice_->owned_first, lattice_->owned_count, [&](const Index& I) {
    if (I[axis] != plane || !lattice_->is_face(axis, I)) return;
    for (int a = 0; a < lattice_->dim; ++a) {
      const double x = lattice_->axes[a].centre(I[a]);
      if (a != axis && (x < patch.lower[a] || x > patch.upper[a])) return;
    }
    sum += lattice_->face_area(axis, I) * flux(time, phase, u.data(), axis, I);
  });
  PetscCall(u.close());
  PetscCallMPI(MPI_Allreduce(&sum, total, 1, MPI_DOUBLE, MPI_SUM, PetscObjectComm(reinterpret_cast<PetscObject>(dm_))));
  PetscFunctionReturn(0);
}

}  // namespace scree
