#include "scree/stepping/orderings.hpp"

#include <metis.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "scree/grid/index.hpp"
#include "scree/stepping/grid_of_nodes.hpp"

namespace scree {

namespace {

/// Brings together what PETSc factors together: rows that follow one another and have one pattern, an "inode". Its
/// factorisations take for granted that an ordering leaves them so; where it does not they write beyond their arrays.
PetscErrorCode keep_inodes(Mat A, std::vector<PetscInt>& order) {
  PetscFunctionBeginUser;
  PetscInt count = 0, *sizes = nullptr;
  PetscCall(MatInodeGetInodeSizes(A, &count, &sizes, nullptr));
  if (!sizes) PetscFunctionReturn(0);
  std::vector<PetscInt> first_of_row;
  first_of_row.reserve(order.size());
  for (PetscInt k = 0; k < count; ++k) first_of_row.insert(first_of_row.end(), sizes[k], first_of_row.size());
  std::vector<PetscInt> kept;
  kept.reserve(order.size());
  std::vector<bool> done(order.size(), false);
  for (const PetscInt row : order) {
    const PetscInt first = first_of_row[row];
    for (PetscInt r = first; r < static_cast<PetscInt>(order.size()) && first_of_row[r] == first && !done[r]; ++r) {
      kept.push_back(r);
      done[r] = true;
    }
  }
  order = std::move(kept);
  PetscFunctionReturn(0);
}

/// The ordering that both rows and columns have, but for inodes that it would take apart.
PetscErrorCode give_order(Mat A, std::vector<PetscInt> order, IS* rows, IS* columns) {
  PetscFunctionBeginUser;
  PetscCall(keep_inodes(A, order));
  PetscCall(
      ISCreateGeneral(PETSC_COMM_SELF, static_cast<PetscInt>(order.size()), order.data(), PETSC_COPY_VALUES, rows));
  PetscCall(ISSetPermutation(*rows));
  PetscCall(ISDuplicate(*rows, columns));
  PetscCall(ISSetPermutation(*columns));
  PetscFunctionReturn(0);
}

/// The nodes of a rank from the first to the last, column by column along `axis`; as they are where their grid is not
/// known.
PetscErrorCode nodes_by_columns(Mat A, int axis, PetscInt count, std::vector<PetscInt>& nodes) {
  PetscFunctionBeginUser;
  PetscInt size[max_dim] = {0, 0, 0};
  DM dm;
  nodes.resize(static_cast<std::size_t>(count));
  std::iota(nodes.begin(), nodes.end(), 0);
  PetscCall(get_grid_of_nodes(A, &dm));
  if (dm) PetscCall(DMDAGetCorners(dm, nullptr, nullptr, nullptr, &size[0], &size[1], &size[2]));
  if (size[0] * size[1] * size[2] != count) PetscFunctionReturn(0);
  const PetscInt stride = axis == 0 ? 1 : axis == 1 ? size[0] : size[0] * size[1];
  std::stable_sort(nodes.begin(), nodes.end(), [&](PetscInt a, PetscInt b) {
    return a - a / stride % size[axis] * stride < b - b / stride % size[axis] * stride;  // the foot of the column
  });
  PetscFunctionReturn(0);
}

template <int axis>
PetscErrorCode columns_along(Mat A, MatOrderingType, IS* rows, IS* columns) {
  PetscFunctionBeginUser;
  PetscInt size, unknowns;
  std::vector<PetscInt> nodes, order;
  PetscCall(MatGetLocalSize(A, &size, nullptr));
  PetscCall(MatGetBlockSize(A, &unknowns));
  PetscCall(nodes_by_columns(A, axis, size / unknowns, nodes));
  for (auto node = nodes.rbegin(); node != nodes.rend(); ++node)
    for (PetscInt c = 0; c < unknowns; ++c) order.push_back(*node * unknowns + c);
  PetscCall(give_order(A, std::move(order), rows, columns));
  PetscFunctionReturn(0);
}

/// The graph of A + A^T without its diagonal, as METIS takes it.
struct Graph {
  std::vector<idx_t> first, neighbour;

  Graph(PetscInt size, const PetscInt* row, const PetscInt* column) {
    std::vector<std::vector<idx_t>> neighbours(static_cast<std::size_t>(size));
    for (PetscInt i = 0; i < size; ++i)
      for (PetscInt k = row[i]; k < row[i + 1]; ++k) {
        if (column[k] == i) continue;
        neighbours[static_cast<std::size_t>(i)].push_back(static_cast<idx_t>(column[k]));
        neighbours[static_cast<std::size_t>(column[k])].push_back(static_cast<idx_t>(i));
      }
    first.push_back(0);
    for (auto& list : neighbours) {
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
      neighbour.insert(neighbour.end(), list.begin(), list.end());
      first.push_back(static_cast<idx_t>(neighbour.size()));
    }
  }
};

PetscErrorCode metis_nested_dissection(Mat A, MatOrderingType, IS* rows, IS* columns) {
  PetscFunctionBeginUser;
  const PetscInt *row, *column;
  PetscInt size;
  PetscBool done;
  PetscCall(MatGetRowIJ(A, 0, PETSC_FALSE, PETSC_FALSE, &size, &row, &column, &done));
  PetscCheck(done, PETSC_COMM_SELF, PETSC_ERR_SUP, "the ordering metis is for AIJ matrices of one rank");
  Graph graph(size, row, column);
  PetscCall(MatRestoreRowIJ(A, 0, PETSC_FALSE, PETSC_FALSE, nullptr, &row, &column, &done));
  std::vector<idx_t> old_of_new(static_cast<std::size_t>(size)), new_of_old(old_of_new);
  auto count = static_cast<idx_t>(size);
  const int status = METIS_NodeND(&count, graph.first.data(), graph.neighbour.data(), nullptr, nullptr,
                                  old_of_new.data(), new_of_old.data());
  PetscCheck(status == METIS_OK, PETSC_COMM_SELF, PETSC_ERR_LIB, "METIS_NodeND returns %d", status);
  PetscCall(give_order(A, {old_of_new.begin(), old_of_new.end()}, rows, columns));
  PetscFunctionReturn(0);
}

}  // namespace

PetscErrorCode register_orderings() {
  PetscFunctionBeginUser;
  PetscCall(MatOrderingRegister("columns_x", columns_along<0>));
  PetscCall(MatOrderingRegister("columns_y", columns_along<1>));
  PetscCall(MatOrderingRegister("columns_z", columns_along<2>));
  PetscCall(MatOrderingRegister("metis", metis_nested_dissection));
  PetscFunctionReturn(0);
}

}  // namespace scree
