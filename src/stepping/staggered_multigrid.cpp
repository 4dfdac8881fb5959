#include "scree/stepping/staggered_multigrid.hpp"

#include <petscksp.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "scree/stepping/grid_of_nodes.hpp"
#include "scree/stepping/shell_preconditioner.hpp"
#include "scree/stepping/staggered_interpolation.hpp"

namespace scree {

namespace {

/// A grid, the finest first, with its matrix and the interpolation from it to the next finer one.
struct Level {
  DM dm = nullptr;
  Mat matrix = nullptr, interpolation = nullptr;
};

/// How wide cells may become from grid to grid. The bound doubles, whatever the axis: cells that are flat, in places
/// where one axis is graded and another is not, are first made wider across.
class CellWidths {
 public:
  explicit CellWidths(DM finest) {
    const NodeGrid grid(finest);
    double narrowest = std::numeric_limits<double>::max();
    for (int axis = 0; axis < grid.dim; ++axis)
      for (std::size_t i = 1; i < grid.faces[axis].size(); ++i)
        narrowest = std::min(narrowest, grid.faces[axis][i] - grid.faces[axis][i - 1]);
    bound_ = pair * narrowest;
  }

  /// The axes of the next grid; nothing where no axis can have wider cells.
  std::optional<std::array<CoarseAxis, max_dim>> next(DM dm) {
    const NodeGrid fine(dm);
    double longest = 0;
    for (int axis = 0; axis < fine.dim; ++axis)
      longest = std::max(longest, fine.faces[axis].back() - fine.faces[axis].front());
    while (bound_ <= 2 * pair * longest) {
      auto axes = coarsened(fine, bound_);
      bound_ *= 2;
      for (int axis = 0; axis < fine.dim; ++axis)
        if (axes[axis].cells() < fine.cells(axis)) return axes;
    }
    return {};
  }

 private:
  static constexpr double pair = 2.5;  ///< two cells of a graded axis, relative to the narrower one
  double bound_;
};

class StaggeredMultigrid {
 public:
  static constexpr const char* name = "staggered";

  StaggeredMultigrid() = default;
  ~StaggeredMultigrid() { PetscCallAbort(PETSC_COMM_SELF, clear()); }
  StaggeredMultigrid(const StaggeredMultigrid&) = delete;
  StaggeredMultigrid& operator=(const StaggeredMultigrid&) = delete;

  PetscErrorCode set_up(PC pc) {
    PetscFunctionBeginUser;
    Mat matrix;
    bool other = true;
    PetscCall(PCGetOperators(pc, nullptr, &matrix));
    PetscCall(pattern_.take(matrix, &other));
    if (other)
      PetscCall(create(pc, matrix));
    else
      for (std::size_t k = 1; k < levels_.size(); ++k)
        PetscCall(MatPtAP(levels_[k - 1].matrix, levels_[k].interpolation, MAT_REUSE_MATRIX, PETSC_DEFAULT,
                          &levels_[k].matrix));
    PetscCall(PCSetUp(cycle_));
    PetscFunctionReturn(0);
  }

  PetscErrorCode apply(PC pc, Vec x, Vec y) {
    PetscFunctionBeginUser;
    PCFailedReason reason;
    PetscCall(PCApply(cycle_, x, y));
    PetscCall(PCGetFailedReason(cycle_, &reason));
    if (reason) PetscCall(PCSetFailedReason(pc, reason));
    PetscFunctionReturn(0);
  }

  PetscErrorCode view(PetscViewer viewer) const {
    PetscFunctionBeginUser;
    if (cycle_) PetscCall(PCView(cycle_, viewer));
    PetscFunctionReturn(0);
  }

 private:
  PetscErrorCode clear() {
    PetscFunctionBeginUser;
    PetscCall(PCDestroy(&cycle_));
    for (std::size_t k = 0; k < levels_.size(); ++k) {
      if (k > 0) PetscCall(MatDestroy(&levels_[k].matrix));
      if (k > 0) PetscCall(DMDestroy(&levels_[k].dm));
      PetscCall(MatDestroy(&levels_[k].interpolation));
    }
    levels_.clear();
    PetscFunctionReturn(0);
  }

  PetscErrorCode create(PC pc, Mat matrix) {
    PetscFunctionBeginUser;
    DM dm;
    const char* prefix;
    PetscCall(clear());
    PetscCall(get_grid_of_nodes(matrix, &dm));
    if (!dm) PetscCall(PCGetDM(pc, &dm));
    PetscCall(PCGetOptionsPrefix(pc, &prefix));
    PetscCheck(dm, PetscObjectComm(reinterpret_cast<PetscObject>(pc)), PETSC_ERR_ORDER,
               "-pc_type staggered needs the DMDA of the grid");
    levels_.push_back({dm, matrix, nullptr});
    PetscCall(create_coarse_levels(prefix));
    PetscCall(create_cycle(pc, prefix));
    PetscFunctionReturn(0);
  }

