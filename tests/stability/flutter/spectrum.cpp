/// H8: eigenvalues of the whole discrete problem, linearised about the state of a checkpoint: the waves that grow or
/// decay about a real, nonuniform flow with its walls. dF/dU x = -lambda dF/d(dU/dt) x.
///
///     flutter_spectrum DIRECTORY [-options of the case]
///
/// Prints for each shift sigma the eigenvalues nearest to it with a positive real part, or the rightmost, and how far
/// the search went: within that distance from sigma there is no other.
#include <slepceps.h>

#include <algorithm>
#include <cstdio>

#include "../../support/sample_problem.hpp"
#include "scree/app/petsc_session.hpp"
#include "scree/app/problem_setup.hpp"
#include "scree/config/command_line.hpp"
#include "scree/config/read_case.hpp"
#include "scree/output/checkpoint.hpp"

namespace scree::test {
namespace {

/// As the program sets it up; friction is coupled, however the run had it.
ProblemSetup setup_of(Case scene) {
  scene.friction.lagged = false;
  return problem_setup(scene);
}

/// -dF/dU and dF/d(dU/dt) at a state.
class Linearised {
 public:
  Linearised(Evaluation& problem, const Values& state) {
    problem.assemble(state, problem.zeros(), 1);
    check(MatDuplicate(problem.problem().matrix(), MAT_COPY_VALUES, &rate));
    problem.assemble(state, problem.zeros(), 0);
    check(MatDuplicate(problem.problem().matrix(), MAT_COPY_VALUES, &minus_state));
    check(MatScale(minus_state, -1));
    check(MatAXPY(rate, 1, minus_state, SAME_NONZERO_PATTERN));
  }
  ~Linearised() {
    (void)MatDestroy(&rate);
    (void)MatDestroy(&minus_state);
  }
  Linearised(const Linearised&) = delete;
  Linearised& operator=(const Linearised&) = delete;
  Mat rate = nullptr, minus_state = nullptr;
};

/// Share of the shortest waves in a field along one axis: sum (x- - 2x + x+)^2 / (16 sum x^2), 1 where neighbours
/// alternate.
double grid_share(const Evaluation& problem, const Values& x, int component, int axis) {
  double rough = 0, all = 0;
  Index first{0, 0, 0}, count = problem.nodes();
  first[axis] += 1;
  count[axis] -= 2;
  for_each_node(first, count, [&](const Index& I) {
    const auto at = [&](int shift) {
      Index J = I;
      J[axis] += shift;
      return x[static_cast<std::size_t>(problem.at(component, J))];
    };
    const double second = at(-1) - 2 * at(0) + at(1);
    rough += second * second;
    all += at(0) * at(0);
  });
  return all > 0 ? rough / (16 * all) : 0;
}

/// Height of the greatest value of a component [m].
double height_of_greatest(Evaluation& problem, const Values& x, int component) {
  double greatest = -1, height = 0;
  for_each_node(Index{}, problem.nodes(), [&](const Index& I) {
    const double value = std::abs(x[static_cast<std::size_t>(problem.at(component, I))]);
    if (value <= greatest) return;
    greatest = value;
    height = problem.problem().box().faces[1][static_cast<std::size_t>(I[1])];
  });
  return height;
}

class Spectrum {
 public:
  Spectrum(Evaluation& problem, const Values& state) : problem_(problem), matrices_(problem, state) {
    check(EPSCreate(PETSC_COMM_SELF, &eps_));
    check(EPSSetOperators(eps_, matrices_.minus_state, matrices_.rate));
    check(EPSSetProblemType(eps_, EPS_GNHEP));
    check(EPSSetWhichEigenpairs(eps_, EPS_TARGET_MAGNITUDE));
    check(EPSSetDimensions(eps_, wanted, PETSC_DETERMINE, PETSC_DETERMINE));
    ST st;
    KSP ksp;
    PC pc;
    check(EPSGetST(eps_, &st));
    check(STSetType(st, STSINVERT));
    check(STSetMatStructure(st, SAME_NONZERO_PATTERN));
    check(STGetKSP(st, &ksp));
    check(KSPSetType(ksp, KSPPREONLY));
    check(KSPGetPC(ksp, &pc));
    check(PCSetType(pc, PCLU));
    check(PCFactorSetMatSolverType(pc, MATSOLVERMUMPS));
    check(EPSSetFromOptions(eps_));
  }
  ~Spectrum() { (void)EPSDestroy(&eps_); }
  Spectrum(const Spectrum&) = delete;
  Spectrum& operator=(const Spectrum&) = delete;

