#include "scree/stepping/orderings.hpp"

#include <metis.h>

#include <algorithm>
#include <vector>

namespace scree {

namespace {

/// The ordering that both rows and columns have. Takes `order`, of PetscMalloc.
PetscErrorCode give_order(PetscInt size, PetscInt* order, IS* rows, IS* columns) {
  PetscFunctionBeginUser;
  PetscCall(ISCreateGeneral(PETSC_COMM_SELF, size, order, PETSC_OWN_POINTER, rows));
  PetscCall(ISSetPermutation(*rows));
  PetscCall(ISDuplicate(*rows, columns));
  PetscCall(ISSetPermutation(*columns));
  PetscFunctionReturn(0);
}

PetscErrorCode last_node_first(Mat A, MatOrderingType, IS* rows, IS* columns) {
  PetscFunctionBeginUser;
  PetscInt size, unknowns;
  PetscInt* order;
  PetscCall(MatGetLocalSize(A, &size, nullptr));
  PetscCall(MatGetBlockSize(A, &unknowns));
  PetscCall(PetscMalloc1(size, &order));
  for (PetscInt k = 0; k < size; ++k) order[k] = size - unknowns - k / unknowns * unknowns + k % unknowns;
  PetscCall(give_order(size, order, rows, columns));
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
  PetscInt* order;
  PetscCall(MatGetRowIJ(A, 0, PETSC_FALSE, PETSC_FALSE, &size, &row, &column, &done));
  PetscCheck(done, PETSC_COMM_SELF, PETSC_ERR_SUP, "the ordering metis is for AIJ matrices of one rank");
  Graph graph(size, row, column);
  PetscCall(MatRestoreRowIJ(A, 0, PETSC_FALSE, PETSC_FALSE, nullptr, &row, &column, &done));
  std::vector<idx_t> old_of_new(static_cast<std::size_t>(size)), new_of_old(old_of_new);
  auto count = static_cast<idx_t>(size);
  const int status = METIS_NodeND(&count, graph.first.data(), graph.neighbour.data(), nullptr, nullptr,
                                  old_of_new.data(), new_of_old.data());
  PetscCheck(status == METIS_OK, PETSC_COMM_SELF, PETSC_ERR_LIB, "METIS_NodeND returns %d", status);
  PetscCall(PetscMalloc1(size, &order));
  std::copy(old_of_new.begin(), old_of_new.end(), order);
  PetscCall(give_order(size, order, rows, columns));
  PetscFunctionReturn(0);
}

}  // namespace

PetscErrorCode register_orderings() {
  PetscFunctionBeginUser;
  PetscCall(MatOrderingRegister("last_node_first", last_node_first));
  PetscCall(MatOrderingRegister("metis", metis_nested_dissection));
  PetscFunctionReturn(0);
}

}  // namespace scree
