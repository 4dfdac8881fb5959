#include "scree/stepping/line_search.hpp"

#include "scree/stepping/petsc_versions.hpp"

namespace scree {

namespace {

constexpr double tolerated_growth = 10;
constexpr int most_halvings = 6;

PetscErrorCode guarded_full_step(SNESLineSearch search, void*) {
  PetscFunctionBeginUser;
  Vec x, f, step, trial;
  SNES snes;
  PetscBool changed;
  double old_norm, norm, lambda = 1;
  PetscCall(SNESLineSearchGetVecs(search, &x, &f, &step, &trial, nullptr));
  PetscCall(SNESLineSearchGetSNES(search, &snes));
  PetscCall(VecNorm(f, NORM_2, &old_norm));
  PetscCall(SNESLineSearchPreCheck(search, x, step, &changed));
  PetscCall(SNESLineSearchSetReason(search, SNES_LINESEARCH_SUCCEEDED));
  for (int halvings = 0;; ++halvings, lambda *= 0.5) {
    PetscCall(VecWAXPY(trial, -lambda, step, x));
    PetscCall(SNESComputeFunction(snes, trial, f));
    PetscCall(VecNorm(f, NORM_2, &norm));
    if (norm <= tolerated_growth * old_norm) break;  // false for NaN
    if (halvings == most_halvings) {
      PetscCall(SNESLineSearchSetReason(search, SNES_LINESEARCH_FAILED_REDUCT));
      break;
    }
  }
  PetscCall(VecCopy(trial, x));
  PetscCall(VecScale(step, lambda));
  PetscCall(SNESLineSearchSetLambda(search, lambda));
  PetscCall(SNESLineSearchComputeNorms(search));
  PetscFunctionReturn(0);
}

}  // namespace

PetscErrorCode use_guarded_full_steps(SNES snes) {
  PetscFunctionBeginUser;
  PetscBool chosen;
  const char* prefix;
  PetscCall(SNESGetOptionsPrefix(snes, &prefix));
  PetscCall(PetscOptionsHasName(nullptr, prefix, "-snes_linesearch_type", &chosen));
  if (chosen) PetscFunctionReturn(0);
  SNESLineSearch search;
  PetscCall(SNESGetLineSearch(snes, &search));
  PetscCall(SNESLineSearchSetType(search, SNESLINESEARCHSHELL));
  PetscCall(set_line_search(search, guarded_full_step, nullptr));
  PetscFunctionReturn(0);
}

}  // namespace scree
