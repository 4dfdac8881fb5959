/// PETSc options that exist only within a test: a direct solver, and tolerances as given.
#pragma once

#include <gtest/gtest.h>

#include "../../support/sample_problem.hpp"
#include "scree/stepping/presets.hpp"

namespace scree::test {

class DirectSolver : public testing::Test {
 protected:
  DirectSolver() {
    check(PetscOptionsCreate(&options_));
    check(PetscOptionsPush(options_));
    check(apply_preset("direct", 4));
  }
  ~DirectSolver() override {
    (void)PetscOptionsPop();
    (void)PetscOptionsDestroy(&options_);
  }
  static void solve_exactly() {
    check(PetscOptionsSetValue(nullptr, "-snes_rtol", "1e-12"));
    check(PetscOptionsSetValue(nullptr, "-snes_atol", "1e-13"));
    check(PetscOptionsSetValue(nullptr, "-snes_stol", "0"));
  }

 private:
  PetscOptions options_ = nullptr;
};

}  // namespace scree::test
