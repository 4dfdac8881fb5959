/// The discrete operator about a base state with uniform gradients, as a small matrix for each wave vector: the rows of
/// one node inside, unknowns beyond it being those of the node times the phase of the wave.
#pragma once

#include <petscmat.h>

#include <complex>
#include <map>
#include <vector>

#include "../../support/sample_problem.hpp"

namespace scree::test {

/// A state with uniform velocity gradient, 2-D, SI.
struct BaseState {
  std::string name;
  double nu, T;
  std::array<double, 2> velocity;                 ///< at the node whose rows are taken
  std::array<std::array<double, 2>, 2> gradient;  ///< dv_i/dx_j [1/s]
  std::array<double, 2> cell;                     ///< sizes [m]
  /// Relative slope of nu, T and chi a cell, so that limiters see the smooth side; too small for anything else.
  double slope = 1e-7;

  double div_v() const { return gradient[0][0] + gradient[1][1]; }
  /// Of the three-dimensional deviator.
  double S_S() const {
    const double D_xy = 0.5 * (gradient[0][1] + gradient[1][0]), div = div_v();
    return gradient[0][0] * gradient[0][0] + gradient[1][1] * gradient[1][1] + 2 * D_xy * D_xy - div * div / 3;
  }
};

using Complex = std::complex<double>;

/// A dense complex matrix, small.
struct Matrix {
  int size;
  std::vector<Complex> entry;
  explicit Matrix(int n) : size(n), entry(static_cast<std::size_t>(n * n)) {}
  Complex& operator()(int i, int j) { return entry[static_cast<std::size_t>(i * size + j)]; }
  Complex operator()(int i, int j) const { return entry[static_cast<std::size_t>(i * size + j)]; }
};

/// dF/dU and dF/d(dU/dt) of one node.
class Symbol {
 public:
  Symbol(const ProblemSetup& parameters, const BaseState& base);
  int size() const { return unknowns_; }
  int chi() const { return chi_; }  ///< component of chi; -1 if it is none
  /// Of a wave exp(i k.x); `k` times the sizes of a cell.
  Matrix state_part(const std::array<double, 2>& kh) const { return transformed(state_, kh); }
  Matrix rate_part(const std::array<double, 2>& kh) const { return transformed(rate_, kh); }

 private:
  using Stencil = std::map<std::array<int, 4>, double>;  ///< row, column, offsets of the node
  Matrix transformed(const Stencil& stencil, const std::array<double, 2>& kh) const;
  Stencil rows(Evaluation& problem, const Values& state, double shift) const;

  int unknowns_ = 0, chi_ = -1;
  Stencil state_, rate_;
};

/// Eigenvalues of A x = lambda B x, B not singular; each comes with its conjugate.
std::vector<Complex> eigenvalues(const Matrix& A, const Matrix& B);

/// chi that stays about the base state: chi* where M(I) makes it depend on chi itself, by iteration.
double steady_chi(const BaseState& base, const SolidsParameters& solids);
/// T of the base state's strain rate by production = dissipation; its own T is not read [m2/s2].
double steady_temperature(const BaseState& base, SolidsParameters solids);

/// Growth rate of the fastest growing wave of this phase, continuous in time [1/s].
double growth_rate(const Symbol& symbol, const std::array<double, 2>& kh);

}  // namespace scree::test