  void print_near(double sigma) {
    check(EPSSetTarget(eps_, sigma));
    check(EPSSolve(eps_));
    PetscInt found;
    check(EPSGetConverged(eps_, &found));
    std::vector<std::pair<Complex, PetscInt>> values;
    double reach = 0, worst = 0;
    for (PetscInt k = 0; k < found; ++k) {
      double re, im, error;
      check(EPSGetEigenvalue(eps_, k, &re, &im));
      check(EPSComputeError(eps_, k, EPS_ERROR_BACKWARD, &error));
      worst = std::max(worst, error);
      values.push_back({Complex(re, im), k});
      reach = std::max(reach, std::abs(Complex(re, im) - sigma));
    }
    std::sort(values.begin(), values.end(),
              [](const auto& a, const auto& b) { return a.first.real() > b.first.real(); });
    std::printf("sigma %g: %d found, all within %.6g, backward error %.1e\n", sigma, static_cast<int>(found), reach,
                worst);
    for (std::size_t k = 0; k < values.size(); ++k)
      if (k < 3 || values[k].first.real() > 0) print(values[k].first, values[k].second);
  }

 private:
  using Complex = std::complex<double>;
  static constexpr int wanted = 12;

  void print(const Complex& value, PetscInt number) {
    Vec real, imaginary;
    check(MatCreateVecs(matrices_.rate, &real, &imaginary));
    check(EPSGetEigenvector(eps_, number, real, imaginary));
    const Values x = problem_.get(real);
    std::printf("  lambda %12.5g %+12.5gi", value.real(), value.imag());
    for (const char* symbol : {"nu", "v", "T"}) {
      const int c = problem_.component(symbol);
      std::printf("  %s: grid-scale %.4f across, %.4f along, greatest at y %.3f m", symbol,
                  grid_share(problem_, x, c, 0), grid_share(problem_, x, c, 1), height_of_greatest(problem_, x, c));
    }
    std::printf("\n");
    check(VecDestroy(&real));
    check(VecDestroy(&imaginary));
  }

  Evaluation& problem_;
  Linearised matrices_;
  EPS eps_ = nullptr;
};

void analyse(const std::string& directory, const Case& scene) {
  Evaluation problem(PETSC_COMM_SELF, setup_of(scene));
  const Checkpoint saved = read_checkpoint(directory, scene.box, problem.problem().dm(), problem.fields());
  std::printf("%s, t = %g s, %d unknowns\n", saved.file.c_str(), saved.scalar("time"), problem.size());
  Spectrum spectrum(problem, problem.get(saved.vector("state")));
  for (const double sigma : {10., 100., 1e3, 1e4}) spectrum.print_near(sigma);
}

}  // namespace
}  // namespace scree::test

int main(int argc, char** argv) {
  if (argc < 2) return 1;
  MPI_Init(&argc, &argv);
  try {
    const std::string directory = argv[1];
    scree::CommandLine line = scree::read_command_line({argv + 2, argv + argc});
    line.case_file = directory + "/case.yaml";
    const scree::Case scene = scree::read_case(scree::case_input(line));
    const scree::PetscSession petsc(argv[0], scene.petsc_options);
    scree::test::check(SlepcInitialize(nullptr, nullptr, nullptr, nullptr));
    scree::test::analyse(directory, scene);
    scree::test::check(SlepcFinalize());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "flutter_spectrum: %s\n", error.what());
    return 1;
  }
  return MPI_Finalize();
}
