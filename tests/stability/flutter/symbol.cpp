#include "symbol.hpp"

#include <petscblaslapack.h>

namespace scree::test {

namespace {

constexpr int cells = 15, middle = 7;

double base_value(const BaseState& base, double chi, const Field& field, const Index& I) {
  std::array<double, 2> x{};
  for (int a = 0; a < 2; ++a) x[a] = (I[a] - middle + (field.face_axis == a ? -0.5 : 0.0)) * base.cell[a];
  const double slope = 1 + base.slope * (x[0] / base.cell[0] + 0.7 * x[1] / base.cell[1]);
  if (field.symbol == "nu") return base.nu * slope;
  if (field.symbol == "T") return base.T * slope;
  if (field.symbol == "chi") return chi * slope;
  const auto& g = base.gradient[static_cast<std::size_t>(field.face_axis)];
  return base.velocity[field.face_axis] + g[0] * x[0] + g[1] * x[1];
}

Box box_of(const BaseState& base) {
  Box box;
  box.dim = 2;
  for (int a = 0; a < 2; ++a) box.faces[a] = uniform_faces(cells, base.cell[a]);
  return box;
}

}  // namespace

Symbol::Symbol(const ProblemSetup& parameters, const BaseState& base) {
  ProblemSetup setup = parameters;
  setup.box = box_of(base);
  setup.segments = all_sides(setup.box, condition(BoundaryKind::open));
  const double chi = steady_chi(base, setup.solids);
  Evaluation problem(PETSC_COMM_SELF, setup);
  unknowns_ = problem.unknowns();
  chi_ = problem.component("chi");
  const Values state =
      problem.values([&](const Field& field, const Index& I) { return base_value(base, chi, field, I); });
  state_ = rows(problem, state, 0);
  constexpr double shift = 1e30;  // next to it the state part is nothing, however small the cells
  rate_ = rows(problem, state, shift);
  for (auto& [place, value] : rate_) {
    const auto same = state_.find(place);
    if (same != state_.end()) value -= same->second;
    value /= shift;
  }
}

Symbol::Stencil Symbol::rows(Evaluation& problem, const Values& state, double shift) const {
  Stencil stencil;
  problem.assemble(state, problem.zeros(), shift);
  const int nodes = problem.nodes()[0];
  const auto node = [&](int natural) {
    const int n = natural / unknowns_;
    return std::array<int, 2>{n % nodes, n / nodes};
  };
  problem.each_entry([&](int row, int column, double value) {
    const auto at = node(row), from = node(column);
    if (at[0] != middle || at[1] != middle || value == 0) return;
    stencil[{row % unknowns_, column % unknowns_, from[0] - at[0], from[1] - at[1]}] += value;
  });
  return stencil;
}

Matrix Symbol::transformed(const Stencil& stencil, const std::array<double, 2>& kh) const {
  Matrix result(unknowns_);
  for (const auto& [place, value] : stencil)
    result(place[0], place[1]) += value * std::exp(Complex(0, kh[0] * place[2] + kh[1] * place[3]));
  return result;
}

namespace {

/// B^-1 A, by elimination with pivots.
Matrix quotient(Matrix B, Matrix A) {
  const int n = B.size;
  for (int k = 0; k < n; ++k) {
    int pivot = k;
    for (int i = k + 1; i < n; ++i)
      if (std::abs(B(i, k)) > std::abs(B(pivot, k))) pivot = i;
    for (int j = 0; j < n; ++j) {
      std::swap(B(k, j), B(pivot, j));
      std::swap(A(k, j), A(pivot, j));
    }
    for (int i = 0; i < n; ++i) {
      if (i == k) continue;
      const Complex factor = B(i, k) / B(k, k);
      for (int j = 0; j < n; ++j) {
        B(i, j) -= factor * B(k, j);
        A(i, j) -= factor * A(k, j);
      }
    }
  }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) A(i, j) /= B(i, i);
  return A;
}

}  // namespace

std::vector<Complex> eigenvalues(const Matrix& A, const Matrix& B) {
  const Matrix C = quotient(B, A);
  const int n = C.size, lead = 2 * n;
  // [Re -Im; Im Re]: each eigenvalue and its conjugate
  std::vector<double> system(static_cast<std::size_t>(lead * lead));
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      system[i + j * lead] = system[n + i + (n + j) * lead] = C(i, j).real();
      system[n + i + j * lead] = C(i, j).imag();
      system[i + (n + j) * lead] = -C(i, j).imag();
    }
  std::vector<double> real_parts(static_cast<std::size_t>(lead)), imaginary_parts(real_parts),
      work(8 * real_parts.size());
  const PetscBLASInt order = lead, one = 1, room = static_cast<PetscBLASInt>(work.size());
  PetscBLASInt failed = 0;
  double unused = 0;
  LAPACKgeev_("N", "N", &order, system.data(), &order, real_parts.data(), imaginary_parts.data(), &unused, &one,
              &unused, &one, work.data(), &room, &failed);
  if (failed) throw std::runtime_error("the eigenvalues of a symbol do not converge");
  std::vector<Complex> values;
  for (std::size_t k = 0; k < real_parts.size(); ++k) values.emplace_back(real_parts[k], imaginary_parts[k]);
  return values;
}

double steady_chi(const BaseState& base, const SolidsParameters& solids) {
  double chi = 1;
  const auto steady = [&](double at) {
    return cell_closure(base.nu, base.T, at, base.div_v(), base.S_S(), 0.0, solids)[CellClosure::chi_star];
  };
  for (int iteration = 0; iteration < 100; ++iteration) chi = steady(chi);
  return chi;
}

double steady_temperature(const BaseState& base, SolidsParameters solids) {
  solids.temperature = TemperatureModel::algebraic;
  return cell_closure(base.nu, base.T, 1.0, base.div_v(), base.S_S(), 0.0, solids)[CellClosure::temperature];
}

double growth_rate(const Symbol& symbol, const std::array<double, 2>& kh) {
  Matrix A = symbol.state_part(kh);
  for (Complex& entry : A.entry) entry = -entry;
  double greatest = -1e300;
  for (const Complex& lambda : eigenvalues(A, symbol.rate_part(kh))) greatest = std::max(greatest, lambda.real());
  return greatest;
}

}  // namespace scree::test
