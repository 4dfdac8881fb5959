#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "scree/math/through.hpp"

namespace scree {
namespace {

using D1 = Dual<1>;
using D2 = Dual<2>;

D1 x_at(double value) { return D1::variable(value, 0); }

struct UnaryRow {
  std::string name;
  std::function<D1(const D1&)> f;
  double x, value, slope;
};

TEST(Dual, EveryOperationOfOneArgument) {
  const double a = 0.7;
  const std::vector<UnaryRow> rows = {
      {"+x", [](const D1& x) { return +x; }, a, a, 1},
      {"-x", [](const D1& x) { return -x; }, a, -a, -1},
      {"x + 2", [](const D1& x) { return x + 2; }, a, 2.7, 1},
      {"2 + x", [](const D1& x) { return 2 + x; }, a, 2.7, 1},
      {"x - 2", [](const D1& x) { return x - 2; }, a, -1.3, 1},
      {"2 - x", [](const D1& x) { return 2 - x; }, a, 1.3, -1},
      {"3 x", [](const D1& x) { return 3 * x; }, a, 2.1, 3},
      {"x 3", [](const D1& x) { return x * 3; }, a, 2.1, 3},
      {"x / 4", [](const D1& x) { return x / 4; }, a, 0.175, 0.25},
      {"4 / x", [](const D1& x) { return 4 / x; }, a, 4 / a, -4 / (a * a)},
      {"x x", [](const D1& x) { return x * x; }, a, a * a, 2 * a},
      {"x / (1 + x)", [](const D1& x) { return x / (1 + x); }, a, a / 1.7, 1 / (1.7 * 1.7)},
      {"sqrt", [](const D1& x) { return sqrt(x); }, a, std::sqrt(a), 0.5 / std::sqrt(a)},
      {"cbrt", [](const D1& x) { return cbrt(x); }, -8, -2, 1.0 / 12},
      {"exp", [](const D1& x) { return exp(x); }, a, std::exp(a), std::exp(a)},
      {"log", [](const D1& x) { return log(x); }, a, std::log(a), 1 / a},
      {"tanh", [](const D1& x) { return tanh(x); }, a, std::tanh(a), 1 - std::tanh(a) * std::tanh(a)},
      {"x^2.5", [](const D1& x) { return pow(x, 2.5); }, a, std::pow(a, 2.5), 2.5 * std::pow(a, 1.5)},
      {"0^2.5", [](const D1& x) { return pow(x, 2.5); }, 0, 0, 0},
      {"0^1", [](const D1& x) { return pow(x, 1); }, 0, 0, 1},
      {"x^3 by multiplication", [](const D1& x) { return integer_power(x, 3); }, -a, -a * a * a, 3 * a * a},
      {"x^0 by multiplication", [](const D1& x) { return integer_power(x, 0); }, 0, 1, 0},
      {"compound with Dual",
       [](D1 x) {
         const D1 y = x;
         x += y;
         x *= y;
         x -= y;
         x /= y;
         return x;
       },
       a, 2 * a - 1, 2},
      {"compound with double",
       [](D1 x) {
         x += 1;
         x *= 6;
         x -= 2;
         x /= 3;
         return x;
       },
       a, (6 * a + 4) / 3, 2},
      {"x *= x",
       [](D1 x) {
         x *= x;
         return x;
       },
       a, a * a, 2 * a},
  };
  for (const UnaryRow& row : rows) {
    const D1 y = row.f(x_at(row.x));
    EXPECT_NEAR(y.value, row.value, 1e-15 * (1 + std::abs(row.value))) << row.name;
    EXPECT_NEAR(y.derivative[0], row.slope, 4e-15 * (1 + std::abs(row.slope))) << row.name;
  }
}

// The operands may be one object.
TEST(Dual, CompoundOperatorsWithThemselves) {
  D1 x = x_at(0.7);
  const D1& same = x;
  x /= same;
  EXPECT_EQ(x.value, 1);
  EXPECT_NEAR(x.derivative[0], 0, 1e-15);
}

TEST(Dual, SeveralUnknownsKeepTheirPlaces) {
  const D2 x = D2::variable(3, 0), y = D2::variable(5, 1);
  const D2 z = x * y - x / y;
  EXPECT_DOUBLE_EQ(z.value, 15 - 0.6);
  EXPECT_DOUBLE_EQ(z.derivative[0], 5 - 0.2);
  EXPECT_DOUBLE_EQ(z.derivative[1], 3 + 3.0 / 25);
}

TEST(Dual, DoublesAreConstants) {
  const D2 constant = 4.0;
  EXPECT_EQ(constant.value, 4);
  EXPECT_EQ(constant.derivative, (std::array<double, 2>{0, 0}));
  const D2 zero{};
  EXPECT_EQ(zero.value, 0);
  EXPECT_EQ(zero.derivative, (std::array<double, 2>{0, 0}));
}

TEST(Dual, ComparesByValue) {
  const D1 x = x_at(1), y = 2.0;
  EXPECT_TRUE(x < y && x <= y && y > x && y >= x && x != y && !(x == y));
  EXPECT_TRUE(x < 2 && x <= 1 && x > 0 && x >= 1 && x == 1 && x != 2);
  EXPECT_TRUE(2 > x && 1 >= x && 0 < x && 1 <= x && 1 == x && 2 != x);
}

TEST(Dual, ValueOfBothNumbers) {
  EXPECT_EQ(value_of(2.5), 2.5);
  EXPECT_EQ(value_of(x_at(2.5)), 2.5);
}

// A kernel run with duals must not see other values than with doubles.
TEST(Dual, ValueIsThatOfPlainArithmetic) {
  const auto f = [](const auto& x) { return sqrt(x * x + 0.3 / x) / (1.7 - x) - x / 3.0; };
  for (double x = 0.01; x < 1.5; x += 0.037) EXPECT_NEAR(f(x_at(x)).value, f(x), 1e-15 * (1 + std::abs(f(x))));
}

struct Outer {
  Dual<4> a = Dual<4>::variable(0.3, 0), b = Dual<4>::variable(1.2, 1), c = Dual<4>::variable(-0.4, 2),
          d = Dual<4>::variable(2, 3);
  Dual<4> y = a * b + c;  // two intermediates that share unknowns
  Dual<4> z = d * d - a * c;
};

template <class Number>
Number smooth(const Number& y, const Number& z) {
  return sqrt(y * y + z) * exp(y / z);
}

void expect_equal(const Dual<4>& measured, const Dual<4>& expected) {
  EXPECT_DOUBLE_EQ(measured.value, expected.value);
  for (std::size_t j = 0; j < 4; ++j) EXPECT_NEAR(measured.derivative[j], expected.derivative[j], 1e-14);
}

TEST(Through, EqualsDirectDifferentiation) {
  const Outer o;
  expect_equal(through([](const auto& y, const auto& z) { return smooth(y, z); }, o.y, o.z), smooth(o.y, o.z));
}

TEST(Through, EveryMemberOfAnArray) {
  const Outer o;
  const auto f = [](const auto& y, const auto& z) {
    return std::array<std::decay_t<decltype(y)>, 3>{smooth(y, z), y / z, z};
  };
  const std::array<Dual<4>, 3> result = through(f, o.y, o.z);
  expect_equal(result[0], smooth(o.y, o.z));
  expect_equal(result[1], o.y / o.z);
  expect_equal(result[2], o.z);
}

TEST(Through, DifferentiatesOnlyWithRespectToDuals) {
  const Outer o;
  const auto f = [](const auto& y, const auto& constant, const auto& z) {
    static_assert(std::is_same_v<std::decay_t<decltype(constant)>, Dual<2>>);
    return smooth(y, z) * constant;
  };
  expect_equal(through(f, o.y, 3.0, o.z), smooth(o.y, o.z) * 3.0);
}

TEST(Through, IsThePlainCallForDoubles) {
  const double y = 0.5, z = 2;
  const auto f = [](const auto& a, const auto& b) {
    static_assert(std::is_same_v<std::decay_t<decltype(a)>, double>);
    return smooth(a, b);
  };
  EXPECT_EQ(through(f, y, z), smooth(y, z));
  EXPECT_EQ(through(f, y, 2), smooth(y, z));  // an int is a constant too
}

}  // namespace
}  // namespace scree
