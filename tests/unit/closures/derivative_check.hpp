/// Derivatives of a closure against fourth-order central differences, and a check that nothing is infinite.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <type_traits>

#include "scree/math/dual.hpp"

namespace scree::testing {

/// f takes std::array<Number, m> and returns std::array<Number, k>. `lengths` are the distances over which f changes:
/// the step is a thousandth of them, the tolerance 1e-8 of |f|/length.
template <std::size_t m, class Function>
void expect_derivatives_match(const Function& f, const std::array<double, m>& x, const std::array<double, m>& lengths,
                              const std::string& what, double tolerance = 1e-8) {
  using D = Dual<static_cast<int>(m)>;
  std::array<D, m> seeded;
  for (std::size_t i = 0; i < m; ++i) seeded[i] = D::variable(x[i], static_cast<int>(i));
  const auto dual = f(seeded);
  const auto plain = f(x);
  for (std::size_t i = 0; i < m; ++i) {
    const double h = 1e-3 * lengths[i];
    const auto at = [&](double steps) {
      std::array<double, m> moved = x;
      moved[i] += steps * h;
      return f(moved);
    };
    const auto lower2 = at(-2), lower = at(-1), upper = at(1), upper2 = at(2);
    for (std::size_t r = 0; r < plain.size(); ++r) {
      const double difference = (8 * (upper[r] - lower[r]) - (upper2[r] - lower2[r])) / (12 * h);
      const double scale = std::abs(plain[r]) / lengths[i] + std::abs(difference);
      EXPECT_NEAR(dual[r].derivative[i], difference, tolerance * scale)
          << what << ": result " << r << " by argument " << i;
    }
  }
  for (std::size_t r = 0; r < plain.size(); ++r)
    EXPECT_NEAR(dual[r].value, plain[r], 1e-13 * std::abs(plain[r])) << what << ": value of result " << r;
}

template <int n>
void expect_finite(const Dual<n>& y, const std::string& what) {
  EXPECT_TRUE(std::isfinite(y.value)) << what << " = " << y.value;
  for (int j = 0; j < n; ++j)
    EXPECT_TRUE(std::isfinite(y.derivative[static_cast<std::size_t>(j)])) << what << ": derivative " << j;
}

}  // namespace scree::testing
