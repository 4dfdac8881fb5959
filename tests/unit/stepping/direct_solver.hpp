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
    check(preset_.set("", solver()));
  }
  ~DirectSolver() override {
    (void)preset_.clear();
    (void)PetscOptionsPop();
    (void)PetscOptionsDestroy(&options_);
  }
  static PetscOptionList solver() { return preset_options(SolverPreset::direct, {}); }
  /// Tolerances for solvers with this prefix of options.
  static void solve_exactly(const std::string& prefix = "") {
    for (const auto& [name, value] : {std::pair("snes_rtol", "1e-12"), {"snes_atol", "1e-13"}, {"snes_stol", "0"}})
      check(PetscOptionsSetValue(nullptr, ("-" + prefix + name).c_str(), value));
  }

 private:
  PetscOptions options_ = nullptr;
  ScopedOptions preset_;
};

}  // namespace scree::test
