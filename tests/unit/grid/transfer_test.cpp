/// Values from the grid of one box on that of another.
#include "scree/grid/transfer.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace scree {
namespace {

using Point = std::array<double, max_dim>;

Box box_of(const std::vector<std::vector<double>>& faces, bool last_periodic = false) {
  Box box;
  box.dim = static_cast<int>(faces.size());
  for (std::size_t a = 0; a < faces.size(); ++a) box.faces[a] = faces[a];
  box.periodic[static_cast<std::size_t>(box.dim - 1)] = last_periodic;
  return box;
}

/// From 0 to 1, `cells` cells that grow with `stretch`.
std::vector<double> faces(int cells, double stretch = 0) {
  std::vector<double> x;
  for (int i = 0; i <= cells; ++i) {
    const double s = static_cast<double>(i) / cells;
    x.push_back(s * (1 - stretch) + stretch * s * s);
  }
  return x;
}

template <class Work>
void for_each_cell(const Box& box, Work&& work) {
  Index count{{1, 1, 1}};
  for (int a = 0; a < box.dim; ++a) count[a] = box.cells(a);
  Index I;
  for (I[2] = 0; I[2] < count[2]; ++I[2])
    for (I[1] = 0; I[1] < count[1]; ++I[1])
      for (I[0] = 0; I[0] < count[0]; ++I[0]) {
        Point lower{}, upper{};
        double volume = 1;
        for (int a = 0; a < box.dim; ++a) {
          lower[a] = box.faces[a][I[a]];
          upper[a] = box.faces[a][I[a] + 1];
          volume *= upper[a] - lower[a];
        }
        work(I, lower, upper, volume);
      }
}

/// Rough, in [0, 0.64], periodic along a last axis of 5 cells.
double rough(const Index& I) {
  const double x = std::sin(3.7 * I[0] + 1.3 * ((I[1] + 50) % 5) * 2.1 + 0.8 * I[2]);
  return x > 0 ? 0.64 * x * x : 0;
}

TEST(Transfer, CellsKeepTheirSumAndStayBetweenTheirNeighbours) {
  for (const bool periodic : {false, true}) {
    const Box from = box_of({faces(7, 0.3), faces(5)}, periodic);
    for (const Box& to : {box_of({faces(4), faces(9, -0.4)}), box_of({faces(31, 0.2), faces(17)}), from}) {
      const Transfer transfer(from);
      double before = 0, after = 0;
      for_each_cell(from,
                    [&](const Index& I, const Point&, const Point&, double volume) { before += volume * rough(I); });
      for_each_cell(to, [&](const Index&, const Point& lower, const Point& upper, double volume) {
        const double value = transfer.mean(transfer.parts(lower, upper, -1), -1, rough);
        EXPECT_GE(value, 0);
        EXPECT_LE(value, 0.64);
        after += volume * value;
      });
      EXPECT_NEAR(after, before, 1e-14);
    }
  }
}

TEST(Transfer, TheSameGridGivesTheSameValues) {
  const Box box = box_of({faces(7, 0.3), faces(5), faces(3)});
  const Transfer transfer(box);
  for_each_cell(box, [&](const Index& I, const Point& lower, const Point& upper, double) {
    EXPECT_DOUBLE_EQ(transfer.mean(transfer.parts(lower, upper, -1), -1, rough), rough(I));
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_DOUBLE_EQ(transfer.mean(transfer.parts(lower, upper, axis), axis, rough), rough(I));
  });
}

/// Between the outer cells, where there is nothing beyond.
TEST(Transfer, KeepsLinearFields) {
  const Box from = box_of({faces(8, 0.2), faces(6)}), to = box_of({faces(21), faces(13, 0.1)});
  const Transfer transfer(from);
  const auto linear = [](double x, double y) { return 1 + 2 * x - 3 * y; };
  const auto centre = [&](int a, int i) { return 0.5 * (from.faces[a][i] + from.faces[a][i + 1]); };
  int checked = 0;
  for_each_cell(to, [&](const Index&, const Point& lower, const Point& upper, double) {
    if (lower[0] < from.faces[0][1] || upper[0] > from.faces[0][7] || lower[1] < from.faces[1][1] ||
        upper[1] > from.faces[1][5])
      return;
    ++checked;
    const double x = 0.5 * (lower[0] + upper[0]), y = 0.5 * (lower[1] + upper[1]);
    const auto at_centre = [&](const Index& I) { return linear(centre(0, I[0]), centre(1, I[1])); };
    EXPECT_NEAR(transfer.mean(transfer.parts(lower, upper, -1), -1, at_centre), linear(x, y), 1e-13);
    const auto at_face = [&](const Index& I) { return linear(from.faces[0][I[0]], centre(1, I[1])); };
    EXPECT_NEAR(transfer.mean(transfer.parts(lower, upper, 0), 0, at_face), linear(lower[0], y), 1e-13);
  });
  EXPECT_GT(checked, 20);
}

TEST(Transfer, WeightsCountPartsByTheirParticles) {
  const Box from = box_of({{0, 1, 2}});
  const Transfer transfer(from);
  const auto value = [](const Index& I) { return I[0] == 0 ? 10.0 : 4.0; };
  const auto weight = [](const Index& I) { return I[0] == 0 ? 0.6 : 0.2; };
  const auto parts = transfer.parts({0.5, 0, 0}, {2, 0, 0}, -1);
  EXPECT_DOUBLE_EQ(transfer.mean(parts, -1, value), (0.5 * 10 + 1 * 4) / 1.5);
  EXPECT_DOUBLE_EQ(transfer.mean(parts, -1, value, weight), (0.3 * 10 + 0.2 * 4) / 0.5);
}

}  // namespace
}  // namespace scree
