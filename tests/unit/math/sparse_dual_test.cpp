#include "scree/math/sparse_dual.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "scree/math/through.hpp"

namespace scree {
namespace {

constexpr int n = 5;
using Dense = Dual<n>;
using Input = SparseDual<n, 1>;

void expect_equal(const Dense& got, const Dense& wanted, const std::string& what) {
  EXPECT_DOUBLE_EQ(got.value, wanted.value) << what;
  for (int k = 0; k < n; ++k) EXPECT_NEAR(got.derivative[k], wanted.derivative[k], 1e-14) << what << ", by " << k;
}

/// Three inputs as sparse numbers, and as what they stand for.
struct Inputs {
  Input x{1.7, 4, 2.0}, y{-0.6, 0, 1.0}, z{0.3, 2, 0.5};
  Dense X = scaled(1.7, 4, 2.0), Y = scaled(-0.6, 0, 1.0), Z = scaled(0.3, 2, 0.5);
  static Dense scaled(double value, int unknown, double slope) {
    Dense d(value);
    d.derivative[static_cast<std::size_t>(unknown)] = slope;
    return d;
  }
};

TEST(SparseDual, IsWhatTheDenseOneIs) {
  const Inputs i;
  expect_equal(i.x, i.X, "input");
  expect_equal(i.x + i.y, i.X + i.Y, "sum");
  expect_equal(i.x - i.y, i.X - i.Y, "difference");
  expect_equal(i.x * i.y, i.X * i.Y, "product");
  expect_equal(i.x / i.y, i.X / i.Y, "quotient");
  expect_equal(-i.x, -i.X, "negative");
  expect_equal(2.0 * i.x - i.y / 4.0 + 1.0, 2.0 * i.X - i.Y / 4.0 + 1.0, "with numbers");
  expect_equal(3.0 / i.z, 3.0 / i.Z, "inverse");
  expect_equal(1.0 - i.z, 1.0 - i.Z, "number less input");
  expect_equal(square(i.x - i.y), square(i.X - i.Y), "square");
}

TEST(SparseDual, AddsTermsOfOneUnknown) {
  const Inputs i;
  expect_equal((i.x + i.y) * (i.x - i.z), (i.X + i.Y) * (i.X - i.Z), "product of sums");
  expect_equal(i.x * i.x / i.x, i.X, "powers");
  expect_equal(sum(std::array<Input, 3>{i.x, i.z, i.x}), i.X + i.Z + i.X, "sum of a list");
}

TEST(SparseDual, MixesWithTheDenseOne) {
  const Inputs i;
  const Dense D = i.X * i.Y + i.Z;
  expect_equal(D + i.x, D + i.X, "sum");
  expect_equal(i.x - D, i.X - D, "difference");
  expect_equal(D * i.x, D * i.X, "product");
  expect_equal(D / i.x, D / i.X, "quotient");
  expect_equal(i.x / D, i.X / D, "quotient of input");
  Dense sum = D, wanted = D;
  sum += i.x * i.y;
  sum -= i.z;
  wanted += i.X * i.Y;
  wanted -= i.Z;
  expect_equal(sum, wanted, "in place");
}

TEST(SparseDual, BecomesOneOfMoreTerms) {
  const Inputs i;
  const SparseDual<n, 3> wide = i.x, constant = 2.5;
  expect_equal(wide, i.X, "input");
  expect_equal(constant, Dense(2.5), "constant");
}

TEST(SparseDual, ComparesByValue) {
  const Inputs i;
  EXPECT_TRUE(i.y < i.z && i.z < 0.4 && i.x > i.z && 1.7 <= i.x && i.x >= 1.7);
  EXPECT_FALSE(i.y > 0.0);
}

TEST(Through, TakesSparseAndDenseArguments) {
  const Inputs i;
  const auto f = [](const auto& a, const auto& b, const auto& c) { return a * exp(b) / (1.0 + c * c); };
  const Dense wanted = i.X * exp(i.Y) / (1.0 + i.Z * i.Z);
  expect_equal(through(f, i.x, i.y, i.z), wanted, "sparse");
  expect_equal(through(f, i.X, i.y, i.Z), wanted, "mixed");
  expect_equal(through(f, i.x, i.Y, i.z), wanted, "mixed");
  expect_equal(through(f, i.x, -0.6, i.z), i.X * std::exp(-0.6) / (1.0 + i.Z * i.Z), "with a constant");
  const auto pair = through([](const auto& a, const auto& b) { return std::array{a * b, a - b}; }, i.x + i.z, i.Y);
  expect_equal(pair[0], (i.X + i.Z) * i.Y, "first of two");
  expect_equal(pair[1], (i.X + i.Z) - i.Y, "second of two");
}

}  // namespace
}  // namespace scree
