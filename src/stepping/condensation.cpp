#include "scree/stepping/condensation.hpp"

#include <algorithm>
#include <cmath>

namespace scree {

namespace {

void sort_unique(std::vector<PetscInt>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

PetscInt place_in(const std::vector<PetscInt>& sorted, PetscInt value) {
  return static_cast<PetscInt>(std::lower_bound(sorted.begin(), sorted.end(), value) - sorted.begin());
}

/// Inverts a matrix of n x n, row by row, in place by Gauss-Jordan elimination with pivots of its columns.
bool invert(double* a, PetscInt n) {
  constexpr PetscInt most = 32;
  PetscInt exchanged[most];
  if (n > most) return false;
  for (PetscInt k = 0; k < n; ++k) {
    PetscInt pivot = k;
    for (PetscInt i = k + 1; i < n; ++i)
      if (std::abs(a[i * n + k]) > std::abs(a[pivot * n + k])) pivot = i;
    exchanged[k] = pivot;
    if (pivot != k) std::swap_ranges(a + k * n, a + (k + 1) * n, a + pivot * n);
    const double scale = 1 / a[k * n + k];
    if (!std::isfinite(scale)) return false;
    a[k * n + k] = 1;
    for (PetscInt j = 0; j < n; ++j) a[k * n + j] *= scale;
    for (PetscInt i = 0; i < n; ++i) {
      if (i == k) continue;
      const double factor = a[i * n + k];
      a[i * n + k] = 0;
      for (PetscInt j = 0; j < n; ++j) a[i * n + j] -= factor * a[k * n + j];
    }
  }
  for (PetscInt k = n - 1; k >= 0; --k)
    if (exchanged[k] != k)
      for (PetscInt i = 0; i < n; ++i) std::swap(a[i * n + k], a[i * n + exchanged[k]]);
  return true;
}

/// Where the next entry of a block goes, part by part.
struct Cursor {
  explicit Cursor(const LocalRows& block) {
    for (int k = 0; k < block.parts; ++k) next[k] = block.part[k].value;
  }
  std::array<PetscScalar*, 2> next{};
};

}  // namespace

Condensation::~Condensation() {
  const auto done = [](PetscErrorCode code) { PetscCallAbort(PETSC_COMM_SELF, code); };
  for (Mat* block : {&core_, &rest_, &core_rest_, &rest_core_}) done(MatDestroy(block));
  if (ghost_rows_) done(MatDestroySubMatrices(1, &ghost_rows_));
  done(ISDestroy(&ghost_row_set_));
  done(ISDestroy(&all_columns_));
  done(VecDestroy(&inverse_here_));
  done(VecDestroy(&inverse_there_));
  done(VecScatterDestroy(&to_ghosts_));
}

PetscErrorCode Condensation::create(Mat A, const std::vector<PetscInt>& eliminated) {
  PetscFunctionBeginUser;
  PetscCheck(!core_, PETSC_COMM_SELF, PETSC_ERR_ORDER, "a condensation is for one pattern");
  PetscCall(PetscObjectGetComm(reinterpret_cast<PetscObject>(A), &comm_));
  PetscCall(MatGetBlockSize(A, &unknowns_));
  place_.assign(static_cast<std::size_t>(unknowns_), 0);
  for (const PetscInt component : eliminated) {
    PetscCheck(component >= 0 && component < unknowns_, comm_, PETSC_ERR_ARG_OUTOFRANGE,
               "a node has no component %" PetscInt_FMT ", only 0 to %" PetscInt_FMT, component, unknowns_ - 1);
    place_[static_cast<std::size_t>(component)] = -1;
  }
  kept_ = gone_ = 0;
  for (PetscInt& place : place_) place = place < 0 ? -1 - gone_++ : kept_++;
  PetscCheck(kept_ > 0 && gone_ > 0, comm_, PETSC_ERR_ARG_WRONG, "some components of a node, not all, are eliminated");
  LocalRows rows;
  PetscCall(rows.open(A));
  PetscCall(find_ghosts(rows));
  PetscCall(create_blocks(rows));
  PetscCall(create_ghost_rows());
  PetscCall(number_ghosts());
  PetscCall(create_core(rows));
  PetscFunctionReturn(0);
}

PetscErrorCode Condensation::find_ghosts(const LocalRows& A) {
  PetscFunctionBeginUser;
  nodes_ = A.rows / unknowns_;
  first_node_ = A.first_row / unknowns_;
  for (PetscInt k = 0; k < A.ghost_count; ++k) {
    ghost_nodes_.push_back(A.ghosts[k] / unknowns_);
    const PetscInt place = place_[static_cast<std::size_t>(A.ghosts[k] % unknowns_)];
    if (place >= 0) ghost_core_.push_back(A.ghosts[k] / unknowns_ * kept_ + place);
  }
  sort_unique(ghost_nodes_);
  PetscFunctionReturn(0);
}

/// From a pattern that is sorted here.
PetscErrorCode Condensation::create_block(Pattern& pattern, PetscInt width, Mat* block) const {
  PetscFunctionBeginUser;
  const auto rows = static_cast<PetscInt>(pattern.size());
  const PetscInt first_column = first_node_ * width, end = first_column + nodes_ * width;
  std::vector<PetscInt> inner, outer;
  PetscInt first_row;
  for (auto& columns : pattern) {
    sort_unique(columns);
    inner.push_back(
        std::count_if(columns.begin(), columns.end(), [&](PetscInt c) { return c >= first_column && c < end; }));
    outer.push_back(static_cast<PetscInt>(columns.size()) - inner.back());
  }
  PetscCall(MatCreate(comm_, block));
  PetscCall(MatSetSizes(*block, rows, nodes_ * width, PETSC_DETERMINE, PETSC_DETERMINE));
  PetscCall(MatSetBlockSizes(*block, rows / std::max<PetscInt>(nodes_, 1), width));
  PetscCall(MatSetType(*block, MATAIJ));
  PetscCall(MatSeqAIJSetPreallocation(*block, 0, inner.data()));
  PetscCall(MatMPIAIJSetPreallocation(*block, 0, inner.data(), 0, outer.data()));
  PetscCall(MatGetOwnershipRange(*block, &first_row, nullptr));
  for (PetscInt row = 0; row < rows; ++row) {
    const auto& columns = pattern[static_cast<std::size_t>(row)];
    const std::vector<PetscScalar> zeros(columns.size(), 0.0);
    const PetscInt global = first_row + row;
    PetscCall(MatSetValues(*block, 1, &global, static_cast<PetscInt>(columns.size()), columns.data(), zeros.data(),
                           INSERT_VALUES));
  }
  PetscCall(MatAssemblyBegin(*block, MAT_FINAL_ASSEMBLY));
  PetscCall(MatAssemblyEnd(*block, MAT_FINAL_ASSEMBLY));
  PetscCall(MatSetOption(*block, MAT_NEW_NONZERO_LOCATION_ERR, PETSC_TRUE));
  PetscFunctionReturn(0);
}

/// Calls work(global column) for each entry of a row of A.
template <class Work>
static void for_each_column(const LocalRows& A, PetscInt row, Work&& work) {
  for (int k = 0; k < A.parts; ++k)
    for (PetscInt e = A.part[k].row[row]; e < A.part[k].row[row + 1]; ++e)
      work(k == 0 ? A.first_column + A.part[0].column[e] : A.ghosts[A.part[1].column[e]]);
}

PetscErrorCode Condensation::create_blocks(const LocalRows& A) {
  PetscFunctionBeginUser;
  Pattern rest, core_rest, rest_core;
  for (PetscInt row = 0; row < A.rows; ++row) {
    const bool kept = place_[static_cast<std::size_t>(row % unknowns_)] >= 0;
    std::vector<PetscInt> core_columns, rest_columns;
    for_each_column(A, row, [&](PetscInt column) {
      const PetscInt node = column / unknowns_, place = place_[static_cast<std::size_t>(column % unknowns_)];
      if (place >= 0)
        core_columns.push_back(node * kept_ + place);
      else
        rest_columns.push_back(node * gone_ - 1 - place);
    });
    if (kept) {
      core_rest.push_back(std::move(rest_columns));
    } else {
      rest.push_back(std::move(rest_columns));
      rest_core.push_back(std::move(core_columns));
    }
  }
  PetscCall(create_block(rest, gone_, &rest_));
  PetscCall(create_block(core_rest, gone_, &core_rest_));
  PetscCall(create_block(rest_core, kept_, &rest_core_));
  PetscFunctionReturn(0);
}

/// And the way of D^-1 to the ranks that need it.
PetscErrorCode Condensation::create_ghost_rows() {
  PetscFunctionBeginUser;
  inverse_.assign((static_cast<std::size_t>(nodes_) + ghost_nodes_.size()) * gone_ * gone_, 0.0);
  PetscMPIInt ranks;
  PetscCallMPI(MPI_Comm_size(comm_, &ranks));
  if (ranks == 1) PetscFunctionReturn(0);
  PetscInt width;
  IS from;
  std::vector<PetscInt> rows;
  const auto count = static_cast<PetscInt>(ghost_nodes_.size());
  for (const PetscInt node : ghost_nodes_)
    for (PetscInt k = 0; k < gone_; ++k) rows.push_back(node * gone_ + k);
  PetscCall(MatGetSize(rest_core_, nullptr, &width));
  PetscCall(ISCreateGeneral(PETSC_COMM_SELF, count * gone_, rows.data(), PETSC_COPY_VALUES, &ghost_row_set_));
  PetscCall(ISCreateStride(PETSC_COMM_SELF, width, 0, 1, &all_columns_));
  PetscCall(MatCreateSubMatrices(rest_core_, 1, &ghost_row_set_, &all_columns_, MAT_INITIAL_MATRIX, &ghost_rows_));

  const PetscInt block = gone_ * gone_;
  PetscCall(VecCreateMPIWithArray(comm_, block, nodes_ * block, PETSC_DETERMINE, inverse_.data(), &inverse_here_));
  PetscCall(
      VecCreateSeqWithArray(PETSC_COMM_SELF, block, count * block, inverse_.data() + nodes_ * block, &inverse_there_));
  PetscCall(ISCreateBlock(PETSC_COMM_SELF, block, count, ghost_nodes_.data(), PETSC_COPY_VALUES, &from));
  PetscCall(VecScatterCreate(inverse_here_, from, inverse_there_, nullptr, &to_ghosts_));
  PetscCall(ISDestroy(&from));
  PetscFunctionReturn(0);
}

PetscErrorCode Condensation::number_ghosts() {
  PetscFunctionBeginUser;
  const PetscInt first = first_node_ * kept_, end = first + nodes_ * kept_;
  LocalRows there;
  if (ghost_rows_) {
    PetscCall(there.open(ghost_rows_[0]));
    ghost_columns_.assign(there.part[0].column, there.part[0].column + there.part[0].row[there.rows]);
    for (const PetscInt column : ghost_columns_)
      if (column < first || column >= end) ghost_core_.push_back(column);
  }
  sort_unique(ghost_core_);
  const auto number = [&](PetscInt column) {
    return column >= first && column < end ? column - first : nodes_ * kept_ + place_in(ghost_core_, column);
  };
  for (PetscInt& column : ghost_columns_) column = number(column);
  LocalRows here;
  PetscCall(here.open(rest_core_));
  for (PetscInt k = 0; k < here.ghost_count; ++k) rest_core_ghosts_.push_back(number(here.ghosts[k]));

  for (PetscInt column = first; column < end; ++column) component_.push_back(static_cast<std::uint8_t>(column % kept_));
  for (const PetscInt column : ghost_core_) component_.push_back(static_cast<std::uint8_t>(column % kept_));
  slot_.assign(component_.size(), nullptr);
  PetscFunctionReturn(0);
}

/// Calls work(column of the core, place of the entry) for row k of A_rc of a node; rest_core_rows_ and
/// ghost_row_values_ are open.
template <class Work>
void Condensation::for_each_core_entry(PetscInt node, PetscInt k, Work&& work) const {
  if (node >= nodes_) {
    const LocalRows::Part& there = ghost_row_values_.part[0];
    const PetscInt row = (node - nodes_) * gone_ + k;
    for (PetscInt e = there.row[row]; e < there.row[row + 1]; ++e)
      work(ghost_columns_[static_cast<std::size_t>(e)], there.value[e]);
    return;
  }
  const PetscInt row = node * gone_ + k;
  const auto& [here, there] = rest_core_rows_.part;
  for (PetscInt e = here.row[row]; e < here.row[row + 1]; ++e) work(here.column[e], here.value[e]);
  if (rest_core_rows_.parts == 1) return;
  for (PetscInt e = there.row[row]; e < there.row[row + 1]; ++e)
    work(rest_core_ghosts_[static_cast<std::size_t>(there.column[e])], there.value[e]);
}

PetscErrorCode Condensation::create_core(const LocalRows& A) {
  PetscFunctionBeginUser;
  const PetscInt first = first_node_ * kept_, own = nodes_ * kept_;
  const auto global = [&](PetscInt column) {
    return column < own ? first + column : ghost_core_[static_cast<std::size_t>(column - own)];
  };
  for (int k = 0; k < A.parts; ++k) {
    const PetscInt count = k == 0 ? A.columns : A.ghost_count;
    for (PetscInt c = 0; c < count; ++c) {
      const PetscInt column = k == 0 ? A.first_column + c : A.ghosts[c];
      const PetscInt place = place_[static_cast<std::size_t>(column % unknowns_)], node = column / unknowns_;
      const PetscInt local = k == 0 ? node - first_node_ : nodes_ + place_in(ghost_nodes_, node);
      if (place < 0)
        columns_[k].push_back(static_cast<std::int32_t>(-1 - (local * gone_ - 1 - place)));
      else if (k == 0)
        columns_[k].push_back(static_cast<std::int32_t>(local * kept_ + place));
      else
        columns_[k].push_back(static_cast<std::int32_t>(own + place_in(ghost_core_, node * kept_ + place)));
    }
  }

  PetscCall(rest_core_rows_.open(rest_core_));
  if (ghost_rows_) PetscCall(ghost_row_values_.open(ghost_rows_[0]));
  Pattern pattern;
  for (PetscInt row = 0; row < A.rows; ++row) {
    if (place_[static_cast<std::size_t>(row % unknowns_)] < 0) continue;
    std::vector<PetscInt> columns, through;
    for (int k = 0; k < A.parts; ++k)
      for (PetscInt e = A.part[k].row[row]; e < A.part[k].row[row + 1]; ++e) {
        const PetscInt column = columns_[k][static_cast<std::size_t>(A.part[k].column[e])];
        if (column >= 0)
          columns.push_back(column);
        else
          through.push_back((-1 - column) / gone_);
      }
    sort_unique(through);
    add_fill(row / unknowns_, columns, through);
    for (PetscInt& column : columns) column = global(column);
    pattern.push_back(std::move(columns));
  }
  PetscCall(rest_core_rows_.close());
  PetscCall(ghost_row_values_.close());
  PetscCall(create_block(pattern, kept_, &core_));

  LocalRows core;
  PetscCall(core.open(core_));
  for (PetscInt k = 0; k < core.ghost_count; ++k) core_ghosts_.push_back(own + place_in(ghost_core_, core.ghosts[k]));
  PetscFunctionReturn(0);
}

/// To the columns that a row of A_cc of `node` has, those of its fill that S has a place for, and the places to which
/// the others are added. `through`: nodes whose eliminated unknowns the row has.
void Condensation::add_fill(PetscInt node, std::vector<PetscInt>& columns, const std::vector<PetscInt>& through) const {
  const PetscInt begin = node * kept_, end = begin + kept_;
  std::vector<bool> reaches(static_cast<std::size_t>(kept_), false);
  for (const PetscInt column : columns)
    if (column < begin || column >= end) reaches[component_[static_cast<std::size_t>(column)]] = true;
  std::vector<PetscInt> fill;
  for (const PetscInt at : through)
    for (PetscInt k = 0; k < gone_; ++k)
      for_each_core_entry(at, k, [&](PetscInt column, double) { fill.push_back(column); });
  sort_unique(fill);
  std::sort(columns.begin(), columns.end());
  const auto before = static_cast<std::ptrdiff_t>(columns.size());
  for (const PetscInt column : fill) {
    if (std::binary_search(columns.begin(), columns.begin() + before, column)) continue;
    const PetscInt component = component_[static_cast<std::size_t>(column)];
    columns.push_back(reaches[static_cast<std::size_t>(component)] ? begin + component : column);
  }
}

PetscErrorCode Condensation::update(Mat A, bool* regular) {
  PetscFunctionBeginUser;
  LocalRows rows;
  PetscCall(rows.open(A));
  PetscCall(copy_blocks(rows, regular));
  PetscCallMPI(MPI_Allreduce(MPI_IN_PLACE, regular, 1, MPI_CXX_BOOL, MPI_LAND, comm_));
  if (!*regular) PetscFunctionReturn(0);
  PetscCall(fetch_ghosts());
  PetscCall(fill_core(rows));
  PetscFunctionReturn(0);
}

/// A_rr, A_cr, A_rc and D^-1. Columns have the same order in A and in its blocks.
PetscErrorCode Condensation::copy_blocks(const LocalRows& A, bool* regular) {
  PetscFunctionBeginUser;
  *regular = true;
  {
    LocalRows rest, core_rest, rest_core;
    PetscCall(rest.open_to_change(rest_));
    PetscCall(core_rest.open_to_change(core_rest_));
    PetscCall(rest_core.open_to_change(rest_core_));
    Cursor to_rest(rest), to_core_rest(core_rest), to_rest_core(rest_core);
    std::fill(inverse_.begin(), inverse_.end(), 0.0);
    for (PetscInt node = 0, row = 0; node < nodes_; ++node) {
      double* block = inverse_.data() + node * gone_ * gone_;
      for (PetscInt component = 0; component < unknowns_; ++component, ++row) {
        const PetscInt place = place_[static_cast<std::size_t>(component)], first = node * gone_;
        for (int k = 0; k < A.parts; ++k) {
          const LocalRows::Part& part = A.part[k];
          for (PetscInt e = part.row[row]; e < part.row[row + 1]; ++e) {
            const PetscInt column = columns_[k][static_cast<std::size_t>(part.column[e])], of_rest = -1 - column;
            if (place >= 0) {
              if (column < 0) *to_core_rest.next[k]++ = part.value[e];
            } else if (column >= 0) {
              *to_rest_core.next[k]++ = part.value[e];
            } else {
              *to_rest.next[k]++ = part.value[e];
              if (of_rest >= first && of_rest < first + gone_)
                block[(-1 - place) * gone_ + of_rest - first] = part.value[e];
            }
          }
        }
      }
      *regular = invert(block, gone_) && *regular;
    }
  }
  for (Mat block : {rest_, core_rest_, rest_core_}) {
    PetscCall(MatAssemblyBegin(block, MAT_FINAL_ASSEMBLY));
    PetscCall(MatAssemblyEnd(block, MAT_FINAL_ASSEMBLY));
  }
  PetscFunctionReturn(0);
}

PetscErrorCode Condensation::fetch_ghosts() {
  PetscFunctionBeginUser;
  if (!ghost_rows_) PetscFunctionReturn(0);
  PetscCall(MatCreateSubMatrices(rest_core_, 1, &ghost_row_set_, &all_columns_, MAT_REUSE_MATRIX, &ghost_rows_));
  PetscCall(VecScatterBegin(to_ghosts_, inverse_here_, inverse_there_, INSERT_VALUES, SCATTER_FORWARD));
  PetscCall(VecScatterEnd(to_ghosts_, inverse_here_, inverse_there_, INSERT_VALUES, SCATTER_FORWARD));
  PetscFunctionReturn(0);
}

PetscErrorCode Condensation::fill_core(const LocalRows& A) {
  PetscFunctionBeginUser;
  PetscCall(rest_core_rows_.open(rest_core_));
  if (ghost_rows_) PetscCall(ghost_row_values_.open(ghost_rows_[0]));
  LocalRows core;
  PetscCall(core.open_to_change(core_));
  std::vector<double> of_node(static_cast<std::size_t>(gone_));
  PetscInt own_row = 0;
  const auto for_each_slot = [&](auto&& work) {
    for (int k = 0; k < core.parts; ++k)
      for (PetscInt e = core.part[k].row[own_row]; e < core.part[k].row[own_row + 1]; ++e) {
        const PetscInt column = core.part[k].column[e];
        work(slot_[static_cast<std::size_t>(k == 0 ? column : core_ghosts_[static_cast<std::size_t>(column)])],
             core.part[k].value + e);
      }
  };
  for (PetscInt row = 0; row < A.rows; ++row) {
    if (place_[static_cast<std::size_t>(row % unknowns_)] < 0) continue;
    for_each_slot([](double*& slot, double* value) {
      *value = 0;
      slot = value;
    });
    for (int k = 0; k < A.parts; ++k) {
      const LocalRows::Part& part = A.part[k];
      PetscInt through = -1;
      for (PetscInt e = part.row[row]; e < part.row[row + 1]; ++e) {
        const PetscInt column = columns_[k][static_cast<std::size_t>(part.column[e])];
        if (column >= 0) {
          *slot_[static_cast<std::size_t>(column)] += part.value[e];
          continue;
        }
        const PetscInt node = (-1 - column) / gone_;
        if (node != through && through >= 0) subtract(row / unknowns_, through, of_node.data());
        if (node != through) std::fill(of_node.begin(), of_node.end(), 0.0);
        through = node;
        of_node[static_cast<std::size_t>(-1 - column - node * gone_)] = part.value[e];
      }
      if (through >= 0) subtract(row / unknowns_, through, of_node.data());
    }
    for_each_slot([](double*& slot, double*) { slot = nullptr; });
    ++own_row;
  }
  PetscCall(core.close());
  PetscCall(rest_core_rows_.close());
  PetscCall(ghost_row_values_.close());
  PetscCall(MatAssemblyBegin(core_, MAT_FINAL_ASSEMBLY));
  PetscCall(MatAssemblyEnd(core_, MAT_FINAL_ASSEMBLY));
  PetscFunctionReturn(0);
}

/// What a row of S of `node` loses by the eliminated unknowns of the node `through`, `row` being its entries there.
void Condensation::subtract(PetscInt node, PetscInt through, const double* row) {
  const double* inverse = inverse_.data() + through * gone_ * gone_;
  for (PetscInt k = 0; k < gone_; ++k) {
    double share = 0;
    for (PetscInt j = 0; j < gone_; ++j) share += row[j] * inverse[j * gone_ + k];
    if (share == 0) continue;
    for_each_core_entry(through, k, [&](PetscInt column, double value) {
      double* slot = slot_[static_cast<std::size_t>(column)];
      if (!slot) slot = slot_[static_cast<std::size_t>(node * kept_) + component_[static_cast<std::size_t>(column)]];
      *slot -= share * value;
    });
  }
}

PetscErrorCode Condensation::split(Vec all, Vec core, Vec rest) const {
  PetscFunctionBeginUser;
  const double* from;
  double *c, *r;
  PetscCall(VecGetArrayRead(all, &from));
  PetscCall(VecGetArrayWrite(core, &c));
  PetscCall(VecGetArrayWrite(rest, &r));
  for (PetscInt node = 0, k = 0; node < nodes_; ++node)
    for (const PetscInt place : place_)
      (place >= 0 ? c[node * kept_ + place] : r[node * gone_ - 1 - place]) = from[k++];
  PetscCall(VecRestoreArrayRead(all, &from));
  PetscCall(VecRestoreArrayWrite(core, &c));
  PetscCall(VecRestoreArrayWrite(rest, &r));
  PetscFunctionReturn(0);
}

PetscErrorCode Condensation::join(Vec core, Vec rest, Vec all) const {
  PetscFunctionBeginUser;
  const double *c, *r;
  double* to;
  PetscCall(VecGetArrayRead(core, &c));
  PetscCall(VecGetArrayRead(rest, &r));
  PetscCall(VecGetArrayWrite(all, &to));
  for (PetscInt node = 0, k = 0; node < nodes_; ++node)
    for (const PetscInt place : place_) to[k++] = place >= 0 ? c[node * kept_ + place] : r[node * gone_ - 1 - place];
  PetscCall(VecRestoreArrayRead(core, &c));
  PetscCall(VecRestoreArrayRead(rest, &r));
  PetscCall(VecRestoreArrayWrite(all, &to));
  PetscFunctionReturn(0);
}

PetscErrorCode Condensation::solve_nodes(Vec in, Vec out) const {
  PetscFunctionBeginUser;
  const double *x, *a = inverse_.data();
  double* y;
  PetscCall(VecGetArrayRead(in, &x));
  PetscCall(VecGetArrayWrite(out, &y));
  for (PetscInt node = 0; node < nodes_; ++node)
    for (PetscInt k = 0; k < gone_; ++k, a += gone_) {
      double sum = 0;
      for (PetscInt j = 0; j < gone_; ++j) sum += a[j] * x[node * gone_ + j];
      y[node * gone_ + k] = sum;
    }
  PetscCall(VecRestoreArrayRead(in, &x));
  PetscCall(VecRestoreArrayWrite(out, &y));
  PetscFunctionReturn(0);
}

}  // namespace scree
