#include "scree/stepping/condensation.hpp"

#include <gtest/gtest.h>
#include <petscksp.h>

#include <cmath>
#include <functional>
#include <random>

#include "../../support/sample_problem.hpp"
#include "scree/stepping/condensed_preconditioner.hpp"

namespace scree::test {
namespace {

/// A number in (-1, 1) that belongs to an entry, the same on any ranks.
double entry_of(PetscInt row, PetscInt column) {
  std::minstd_rand random(static_cast<unsigned>(7919 * row + 104729 * column + 1));
  random.discard(5);
  return std::uniform_real_distribution<double>(-1, 1)(random);
}

/// A row of nodes of 4 unknowns, 1 and 3 of which are to be eliminated, in the order of a chain that is spread over the
/// ranks. `couples(row, column)` says which entries there are beside the diagonal.
class Chain {
 public:
  static constexpr PetscInt unknowns = 4, nodes = 11;

  explicit Chain(const std::function<bool(PetscInt, PetscInt)>& couples) {
    PetscInt own = PETSC_DECIDE, all = nodes, first, end;
    check(PetscSplitOwnership(PETSC_COMM_WORLD, &own, &all));
    check(MatCreate(PETSC_COMM_WORLD, &matrix));
    check(MatSetSizes(matrix, own * unknowns, own * unknowns, PETSC_DETERMINE, PETSC_DETERMINE));
    check(MatSetBlockSize(matrix, unknowns));
    check(MatSetType(matrix, MATAIJ));
    check(MatSeqAIJSetPreallocation(matrix, nodes * unknowns, nullptr));
    check(MatMPIAIJSetPreallocation(matrix, nodes * unknowns, nullptr, nodes * unknowns, nullptr));
    check(MatGetOwnershipRange(matrix, &first, &end));
    for (PetscInt row = first; row < end; ++row)
      for (PetscInt column = 0; column < nodes * unknowns; ++column)
        if (row == column || couples(row, column))
          check(MatSetValue(matrix, row, column, entry_of(row, column) + (row == column ? 9 : 0), INSERT_VALUES));
    check(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
    check(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
  }
  ~Chain() { (void)MatDestroy(&matrix); }
  Chain(const Chain&) = delete;
  Chain& operator=(const Chain&) = delete;

  static bool eliminated(PetscInt unknown) { return unknown % unknowns == 1 || unknown % unknowns == 3; }
  static PetscInt node(PetscInt unknown) { return unknown / unknowns; }
  static PetscInt distance(PetscInt a, PetscInt b) { return std::abs(node(a) - node(b)); }

  Mat matrix = nullptr;
};

/// Eliminated unknowns couple in their node alone, and reach others in it and in the next; the core reaches far enough
/// to have a place for all that the elimination leaves.
bool local_couplings(PetscInt row, PetscInt column) {
  const PetscInt distance = Chain::distance(row, column);
  if (Chain::eliminated(row) && Chain::eliminated(column)) return distance == 0;
  if (Chain::eliminated(row) || Chain::eliminated(column)) return distance <= 1;
  return distance <= 2;
}

class Condensed : public testing::Test {
 protected:
  Condensed() {
    check(PetscOptionsCreate(&options_));
    check(PetscOptionsPush(options_));
    set({{"pc_type", "condensed"},
         {"pc_condensed_eliminated", "1,3"},
         {"condensed_core_pc_type", "lu"},
         {"condensed_core_pc_factor_mat_solver_type", "mumps"},
         {"condensed_rest_pc_type", "lu"},
         {"condensed_rest_pc_factor_mat_solver_type", "mumps"}});
    check(register_condensed_preconditioner());
  }
  ~Condensed() override {
    (void)PetscOptionsPop();
    (void)PetscOptionsDestroy(&options_);
  }
  static void set(const std::vector<std::pair<std::string, std::string>>& list) {
    for (const auto& [name, value] : list) check(PetscOptionsSetValue(nullptr, ("-" + name).c_str(), value.c_str()));
  }

 private:
  PetscOptions options_ = nullptr;
};

/// |A y - x| / |x| with y the preconditioned x.
double defect(PC pc, Mat A) {
  Vec x, y;
  double size, left;
  PetscInt first, end;
  check(MatCreateVecs(A, &y, &x));
  check(VecGetOwnershipRange(x, &first, &end));
  for (PetscInt k = first; k < end; ++k)
    check(VecSetValue(x, k, std::sin(1.0 + static_cast<double>(k)), INSERT_VALUES));
  check(VecAssemblyBegin(x));
  check(VecAssemblyEnd(x));
  check(VecNorm(x, NORM_2, &size));
  check(PCApply(pc, x, y));
  check(VecScale(x, -1));
  check(MatMultAdd(A, y, x, x));
  check(VecNorm(x, NORM_2, &left));
  check(VecDestroy(&x));
  check(VecDestroy(&y));
  return left / size;
}

class Preconditioner {
 public:
  explicit Preconditioner(Mat A) {
    check(PCCreate(PETSC_COMM_WORLD, &pc));
    check(PCSetOperators(pc, A, A));
    check(PCSetFromOptions(pc));
    check(PCSetUp(pc));
  }
  ~Preconditioner() { (void)PCDestroy(&pc); }
  Preconditioner(const Preconditioner&) = delete;
  Preconditioner& operator=(const Preconditioner&) = delete;
  PC pc = nullptr;
};

TEST_F(Condensed, IsTheInverseWhereEliminatedUnknownsAreLocalAndTheirFillHasAPlace) {
  const Chain chain(local_couplings);
  const Preconditioner condensed(chain.matrix);
  EXPECT_LT(defect(condensed.pc, chain.matrix), 1e-12);
}

/// Other entries, the same pattern.
TEST_F(Condensed, FollowsTheEntries) {
  const Chain chain(local_couplings);
  const Preconditioner condensed(chain.matrix);
  check(MatShift(chain.matrix, 3));
  check(PCSetUp(condensed.pc));
  EXPECT_LT(defect(condensed.pc, chain.matrix), 1e-12);
}

/// Couplings of eliminated unknowns to their neighbours are what makes it less than exact.
TEST_F(Condensed, IsNotTheInverseWhereEliminatedUnknownsCoupleToNeighbours) {
  const Chain chain([](PetscInt row, PetscInt column) {
    return local_couplings(row, column) ||
           (Chain::eliminated(row) && Chain::eliminated(column) && Chain::distance(row, column) == 1);
  });
  const Preconditioner condensed(chain.matrix);
  EXPECT_GT(defect(condensed.pc, chain.matrix), 1e-4);
}

TEST_F(Condensed, FailsTheSolverAroundItWhereANodeHasNoInverse) {
  const Chain chain(local_couplings);
  PetscInt first, end;
  check(MatGetOwnershipRange(chain.matrix, &first, &end));
  for (const PetscInt row : {21, 23})
    for (const PetscInt column : {21, 23})
      if (row >= first && row < end) check(MatSetValue(chain.matrix, row, column, 0, INSERT_VALUES));
  check(MatAssemblyBegin(chain.matrix, MAT_FINAL_ASSEMBLY));
  check(MatAssemblyEnd(chain.matrix, MAT_FINAL_ASSEMBLY));
  KSP ksp;
  Vec x, y;
  KSPConvergedReason reason;
  check(KSPCreate(PETSC_COMM_WORLD, &ksp));
  check(KSPSetOperators(ksp, chain.matrix, chain.matrix));
  check(KSPSetFromOptions(ksp));
  check(MatCreateVecs(chain.matrix, &y, &x));
  check(VecSet(x, 1));
  check(KSPSolve(ksp, x, y));
  check(KSPGetConvergedReason(ksp, &reason));
  EXPECT_EQ(reason, KSP_DIVERGED_PC_FAILED);
  check(KSPDestroy(&ksp));
  check(VecDestroy(&x));
  check(VecDestroy(&y));
}

/// The entries of S = A_cc - A_cr D^-1 A_rc in full, node blocks of D; `lump` as Condensation does it.
struct Dense {
  static constexpr PetscInt size = Chain::nodes * 2;
  double entry[size][size] = {};
};

double value(const std::function<bool(PetscInt, PetscInt)>& couples, PetscInt row, PetscInt column) {
  return row == column || couples(row, column) ? entry_of(row, column) + (row == column ? 9 : 0) : 0;
}

Dense full_complement(const std::function<bool(PetscInt, PetscInt)>& couples) {
  Dense S;
  const auto core = [](PetscInt k) { return k / 2 * 4 + k % 2 * 2; };
  const auto a = [&](PetscInt row, PetscInt column) { return value(couples, row, column); };
  for (PetscInt i = 0; i < Dense::size; ++i)
    for (PetscInt j = 0; j < Dense::size; ++j) {
      S.entry[i][j] = a(core(i), core(j));
      for (PetscInt node = 0; node < Chain::nodes; ++node) {
        const PetscInt p = 4 * node + 1, q = 4 * node + 3;
        const double det = a(p, p) * a(q, q) - a(p, q) * a(q, p);
        const double x = (a(q, q) * a(p, core(j)) - a(p, q) * a(q, core(j))) / det,
                     y = (a(p, p) * a(q, core(j)) - a(q, p) * a(p, core(j))) / det;
        S.entry[i][j] -= a(core(i), p) * x + a(core(i), q) * y;
      }
    }
  return S;
}

/// What has no place keeps the sum of the row over each component; what has one is exact.
TEST_F(Condensed, LumpsWhatHasNoPlace) {
  const auto couples = [](PetscInt row, PetscInt column) {
    const PetscInt distance = Chain::distance(row, column);
    return Chain::eliminated(row) && Chain::eliminated(column) ? distance == 0 : distance <= 1;
  };
  const Chain chain(couples);
  Condensation condensation;
  bool regular;
  check(condensation.create(chain.matrix, {1, 3}));
  check(condensation.update(chain.matrix, &regular));
  ASSERT_TRUE(regular);
  const Dense expected = full_complement(couples);
  PetscInt first, end;
  check(MatGetOwnershipRange(condensation.core(), &first, &end));
  for (PetscInt i = first; i < end; ++i) {
    PetscInt count;
    const PetscInt* columns;
    const double* values;
    double sum[2] = {0, 0}, all[2] = {0, 0};
    check(MatGetRow(condensation.core(), i, &count, &columns, &values));
    for (PetscInt k = 0; k < count; ++k) {
      EXPECT_LE(std::abs(columns[k] / 2 - i / 2), 1) << "row " << i << ": fill";
      if (columns[k] / 2 != i / 2) {
        EXPECT_NEAR(values[k], expected.entry[i][columns[k]], 1e-12) << i << ' ' << columns[k];
      }
      sum[columns[k] % 2] += values[k];
    }
    check(MatRestoreRow(condensation.core(), i, &count, &columns, &values));
    for (PetscInt j = 0; j < Dense::size; ++j) all[j % 2] += expected.entry[i][j];
    for (const int component : {0, 1}) EXPECT_NEAR(sum[component], all[component], 1e-12) << "row " << i;
  }
}

/// As p_g, whose row has no entry of its own but what holds it, and gets its operator by the elimination of u.
TEST_F(Condensed, KeepsFillWhereThereIsNothingElse) {
  const auto couples = [](PetscInt row, PetscInt column) {
    const PetscInt distance = Chain::distance(row, column);
    if (Chain::eliminated(row) && Chain::eliminated(column)) return distance == 0;
    if (row % 4 == 2 && column % 4 == 2) return false;
    return distance <= 1;
  };
  const Chain chain(couples);
  Condensation condensation;
  bool regular;
  check(condensation.create(chain.matrix, {1, 3}));
  check(condensation.update(chain.matrix, &regular));
  const Dense expected = full_complement(couples);
  PetscInt first, end;
  check(MatGetOwnershipRange(condensation.core(), &first, &end));
  for (PetscInt i = first; i < end; ++i)
    for (PetscInt j = 0; i % 2 == 1 && j < Dense::size; ++j) {
      double found;
      if (j % 2 == 0) continue;
      check(MatGetValue(condensation.core(), i, j, &found));
      EXPECT_NEAR(found, expected.entry[i][j], 1e-12) << i << ' ' << j;
    }
}

}  // namespace
}  // namespace scree::test
