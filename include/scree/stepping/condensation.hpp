/// Static condensation of a matrix of nodes: unknowns that act on the rest mostly in their own node are eliminated node
/// by node, which leaves a smaller matrix for the others, the core:
///
///     [ A_cc  A_cr ] [ x_c ]
///     [ A_rc  A_rr ] [ x_r ],    S = A_cc - A_cr D^-1 A_rc,    D: the blocks of nodes on the diagonal of A_rr
#pragma once

#include <petscvec.h>

#include <cstdint>
#include <vector>

#include "scree/stepping/local_rows.hpp"

namespace scree {

/// The blocks of a matrix and S. Made once for a pattern, filled for each matrix that has it.
///
/// S has the pattern of A_cc. What falls outside of it is added to the entry of its row in its own node and component:
/// dropped, it would cost twice the iterations; kept, twice the entries of a factor. But where a row has no entry of a
/// component beyond its own node, all is kept: so does the elimination of u give p_g an operator.
class Condensation {
 public:
  Condensation() = default;
  ~Condensation();
  Condensation(const Condensation&) = delete;
  Condensation& operator=(const Condensation&) = delete;

  /// Collective. For AIJ matrices with the pattern of `A`, whose block size is that of a node. `eliminated`: components
  /// of a node, some but not all.
  PetscErrorCode create(Mat A, const std::vector<PetscInt>& eliminated);
  /// Collective. Takes the entries of A. `regular` is false where a block of D has no inverse, on whatever rank.
  PetscErrorCode update(Mat A, bool* regular);

  Mat core() const { return core_; }            ///< S
  Mat rest() const { return rest_; }            ///< A_rr
  Mat core_rest() const { return core_rest_; }  ///< A_cr
  Mat rest_core() const { return rest_core_; }  ///< A_rc

  /// Between a vector of all unknowns and its two parts.
  PetscErrorCode split(Vec all, Vec core, Vec rest) const;
  PetscErrorCode join(Vec core, Vec rest, Vec all) const;
  /// out = D^-1 in, for the eliminated unknowns.
  PetscErrorCode solve_nodes(Vec in, Vec out) const;

 private:
  using Pattern = std::vector<std::vector<PetscInt>>;  ///< global columns of each row

  PetscErrorCode find_ghosts(const LocalRows& A);
  PetscErrorCode create_block(Pattern& pattern, PetscInt width, Mat* block) const;
  PetscErrorCode create_blocks(const LocalRows& A);
  PetscErrorCode create_ghost_rows();
  PetscErrorCode number_ghosts();
  PetscErrorCode create_core(const LocalRows& A);
  void add_fill(PetscInt node, std::vector<PetscInt>& columns, const std::vector<PetscInt>& through) const;
  PetscErrorCode copy_blocks(const LocalRows& A, bool* regular);
  PetscErrorCode fetch_ghosts();
  PetscErrorCode fill_core(const LocalRows& A);
  void subtract(PetscInt node, PetscInt through, const double* row);
  template <class Work>
  void for_each_core_entry(PetscInt node, PetscInt k, Work&& work) const;

  MPI_Comm comm_ = MPI_COMM_NULL;
  PetscInt unknowns_ = 0, kept_ = 0, gone_ = 0;  ///< components of a node: all, in the core, eliminated
  PetscInt nodes_ = 0, first_node_ = 0;          ///< of this rank
  std::vector<PetscInt> place_;                  ///< of a component: in the core, or -1 - place among the eliminated
  // Ghosts are numbered behind what is this rank's.
  std::vector<PetscInt> ghost_nodes_;                 ///< that the rows here touch, rising
  std::vector<PetscInt> ghost_core_;                  ///< columns of the core on other ranks, rising
  std::array<std::vector<std::int32_t>, 2> columns_;  ///< of A, by part: column of the core, or -1 - that of the rest
  std::vector<std::uint8_t> component_;               ///< of a column of the core
  std::vector<PetscInt> rest_core_ghosts_;            ///< number in the core of a ghost column of A_rc ...
  std::vector<PetscInt> core_ghosts_;                 ///< ... and of S
  std::vector<PetscInt> ghost_columns_;               ///< ... and of an entry of ghost_rows_
  std::vector<double> inverse_;                       ///< D^-1 of a node, row by row
  std::vector<double*> slot_;                         ///< of a column of the core in the row of S at hand

  Mat core_ = nullptr, rest_ = nullptr, core_rest_ = nullptr, rest_core_ = nullptr;
  Mat* ghost_rows_ = nullptr;  ///< rows of A_rc of ghost_nodes_, on one rank a null pointer
  IS ghost_row_set_ = nullptr, all_columns_ = nullptr;
  Vec inverse_here_ = nullptr, inverse_there_ = nullptr;
  VecScatter to_ghosts_ = nullptr;
  LocalRows rest_core_rows_, ghost_row_values_;  ///< open while S is filled
};

}  // namespace scree
