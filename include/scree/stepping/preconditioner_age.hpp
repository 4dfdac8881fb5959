/// When a preconditioner has served long enough: numbers only.
#pragma once

namespace scree {

/// A preconditioner is made at the first Newton iteration of a step and serves to its end, unless a linear system takes
/// many more Krylov iterations than the first one with it: where an iterate moves far, in the start of fine particles
/// in air, they would grow until the solver fails. One kept from step to step costs more iterations than it saves.
class PreconditionerAge {
 public:
  /// Aged at more iterations than this factor times those of the first system, and so many: about what a set-up costs.
  static constexpr int factor = 2, more = 10;

  void renewed() { fresh_ = none; }
  /// It has not solved a system.
  bool is_new() const { return fresh_ == none; }
  /// After a linear system of `krylov` iterations; true if the preconditioner has aged.
  bool has_aged(int krylov) {
    if (fresh_ != none) return krylov > factor * fresh_ + more;
    fresh_ = krylov;
    return false;
  }

 private:
  static constexpr int none = -1;
  int fresh_ = none;  ///< iterations of the first system that the preconditioner solved
};

}  // namespace scree
