/// The tangent of S/gamma for Newton's method where a bed hardly moves, after Rudi, Shih and Stadler (2020), "Advanced
/// Newton methods for geodynamical models of Stokes flow with viscoplastic rheologies", G-cubed 21, e2020GC009059.
///
/// Friction is mu_f S ~ S/gamma, gamma^2 = S:S + c T/d^2 + eps^2. Its derivative dS/gamma - S (S:dS)/gamma^3 is nearly
/// singular along S where gamma is small, and far from the solution its second term sends Newton's method astray.
/// The stress-velocity form has a tensor Pi, |Pi| <= 1, in the place of one S/gamma: dS/gamma - S (Pi:dS)/gamma^2. Pi
/// follows from gamma Pi = S linearised about the iterate before, so that both agree at the solution. It is no unknown,
/// and solutions are those of the exact tangent.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "scree/math/sparse_dual.hpp"

namespace scree {

enum class TangentKind { exact, stress_velocity };

/// A strain rate by components with weights, such that S:S' = sum_k weight_k S_k S'_k: of the deviator, where div v is
/// one of them with the weight -1/3. At most `capacity` components of at most `most_terms` derivatives together.
template <class Number, std::size_t capacity, std::size_t most_terms>
struct StrainComponents {
  std::array<double, capacity> value;  ///< the first `size` [1/s]
  std::array<double, capacity> weight;
  std::size_t size = 0;

  void add(double component, double its_weight) {
    value[size] = component;
    weight[size++] = its_weight;
    square_ += its_weight * (component * component);
  }
  template <int n, int k>
  [[gnu::always_inline]] void add(const SparseDual<n, k>& component, double its_weight) {
    for (int i = 0; i < k; ++i) terms_[term_count_++] = {size, component.at[i], component.slope[i]};
    add(component.value, its_weight);
  }

  /// S:S without derivatives [1/s2].
  double square_value() const { return square_; }
  /// S:S [1/s2].
  Number square() const {
    if constexpr (IsDual<Number>::value)
      return square_along(2, value.data());
    else
      return square_;
  }
  /// S:S with factor Pi:dS for its derivative.
  Number square_along(double factor, const double* Pi) const {
    Number result(square_);
    for (std::size_t i = 0; i < term_count_; ++i) {
      const std::size_t k = terms_[i].component;
      result.derivative[terms_[i].at] += factor * weight[k] * Pi[k] * terms_[i].slope;
    }
    return result;
  }

 private:
  struct Term {
    std::size_t component;
    int at;
    double slope;
  };
  double square_ = 0;
  std::array<Term, IsDual<Number>::value ? most_terms : 0> terms_;
  std::size_t term_count_ = 0;
};

/// Pi at the places of one kind: cells, or edges along one axis.
class StressDirections {
 public:
  /// For `places` places of at most `components` components.
  void resize(std::size_t places, std::size_t components) {
    components_ = components;
    values_.assign(2 * components * places, 0);
    gamma_.assign(places, 0);
    made_.assign(places, -1);
  }
  /// Newton's method begins anew, with Pi = first S/gamma: the exact tangent where `first` is 1.
  void restart(double first) {
    first_ = first;
    std::fill(made_.begin(), made_.end(), -1);
  }
  /// The tangents asked from now on belong to another iterate.
  void next() { ++iterate_; }

  /// The square of S with the derivative 2 gamma Pi:dS. `gamma` [1/s] may leave out a T that is no unknown.
  template <class Number, std::size_t capacity, std::size_t most_terms>
  Number square(std::size_t place, const StrainComponents<Number, capacity, most_terms>& S, double gamma) {
    if (!(gamma > 0)) return S.square();  // nothing moves and nothing floors it: the exact derivative is 0 too
    if (made_[place] != iterate_) update(place, S, gamma);
    return S.square_along(2 * gamma_[place], &values_[2 * components_ * place]);
  }

 private:
  template <class Strain>
  void update(std::size_t place, const Strain& S, double gamma) {
    double *Pi = &values_[2 * components_ * place], *old = Pi + components_;
    const bool first = made_[place] < 0;
    const double before = gamma_[place];
    double change = 0, norm = 0;
    for (std::size_t k = 0; k < S.size && !first; ++k) change += S.weight[k] * old[k] * (S.value[k] - old[k]);
    for (std::size_t k = 0; k < S.size; ++k) {
      Pi[k] = first ? first_ * S.value[k] / gamma : (S.value[k] - Pi[k] * change / before) / before;
      norm += S.weight[k] * Pi[k] * Pi[k];
      old[k] = S.value[k];
    }
    if (!first && norm > 1)
      for (std::size_t k = 0; k < S.size; ++k) Pi[k] /= std::sqrt(norm);
    gamma_[place] = gamma;
    made_[place] = iterate_;
  }

  std::size_t components_ = 0;
  double first_ = 1;
  int iterate_ = 0;
  std::vector<double> values_;  ///< Pi and the S of the iterate before, place by place
  std::vector<double> gamma_;   ///< of the iterate before [1/s]
  std::vector<int> made_;       ///< iterate that Pi belongs to, -1 for none
};

/// Pi of all cells and edges of a rank, by the ghosted index of their anchor.
struct NewtonTangent {
  StressDirections cells;
  std::array<StressDirections, 3> edges;  ///< by the axis along them

  /// `fluctuation` is c: without T/d^2 gamma has a sharp bend at S = 0, and half of the second term leads farther than
  /// all of it at an iterate that may be far off.
  NewtonTangent(std::size_t places, int dim, double fluctuation) : first_(0.5 * (1 + fluctuation)) {
    const auto n = static_cast<std::size_t>(dim);
    cells.resize(places, n + 1 + 2 * n * (n - 1));  // D_aa, div v and the four edges of each pair of axes
    for (int axis = 0; axis < 3; ++axis)
      if (dim > 2 || (dim == 2 && axis == 2)) edges[axis].resize(places, n + 2 + (dim > 2 ? 8 : 0));
    restart();
  }
  void restart() {
    cells.restart(first_);
    for (auto& kind : edges) kind.restart(first_);
  }
  void next() {
    cells.next();
    for (auto& kind : edges) kind.next();
  }

 private:
  double first_;
};

}  // namespace scree
