#include "scree/stepping/line_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <utility>

#include "../../support/sample_problem.hpp"
#include "scree/stepping/petsc_versions.hpp"

namespace scree::test {
namespace {

/// One equation for one unknown.
struct Equation {
  std::function<double(double)> value, slope;
};

PetscErrorCode evaluate(SNES, Vec x, Vec f, void* equation) {
  PetscFunctionBeginUser;
  const double* at;
  PetscCall(VecGetArrayRead(x, &at));
  PetscCall(VecSetValue(f, 0, static_cast<Equation*>(equation)->value(at[0]), INSERT_VALUES));
  PetscCall(VecRestoreArrayRead(x, &at));
  PetscCall(VecAssemblyBegin(f));
  PetscCall(VecAssemblyEnd(f));
  PetscFunctionReturn(0);
}

PetscErrorCode differentiate(SNES, Vec x, Mat, Mat jacobian, void* equation) {
  PetscFunctionBeginUser;
  const double* at;
  PetscCall(VecGetArrayRead(x, &at));
  PetscCall(MatSetValue(jacobian, 0, 0, static_cast<Equation*>(equation)->slope(at[0]), INSERT_VALUES));
  PetscCall(VecRestoreArrayRead(x, &at));
  PetscCall(MatAssemblyBegin(jacobian, MAT_FINAL_ASSEMBLY));
  PetscCall(MatAssemblyEnd(jacobian, MAT_FINAL_ASSEMBLY));
  PetscFunctionReturn(0);
}

/// Where one Newton iteration from `start` ends, and why it ended.
std::pair<double, SNESConvergedReason> iterate(Equation equation, double start) {
  SNES snes;
  Vec x, f;
  Mat jacobian;
  SNESConvergedReason reason;
  const double* at;
  check(SNESCreate(PETSC_COMM_SELF, &snes));
  check(VecCreateSeq(PETSC_COMM_SELF, 1, &x));
  check(VecDuplicate(x, &f));
  check(MatCreateSeqAIJ(PETSC_COMM_SELF, 1, 1, 1, nullptr, &jacobian));
  check(SNESSetFunction(snes, f, evaluate, &equation));
  check(SNESSetJacobian(snes, jacobian, jacobian, differentiate, &equation));
  check(SNESSetTolerances(snes, 1e-14, 1e-14, 0, 1, petsc_unchanged));
  check(SNESSetType(snes, SNESNEWTONLS));
  check(use_guarded_full_steps(snes));
  check(VecSet(x, start));
  check(SNESSolve(snes, nullptr, x));
  check(SNESGetConvergedReason(snes, &reason));
  check(VecGetArrayRead(x, &at));
  const double end = at[0];
  check(VecRestoreArrayRead(x, &at));
  check(MatDestroy(&jacobian));
  for (Vec* vector : {&x, &f}) check(VecDestroy(vector));
  check(SNESDestroy(&snes));
  return {end, reason};
}

const Equation exponential{[](double x) { return std::exp(x) - 2; }, [](double x) { return std::exp(x); }};
const Equation root{[](double x) { return std::sqrt(x) - 0.1; }, [](double x) { return 0.5 / std::sqrt(x); }};

double full_step(const Equation& equation, double x) { return x - equation.value(x) / equation.slope(x); }

TEST(LineSearch, TakesTheFullStepThoughTheResidualRises) {
  const double start = -0.5, end = full_step(exponential, start);
  const double rise = std::abs(exponential.value(end) / exponential.value(start));
  ASSERT_GT(rise, 2);
  ASSERT_LT(rise, 10);
  EXPECT_NEAR(iterate(exponential, start).first, end, 1e-12);
}

TEST(LineSearch, HalvesAStepThatRaisesTheResidualTenfold) {
  const double start = -3, step = full_step(exponential, start) - start;
  EXPECT_NEAR(iterate(exponential, start).first, start + step / 8, 1e-10);
}

TEST(LineSearch, HalvesAStepToWhereTheResidualIsNotFinite) {
  const double start = 1, step = full_step(root, start) - start;
  ASSERT_LT(start + step, 0);
  EXPECT_NEAR(iterate(root, start).first, start + step / 2, 1e-12);
}

TEST(LineSearch, GivesUpAfterSixHalvings) {
  const Equation cliff{[](double x) { return x == 1 ? 1 : 1e3; }, [](double) { return 1.0; }};
  EXPECT_EQ(iterate(cliff, 1).second, SNES_DIVERGED_LINE_SEARCH);
}

}  // namespace
}  // namespace scree::test
