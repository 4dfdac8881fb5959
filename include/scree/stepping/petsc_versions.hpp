/// What PETSc calls otherwise from one version to another, from 3.18 on: what a part of Scree needs of it is here under
/// one name. Each version tells its changes on https://petsc.org/release/changes.
#pragma once

#include <petscsnes.h>

namespace scree {

#if PETSC_VERSION_GE(3, 22, 0)
inline constexpr int petsc_unchanged = PETSC_CURRENT;    ///< the tolerance that is there
inline constexpr int petsc_unlimited = PETSC_UNLIMITED;  ///< any number of failures
#else
inline constexpr int petsc_unchanged = PETSC_DEFAULT;
inline constexpr int petsc_unlimited = -1;
#endif

/// Makes `search` of type SNESLINESEARCHSHELL call `function` with `context`.
template <class Function>
PetscErrorCode set_line_search(SNESLineSearch search, Function* function, void* context) {
#if PETSC_VERSION_GE(3, 21, 0)
  return SNESLineSearchShellSetApply(search, function, context);
#else
  return SNESLineSearchShellSetUserFunc(search, function, context);
#endif
}

/// The operators of `ksp` are given to it; its DM does not make them.
inline PetscErrorCode take_no_operators_from_dm(KSP ksp) {
#if PETSC_VERSION_GE(3, 25, 0)
  return KSPSetDMActive(ksp, KSP_DMACTIVE_ALL, PETSC_FALSE);
#else
  return KSPSetDMActive(ksp, PETSC_FALSE);
#endif
}

}  // namespace scree
