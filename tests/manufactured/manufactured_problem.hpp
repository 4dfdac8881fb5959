/// A discrete problem whose solution is known: sources at all balances, exact values in a band along the sides that are
/// not under test.
#pragma once

#include <algorithm>
#include <limits>
#include <map>

#include "../support/sample_problem.hpp"
#include "scree/stepping/petsc_versions.hpp"
#include "sources.hpp"

namespace scree::test {

/// Error of an unknown over the nodes where it is solved for, SI.
struct FieldError {
  double squares = 0, greatest = 0;
  long count = 0;
  double mean() const { return std::sqrt(squares / static_cast<double>(std::max(count, 1L))); }
};

class ManufacturedProblem {
 public:
  /// `band`: cells along each side that hold exact values, at least the 3 that stencils reach.
  ManufacturedProblem(const ProblemSetup& setup, const ExactFields& exact, int band)
      : exact_(exact), band_(band), problem_(setup) {
    check(problem_.create(PETSC_COMM_WORLD, 0));
    check(DMCreateGlobalVector(problem_.dm(), &solution_));
    for (Vec* vector : {&exact_values_, &source_, &residual_, &rate_}) check(VecDuplicate(solution_, vector));
    fill();
  }
  ~ManufacturedProblem() {
    for (Vec* vector : {&solution_, &exact_values_, &source_, &residual_, &rate_, &update_}) (void)VecDestroy(vector);
    (void)KSPDestroy(&ksp_);
    (void)MatDestroy(&matrix_);
    (void)ISDestroy(&free_);
  }
  ManufacturedProblem(const ManufacturedProblem&) = delete;
  ManufacturedProblem& operator=(const ManufacturedProblem&) = delete;

  /// A step of backward Euler from the exact fields, by Newton's method until it moves nothing that an order would
  /// show. Returns the last update, relative to the scales of the unknowns. A step, and not the steady state: that
  /// would suffer from solids fractions held where the flow leaves. The exact fields are so near that one Jacobian will
  /// mostly do.
  double solve() {
    check(VecCopy(exact_values_, solution_));
    double update = 1, before = 0;
    for (int iteration = 0; iteration < 12 && update > 1e-9; ++iteration) {
      const bool renew = iteration == 0 || update > 1e-2 * before;
      before = iteration == 0 ? std::numeric_limits<double>::infinity() : update;
      update = newton(renew);
    }
    return update;
  }

