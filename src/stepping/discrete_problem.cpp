#include "scree/stepping/discrete_problem.hpp"

#include <algorithm>
#include <cmath>

namespace scree {

PetscErrorCode GhostedArray::open(DM dm, Vec global) {
  PetscFunctionBeginUser;
  dm_ = dm;
  PetscCall(DMGetLocalVector(dm, &local_));
  PetscCall(VecZeroEntries(local_));  // nodes beyond the box: read by kernels with weight zero
  PetscCall(DMGlobalToLocal(dm, global, INSERT_VALUES, local_));
  PetscCall(VecGetArrayRead(local_, &data_));
  PetscFunctionReturn(0);
}

PetscErrorCode GhostedArray::close() {
  PetscFunctionBeginUser;
  PetscCall(VecRestoreArrayRead(local_, &data_));
  PetscCall(DMRestoreLocalVector(dm_, &local_));
  PetscFunctionReturn(0);
}

namespace {

/// Calls work(state with ghosts as it was, the same without ghosts to be changed).
template <class Work>
PetscErrorCode change(DM dm, Vec state, Work&& work) {
  PetscFunctionBeginUser;
  GhostedArray u;
  double* owned;
  PetscCall(u.open(dm, state));
  PetscCall(VecGetArray(state, &owned));
  work(u.data(), owned);
  PetscCall(VecRestoreArray(state, &owned));
  PetscCall(u.close());
  PetscFunctionReturn(0);
}

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
  PetscFunctionBeginUser;
  const auto [unknowns, stencil_width] = model_extent(setup_.box.dim, setup_.model, setup_.solids);
  PetscCall(create_dm(comm, setup_.box, unknowns, stencil_width, &dm_));
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
  model_ = make_model({*lattice_, *barriers_, setup_.model, setup_.solids, setup_.scales});
  stored_with_nu_.clear();
  for (const Field& field : model_->fields())
    if (field.symbol == "v" || field.symbol == "T" || field.symbol == "chi") stored_with_nu_.push_back(field);
  model_->set_time(time);
  if (model_->gas_velocity(0) >= 0) {
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

PetscErrorCode DiscreteProblem::attach(TS ts) {
  PetscFunctionBeginUser;
  PetscCall(TSSetDM(ts, dm_));
  PetscCall(TSSetIFunction(ts, nullptr, ifunction, this));
  PetscCall(TSSetIJacobian(ts, matrix_, matrix_, ijacobian, this));
  PetscFunctionReturn(0);
}

PetscErrorCode DiscreteProblem::residual(Vec state, Vec rate, Vec residual) const {
  PetscFunctionBeginUser;
  GhostedArray u, u_dot;
  PetscCall(u.open(dm_, state));
  PetscCall(u_dot.open(dm_, rate));
  double* f;
  PetscCall(VecGetArrayWrite(residual, &f));
  model_->residual(u.data(), u_dot.data(), f);
  PetscCall(VecRestoreArrayWrite(residual, &f));
  PetscCall(u_dot.close());
  PetscCall(u.close());
  PetscFunctionReturn(0);
}

PetscErrorCode DiscreteProblem::correct_continuity(Vec state, Vec residual, VolumeImbalance* imbalance) const {
  PetscFunctionBeginUser;
  const Lattice& grid = *lattice_;
  const int unknowns = model_->unknowns();
  double outflow_rate, gas_outflow_rate;
  PetscCall(impose_gas(state));
  PetscCall(project_gas(state));
  PetscCall(settle_pressure(state));
  PetscCall(outflow(state, Phase::solids, &outflow_rate));
  PetscCall(outflow(state, Phase::gas, &gas_outflow_rate));
  double* x;
  const double *f, *rate;
  PetscCall(VecGetArray(state, &x));
  PetscCall(VecGetArrayRead(residual, &f));
  PetscCall(VecGetArrayRead(last_rate_, &rate));
  double sum = 0;
  for_each_node(grid.owned_first, grid.owned_count, [&](const Index& I) {
    if (!model_->is_balance(Model::solids_fraction, I)) return;
    const int nu = grid.owned(I) * unknowns + Model::solids_fraction;
    const double excess = f[nu] / model_->continuity_scale();
    x[nu] -= excess / last_shift_;
    sum += grid.volume(I) * (rate[nu] - excess);
  });
  PetscCall(VecRestoreArrayRead(last_rate_, &rate));
  PetscCall(VecRestoreArrayRead(residual, &f));
  PetscCall(VecRestoreArray(state, &x));
  PetscCallMPI(
      MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, PetscObjectComm(reinterpret_cast<PetscObject>(dm_))));
  // The gas has the rest of the box: its volume changes by -sum.
  *imbalance = {sum + outflow_rate, model_->gas_pressure() >= 0 ? gas_outflow_rate - sum : 0};
  PetscFunctionReturn(0);
}

PetscErrorCode DiscreteProblem::remainder(Vec state, Vec residual, Remainder* remainder) const {
  PetscFunctionBeginUser;
  constexpr double dilute = 0.1, least_storage = 1e-2;  // emptier places count as if they stored this
  const Lattice& grid = *lattice_;
  const MPI_Comm comm = PetscObjectComm(reinterpret_cast<PetscObject>(dm_));
  const int unknowns = model_->unknowns();
  GhostedArray u;
  const double* f;
  PetscCall(u.open(dm_, state));
  PetscCall(VecGetArrayRead(residual, &f));
  double sums[2]{0, 0};                // of squares, of cells
  double most[2]{-PETSC_INFINITY, 0};  // of -nu, of changes of single unknowns
  const auto nu_at = [&](const Index& I) { return u.data()[grid.ghosted(I) * unknowns + Model::solids_fraction]; };
  for_each_node(grid.owned_first, grid.owned_count, [&](const Index& I) {
    if (!model_->is_balance(Model::solids_fraction, I)) return;
    const double* rows = f + grid.owned(I) * unknowns;
    const double per_change = model_->continuity_scale() * last_shift_, nu = nu_at(I);
    const double correction = rows[Model::solids_fraction] / per_change;
    sums[0] += correction * correction;
    sums[1] += 1;
    most[0] = std::max(most[0], correction - nu);
    for (const Field& field : stored_with_nu_) {
      if (!model_->is_balance(field.component, I)) continue;
      const double stored = field.face_axis < 0 ? nu : 0.5 * (nu + nu_at(I - unit(field.face_axis)));
      if (stored < dilute)
        most[1] = std::max(most[1], std::abs(rows[field.component]) / (per_change * std::max(stored, least_storage)));
    }
  });
  PetscCall(VecRestoreArrayRead(residual, &f));
  PetscCall(u.close());
  PetscCallMPI(MPI_Allreduce(MPI_IN_PLACE, sums, 2, MPI_DOUBLE, MPI_SUM, comm));
  PetscCallMPI(MPI_Allreduce(MPI_IN_PLACE, most, 2, MPI_DOUBLE, MPI_MAX, comm));
  // Particles at rest have no balance.
  *remainder = {sums[1] > 0 ? std::sqrt(sums[0] / sums[1]) : 0, -most[0], most[1]};
  PetscFunctionReturn(0);
}

PetscErrorCode DiscreteProblem::lag_friction(Vec state, double dt) const {
  PetscFunctionBeginUser;
  const double share = dt / (dt + setup_.solids.friction.tau);
  PetscCall(change(dm_, state, [&](const double* u, double* owned) { model_->relax_chi(u, share, owned); }));
  PetscFunctionReturn(0);
}

PetscErrorCode DiscreteProblem::raise_temperature(Vec guess, double dt) const {
  PetscFunctionBeginUser;
  if (setup_.model.temperature != TemperatureModel::transport) PetscFunctionReturn(0);
  PetscCall(change(dm_, guess, [&](const double* u, double* owned) { model_->raise_temperature(u, dt, owned); }));
  PetscFunctionReturn(0);
}

PetscErrorCode DiscreteProblem::impose_gas(Vec state) const {
  PetscFunctionBeginUser;
  PetscCall(change(dm_, state, [&](const double* u, double* owned) { model_->impose_gas(u, owned); }));
  PetscFunctionReturn(0);
}

PetscErrorCode DiscreteProblem::project_gas(Vec state) const {
  PetscFunctionBeginUser;
  if (gas_projection_) PetscCall(gas_projection_->apply(state));
  PetscFunctionReturn(0);
}

PetscErrorCode DiscreteProblem::settle_pressure(Vec state) const {
  PetscFunctionBeginUser;
  const int p = model_->gas_pressure();
  if (p < 0 || barriers_->some_open()) PetscFunctionReturn(0);
  double* x;
  double sum[2] = {0, 0};
  PetscCall(VecGetArray(state, &x));
  const auto each_cell = [&](auto&& work) {
    for_each_node(lattice_->owned_first, lattice_->owned_count, [&](const Index& I) {
      if (lattice_->inside(I)) work(x[lattice_->owned(I) * model_->unknowns() + p], lattice_->volume(I));
    });
  };
  each_cell([&](double value, double volume) {
    sum[0] += volume * value;
    sum[1] += volume;
  });
  PetscCallMPI(
      MPI_Allreduce(MPI_IN_PLACE, sum, 2, MPI_DOUBLE, MPI_SUM, PetscObjectComm(reinterpret_cast<PetscObject>(dm_))));
  each_cell([&](double& value, double) { value -= sum[0] / sum[1]; });
  PetscCall(VecRestoreArray(state, &x));
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

PetscErrorCode DiscreteProblem::outflow(Vec state, Phase phase, double* total) const {
  PetscFunctionBeginUser;
  GhostedArray u;
  PetscCall(u.open(dm_, state));
  double sum = 0;
  for_each_node(lattice_->owned_first, lattice_->owned_count, [&](const Index& I) {
    for (int axis = 0; axis < lattice_->dim; ++axis) {
      const bool lower = !lattice_->inside(I - unit(axis)), upper = !lattice_->inside(I);
      if (lower == upper || !barriers_->at(axis, I)) continue;
      sum += (upper ? 1 : -1) * lattice_->face_area(axis, I) * flux(phase, u.data(), axis, I);
    }
  });
  PetscCall(u.close());
  PetscCallMPI(MPI_Allreduce(&sum, total, 1, MPI_DOUBLE, MPI_SUM, PetscObjectComm(reinterpret_cast<PetscObject>(dm_))));
  PetscFunctionReturn(0);
}

PetscErrorCode DiscreteProblem::plane_flux(Vec state, Phase phase, int axis, double position, const Patch& patch,
                                           double* total) const {
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
    sum += lattice_->face_area(axis, I) * flux(phase, u.data(), axis, I);
  });
  PetscCall(u.close());
  PetscCallMPI(MPI_Allreduce(&sum, total, 1, MPI_DOUBLE, MPI_SUM, PetscObjectComm(reinterpret_cast<PetscObject>(dm_))));
  PetscFunctionReturn(0);
}

PetscErrorCode DiscreteProblem::ifunction(TS, PetscReal time, Vec state, Vec rate, Vec residual, void* problem) {
  PetscFunctionBeginUser;
  auto& self = *static_cast<DiscreteProblem*>(problem);
  self.last_rate_ = rate;
  self.model_->set_time(time);
  PetscCall(self.residual(state, rate, residual));
  PetscFunctionReturn(0);
}

PetscErrorCode DiscreteProblem::ijacobian(TS, PetscReal time, Vec state, Vec rate, PetscReal shift, Mat A, Mat P,
                                          void* problem) {
  PetscFunctionBeginUser;
  auto& self = *static_cast<DiscreteProblem*>(problem);
  if (self.keeps_jacobian_ && A == P && shift == self.last_shift_) PetscFunctionReturn(0);
  self.last_shift_ = shift;
  self.model_->set_time(time);
  GhostedArray u, u_dot;
  PetscCall(u.open(self.dm_, state));
  PetscCall(u_dot.open(self.dm_, rate));

  PetscCall(MatZeroEntries(P));
  PetscBool parallel;
  PetscCall(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(P), MATMPIAIJ, &parallel));
  Mat blocks[2] = {P, nullptr};
  if (parallel) PetscCall(MatMPIAIJGetSeqAIJ(P, &blocks[0], &blocks[1], nullptr));
  double* entries[2] = {nullptr, nullptr};
  for (int k = 0; k < 2 && blocks[k]; ++k) PetscCall(MatSeqAIJGetArray(blocks[k], &entries[k]));
  self.model_->jacobian(u.data(), u_dot.data(), shift, self.places_, entries[0], entries[1]);
  for (int k = 0; k < 2 && blocks[k]; ++k) PetscCall(MatSeqAIJRestoreArray(blocks[k], &entries[k]));
  PetscCall(MatAssemblyBegin(P, MAT_FINAL_ASSEMBLY));
  PetscCall(MatAssemblyEnd(P, MAT_FINAL_ASSEMBLY));
  if (A != P) {  // a matrix-free operator needs to know that the state has changed
    PetscCall(MatAssemblyBegin(A, MAT_FINAL_ASSEMBLY));
    PetscCall(MatAssemblyEnd(A, MAT_FINAL_ASSEMBLY));
  }
  PetscCall(u_dot.close());
  PetscCall(u.close());
  PetscFunctionReturn(0);
}

}  // namespace scree