  PetscErrorCode create_coarse_levels(const char* prefix) {
    PetscFunctionBeginUser;
    PetscInt unknowns, count, limit = 5000;
    const Mat finest = levels_.front().matrix;
    PetscCall(MatGetBlockSize(finest, &unknowns));
    count = unknowns;
    std::vector<PetscInt> axes(static_cast<std::size_t>(unknowns), -1);
    std::vector<char> fixed;
    PetscCall(PetscOptionsGetIntArray(nullptr, prefix, "-pc_staggered_axes", axes.data(), &count, nullptr));
    PetscCall(PetscOptionsGetInt(nullptr, prefix, "-pc_staggered_coarse_eq_limit", &limit, nullptr));
    PetscCall(find_fixed(finest, fixed));
    for (CellWidths widths(levels_.front().dm);;) {
      PetscInt size;
      Level coarse;
      const Level fine = levels_.back();
      PetscCall(MatGetSize(fine.matrix, &size, nullptr));
      if (size <= limit) break;
      const auto wider = widths.next(fine.dm);
      if (!wider) break;
      PetscCall(create_coarse_dm(fine.dm, *wider, unknowns, &coarse.dm));
      PetscCall(create_interpolation(fine.dm, coarse.dm, *wider, axes, fixed, &coarse.interpolation));
      PetscCall(MatPtAP(fine.matrix, coarse.interpolation, MAT_INITIAL_MATRIX, PETSC_DEFAULT, &coarse.matrix));
      PetscCall(MatSetBlockSize(coarse.matrix, unknowns));
      levels_.push_back(coarse);
    }
    PetscFunctionReturn(0);
  }

  /// Rows that have but their diagonal.
  static PetscErrorCode find_fixed(Mat matrix, std::vector<char>& fixed) {
    PetscFunctionBeginUser;
    PetscInt first, end;
    PetscCall(MatGetOwnershipRange(matrix, &first, &end));
    for (PetscInt row = first; row < end; ++row) {
      PetscInt count;
      PetscCall(MatGetRow(matrix, row, &count, nullptr, nullptr));
      fixed.push_back(count == 1);
      PetscCall(MatRestoreRow(matrix, row, &count, nullptr, nullptr));
    }
    PetscFunctionReturn(0);
  }

  PetscErrorCode create_cycle(PC pc, const char* prefix) {
    PetscFunctionBeginUser;
    const auto count = static_cast<PetscInt>(levels_.size());
    PetscCall(PCCreate(PetscObjectComm(reinterpret_cast<PetscObject>(pc)), &cycle_));
    PetscCall(
        PetscObjectIncrementTabLevel(reinterpret_cast<PetscObject>(cycle_), reinterpret_cast<PetscObject>(pc), 1));
    PetscCall(PCSetOptionsPrefix(cycle_, prefix));
    PetscCall(PCAppendOptionsPrefix(cycle_, "staggered_"));
    PetscCall(PCSetOperators(cycle_, levels_.front().matrix, levels_.front().matrix));
    PetscCall(PCSetType(cycle_, PCMG));
    PetscCall(PCMGSetLevels(cycle_, count, nullptr));
    PetscCall(PCMGSetGalerkin(cycle_, PC_MG_GALERKIN_NONE));
    for (PetscInt level = 0; level < count; ++level) {
      KSP smoother;
      const Level& at = levels_[static_cast<std::size_t>(count - 1 - level)];
      PetscCall(PCMGGetSmoother(cycle_, level, &smoother));
      PetscCall(KSPSetOperators(smoother, at.matrix, at.matrix));
      if (at.interpolation) PetscCall(PCMGSetInterpolation(cycle_, level + 1, at.interpolation));
    }
    PetscCall(PCSetFromOptions(cycle_));
    PetscFunctionReturn(0);
  }

  std::vector<Level> levels_;
  KnownPattern pattern_;  ///< that the levels have
  PC cycle_ = nullptr;
};

}  // namespace

PetscErrorCode register_staggered_multigrid() {
  PetscFunctionBeginUser;
  PetscCall(PCRegister(StaggeredMultigrid::name, ShellPreconditioner<StaggeredMultigrid>::make));
  PetscFunctionReturn(0);
}

}  // namespace scree