  /// Errors by the symbol of the unknown.
  std::map<std::string, FieldError> errors() const {
    std::map<std::string, FieldError> result;
    const double *x, *exact;
    check(VecGetArrayRead(solution_, &x));
    check(VecGetArrayRead(exact_values_, &exact));
    each_unknown([&](const Field& field, const Index& I, int owned) {
      if (is_held(field, I)) return;
      FieldError& error = result[field.symbol];
      const double difference = std::abs(x[owned] - exact[owned]) * field.scale;
      error.squares += difference * difference;
      error.greatest = std::max(error.greatest, difference);
      ++error.count;
    });
    check(VecRestoreArrayRead(exact_values_, &exact));
    check(VecRestoreArrayRead(solution_, &x));
    for (auto& [symbol, error] : result) {
      MPI_Allreduce(MPI_IN_PLACE, &error.squares, 1, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
      MPI_Allreduce(MPI_IN_PLACE, &error.greatest, 1, MPI_DOUBLE, MPI_MAX, PETSC_COMM_WORLD);
      MPI_Allreduce(MPI_IN_PLACE, &error.count, 1, MPI_LONG, MPI_SUM, PETSC_COMM_WORLD);
    }
    return result;
  }

  static constexpr double step = 2e-3;  ///< a fifth of the time in which the flow crosses the box [s]

 private:
  const Lattice& grid() const { return problem_.lattice(); }
  const Model& model() const { return problem_.model(); }
  int dim() const { return grid().dim; }

  template <class Work>
  void each_unknown(Work&& work) const {
    for_each_node(grid().owned_first, grid().owned_count, [&](const Index& I) {
      for (const Field& field : model().fields()) {
        const bool exists = field.face_axis < 0 ? grid().inside(I) : grid().is_face(field.face_axis, I);
        if (exists) work(field, I, grid().owned(I) * model().unknowns() + field.component);
      }
    });
  }

  std::array<double, max_dim> place(const Field& field, const Index& I) const {
    std::array<double, max_dim> x{};
    for (int a = 0; a < dim(); ++a)
      x[a] = field.face_axis == a ? grid().axes[a].face(I[a]) : grid().axes[a].centre(I[a]);
    return x;
  }

  /// Whether an unknown lies in the band of exact values.
  bool is_held(const Field& field, const Index& I) const {
    for (int a = 0; a < dim(); ++a) {
      const int last = grid().axes[a].cells() - (field.face_axis == a ? 0 : 1);
      const bool tested = exact_.tests_side && a == 1;
      if (I[a] > last - band_ || (!tested && I[a] < band_)) return true;
    }
    return false;
  }

  double row_scale(const Field& field) const {
    const Scales& s = problem_.setup().scales;
    const double rho_s = problem_.setup().solids.kinetic.rho_s, V = s.velocity;
    if (field.symbol == "v") return s.time / (rho_s * V);
    if (field.symbol == "u") return s.time / (s.density * V);
    if (field.symbol == "T") return s.time / (rho_s * V * V);
    return s.time;
  }

  static double value_of(const Sources& s, const Field& field) {
    const int a = std::max(field.face_axis, 0);
    if (field.symbol == "nu") return s.nu;
    if (field.symbol == "v") return s.v[a];
    if (field.symbol == "u") return s.u[a];
    if (field.symbol == "p_g") return s.p;
    return field.symbol == "T" ? s.T : s.chi;
  }

  void fill() {
    double *exact, *source;
    check(VecZeroEntries(exact_values_));
    check(VecZeroEntries(source_));
    check(VecGetArray(exact_values_, &exact));
    check(VecGetArray(source_, &source));
    PetscInt first;
    check(VecGetOwnershipRange(solution_, &first, nullptr));
    std::vector<PetscInt> free;
    each_unknown([&](const Field& field, const Index& I, int owned) {
      const Point q = exact_.at(place(field, I), 0);
      exact[owned] = q.value(field.symbol, field.face_axis) / field.scale;
      if (is_held(field, I)) return;
      free.push_back(first + owned);
      if (model().is_balance(field.component, I)) {
        const StrongForm form(q, dim(), problem_.setup().model, problem_.setup().solids);
        double value = value_of(form.sources(), field);
        if (field.symbol == "v" && field.face_axis == 1 && I[1] == 0)  // of a side, only an open one has a balance
          value += form.on_open_side(1, -1, grid().control_length(1, I));
        source[owned] = row_scale(field) * value;
      }
    });
    check(VecRestoreArray(source_, &source));
    check(VecRestoreArray(exact_values_, &exact));
    // What ILU needs in three dimensions, see columns_x in stepping/orderings.hpp.
    const int unknowns = model().unknowns();
    if (dim() == 3)
      std::stable_sort(free.begin(), free.end(), [&](PetscInt a, PetscInt b) { return a / unknowns > b / unknowns; });
    check(
        ISCreateGeneral(PETSC_COMM_WORLD, static_cast<PetscInt>(free.size()), free.data(), PETSC_COPY_VALUES, &free_));
  }

  double newton(bool renew) {
    check(VecWAXPY(rate_, -1, exact_values_, solution_));
    check(VecScale(rate_, 1 / step));
    check(problem_.residual(0, solution_, rate_, residual_));
    check(VecAXPY(residual_, -1, source_));
    if (renew) {
      check(problem_.jacobian(0, solution_, rate_, 1 / step, problem_.matrix()));
      check(MatCreateSubMatrix(problem_.matrix(), free_, free_, matrix_ ? MAT_REUSE_MATRIX : MAT_INITIAL_MATRIX,
                               &matrix_));
      set_up_solver();
    }
    Vec free_residual;
    check(VecGetSubVector(residual_, free_, &free_residual));
    if (!update_) check(VecDuplicate(free_residual, &update_));
    check(KSPSolve(ksp_, free_residual, update_));
    check(VecRestoreSubVector(residual_, free_, &free_residual));
    check(VecISAXPY(solution_, free_, -1, update_));
    double update;
    check(VecNorm(update_, NORM_INFINITY, &update));
    return update;
  }

  /// A factorisation; in three dimensions, where that is too large, GMRES down to rounding.
  void set_up_solver() {
    if (!ksp_) {
      PC pc;
      check(KSPCreate(PETSC_COMM_WORLD, &ksp_));
      check(KSPGetPC(ksp_, &pc));
      if (dim() < 3) {
        check(KSPSetType(ksp_, KSPPREONLY));
        check(PCSetType(pc, PCLU));
        check(PCFactorSetMatSolverType(pc, MATSOLVERMUMPS));
        check(PetscOptionsSetValue(nullptr, "-mat_mumps_icntl_14", "100"));  // room for pivots, per cent
      } else {
        check(PetscOptionsSetValue(nullptr, "-sub_pc_factor_levels", "1"));
        check(PetscOptionsSetValue(nullptr, "-sub_pc_factor_mat_ordering_type", "natural"));
        check(KSPSetType(ksp_, KSPGMRES));
        check(KSPGMRESSetRestart(ksp_, 200));
        check(KSPSetTolerances(ksp_, 1e-7, 1e-14, petsc_unchanged, 2000));
        check(PCSetType(pc, PCBJACOBI));
      }
      check(KSPSetErrorIfNotConverged(ksp_, PETSC_TRUE));
    }
    check(KSPSetOperators(ksp_, matrix_, matrix_));
  }

  ExactFields exact_;
  int band_;
  DiscreteProblem problem_;
  KSP ksp_ = nullptr;
  Vec solution_ = nullptr, exact_values_ = nullptr, source_ = nullptr, residual_ = nullptr, rate_ = nullptr;
  /// Of the system of Newton's method. The unknowns of the band start and stay at their exact values, so that it has
  /// those that are free alone.
  IS free_ = nullptr;
  Mat matrix_ = nullptr;
  Vec update_ = nullptr;
};

}  // namespace scree::test
