/// Regularisation of voids: without particles (3), (9) and (23) say nothing.
#pragma once

#include "scree/math/dual.hpp"

namespace scree {

/// What is added to nu in inertia and storage: eps at nu = 0, fading as eps/(1 + (nu/(10 eps))^4), so that it is
/// 1e-13 of nu at nu = 0.02 for the default eps of 1e-5. Below zero, where rounding may carry nu, their sum stays eps.
template <class Number>
Number void_floor(const Number& nu, double eps) {
  if (nu < 0.0) return eps - nu;
  if (eps == 0) return Number(0.0);
  if (nu > 2e4 * eps) return Number(0.0);  // to rounding, beside nu
  const Number x = nu / (10 * eps), square = x * x;
  return eps / (1.0 + square * square);
}

}  // namespace scree
