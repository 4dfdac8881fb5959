/// What own types of preconditioners share: a class as a type of PETSc's, as PCSHELL, all of whose interface is public.
#pragma once

#include <petscpc.h>

namespace scree {

/// Which matrix, with which pattern, a preconditioner was made for.
class KnownPattern {
 public:
  /// *other: whether `matrix` is not the one of the last call, or has got another pattern.
  PetscErrorCode take(Mat matrix, bool* other) {
    PetscFunctionBeginUser;
    PetscObjectId id;
    PetscObjectState state;
    PetscCall(PetscObjectGetId(reinterpret_cast<PetscObject>(matrix), &id));
    PetscCall(MatGetNonzeroState(matrix, &state));
    *other = id != id_ || state != state_;
    id_ = id;
    state_ = state;
    PetscFunctionReturn(0);
  }

 private:
  PetscObjectId id_ = 0;  ///< no matrix has it
  PetscObjectState state_ = 0;
};

/// What PETSc calls for -pc_type Own::name. `Own` has a default constructor and
///   static constexpr const char* name
///   PetscErrorCode set_up(PC)                for the matrix of the PC, whose pattern may be another than before
///   PetscErrorCode apply(PC, Vec x, Vec y)
///   PetscErrorCode view(PetscViewer) const
template <class Own>
class ShellPreconditioner {
 public:
  static PetscErrorCode make(PC pc) {
    PetscFunctionBeginUser;
    PetscCall(PCSetType(pc, PCSHELL));
    PetscCall(PCShellSetName(pc, Own::name));
    PetscCall(PCShellSetContext(pc, new Own()));
    PetscCall(PCShellSetSetUp(pc, set_up));
    PetscCall(PCShellSetApply(pc, apply));
    PetscCall(PCShellSetView(pc, view));
    PetscCall(PCShellSetDestroy(pc, destroy));
    PetscFunctionReturn(0);
  }

 private:
  static PetscErrorCode own(PC pc, Own** found) {
    PetscFunctionBeginUser;
    PetscCall(PCShellGetContext(pc, found));
    PetscFunctionReturn(0);
  }
  static PetscErrorCode set_up(PC pc) {
    PetscFunctionBeginUser;
    Own* self;
    PetscCall(own(pc, &self));
    PetscCall(self->set_up(pc));
    PetscFunctionReturn(0);
  }
  static PetscErrorCode apply(PC pc, Vec x, Vec y) {
    PetscFunctionBeginUser;
    Own* self;
    PetscCall(own(pc, &self));
    PetscCall(self->apply(pc, x, y));
    PetscFunctionReturn(0);
  }
  static PetscErrorCode view(PC pc, PetscViewer viewer) {
    PetscFunctionBeginUser;
    Own* self;
    PetscCall(own(pc, &self));
    PetscCall(self->view(viewer));
    PetscFunctionReturn(0);
  }
  static PetscErrorCode destroy(PC pc) {
    PetscFunctionBeginUser;
    Own* self;
    PetscCall(own(pc, &self));
    delete self;
    PetscFunctionReturn(0);
  }
};

}  // namespace scree
