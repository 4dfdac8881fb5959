#include "scree/grid/coarse_axis.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace scree::test {
namespace {

std::vector<double> uniform(int cells) {
  std::vector<double> faces(static_cast<std::size_t>(cells) + 1);
  std::iota(faces.begin(), faces.end(), 0.0);
  return faces;
}

double position(const AxisWeights& w, const std::vector<double>& faces) {
  double sum = 0;
  for (int k = 0; k < w.count; ++k)
    sum +=
        w.weight[static_cast<std::size_t>(k)] * faces[static_cast<std::size_t>(w.place[static_cast<std::size_t>(k)])];
  return sum;
}

TEST(CoarseAxis, HalvesUniformCells) {
  EXPECT_EQ(CoarseAxis(uniform(8), 2.5).faces(), (std::vector<double>{0, 2, 4, 6, 8}));
  EXPECT_EQ(CoarseAxis(uniform(7), 2.5).faces(), (std::vector<double>{0, 2, 4, 6, 7}));
  EXPECT_EQ(CoarseAxis(uniform(3), 0).faces(), uniform(3));
}

TEST(CoarseAxis, LeavesWideCellsAndJoinsNarrowOnes) {
  const std::vector<double> graded{0, 8, 12, 14, 15, 16, 18, 22, 30};
  EXPECT_EQ(CoarseAxis(graded, 2.5).faces(), (std::vector<double>{0, 8, 12, 14, 16, 18, 22, 30}));
  EXPECT_EQ(CoarseAxis(graded, 6).faces(), (std::vector<double>{0, 8, 14, 16, 22, 30}));
}

TEST(CoarseAxis, FacesHaveTheLineThroughTheWiderOnes) {
  for (const auto& faces : {uniform(8), uniform(7), std::vector<double>{0, 1, 2.2, 3.6, 5.3, 7.3}}) {
    const CoarseAxis axis(faces, 3);
    for (int i = 0; i < static_cast<int>(faces.size()); ++i)
      EXPECT_NEAR(position(axis.face(i), axis.faces()), faces[static_cast<std::size_t>(i)], 1e-14);
  }
}

TEST(CoarseAxis, CellsHaveTheirWiderCellAndPaddingThePadding) {
  const CoarseAxis even(uniform(8), 2), odd(uniform(7), 2);
  EXPECT_EQ(even.cell(5).place[0], 2);
  EXPECT_EQ(odd.cell(6).place[0], 3) << "alone in its coarse cell";
  EXPECT_EQ(even.cell(8).place[0], 4);
  EXPECT_EQ(odd.cell(7).place[0], 4);
  EXPECT_EQ(odd.face(7).place[0], 4) << "the upper side stays where it is";
  EXPECT_EQ(odd.face(7).count, 1);
}

}  // namespace
}  // namespace scree::test
