#include "scree/grid/graded_axis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace scree {
namespace {

constexpr double mm = 1e-3, cm = 1e-2;

std::vector<double> widths(const std::vector<double>& faces) {
  std::vector<double> sizes;
  for (std::size_t i = 1; i < faces.size(); ++i) sizes.push_back(faces[i] - faces[i - 1]);
  return sizes;
}

double greatest_ratio(const std::vector<double>& sizes, bool periodic) {
  double greatest = 1;
  for (std::size_t i = periodic ? 0 : 1; i < sizes.size(); ++i) {
    const double ratio = sizes[i] / sizes[i > 0 ? i - 1 : sizes.size() - 1];
    greatest = std::max({greatest, ratio, 1 / ratio});
  }
  return greatest;
}

bool has_face(const std::vector<double>& faces, double at) {
  return std::find(faces.begin(), faces.end(), at) != faces.end();
}

/// The sizes of the cells below and above a place, over `unit`.
std::array<double, 2> sizes_beside(const std::vector<double>& faces, double at, double unit) {
  const auto face = std::find(faces.begin(), faces.end(), at);
  if (face == faces.begin() || face >= faces.end() - 1) return {0, 0};
  return {(face[0] - face[-1]) / unit, (face[1] - face[0]) / unit};
}

/// All that holds of any grid.
void expect_as_wanted(const CellSizes& wanted, const std::vector<double>& faces) {
  const std::vector<double> sizes = widths(faces);
  const double rounding = 1e-15 * std::max(std::abs(wanted.lower), std::abs(wanted.upper));
  EXPECT_EQ(faces.front(), wanted.lower);
  EXPECT_EQ(faces.back(), wanted.upper);
  for (const double plane : wanted.planes) EXPECT_TRUE(has_face(faces, plane)) << plane;
  for (const double plane : wanted.fine) EXPECT_TRUE(has_face(faces, plane)) << plane;
  const auto [least, greatest] = std::minmax_element(sizes.begin(), sizes.end());
  EXPECT_GE(*least, (1 - finest_slack) * wanted.finest * (1 - 1e-8) - rounding);
  EXPECT_LE(*greatest, wanted.coarsest * (1 + 1e-8) + rounding);
  EXPECT_LE(greatest_ratio(sizes, wanted.periodic), wanted.growth * (1 + 1e-7) + 3 * rounding / *least);
}

/// Where there is room and growth to reach a whole number, the cells on both sides of each fine place are neither
/// smaller nor greater.
void expect_finest_beside(const CellSizes& wanted, const std::vector<double>& faces) {
  const double rounding = 3e-15 * std::max(std::abs(wanted.lower), std::abs(wanted.upper)) / wanted.finest;
  for (const double place : wanted.fine)
    for (const double size : sizes_beside(faces, place, wanted.finest))
      EXPECT_TRUE(size == 0 || std::abs(size - 1) < 1e-7 + rounding) << size << " beside " << place;
}

/// The lip of an orifice and a floor, as in cases/bin_discharge.
TEST(GradedAxis, BeginsWithTheFinestAndGrowsAsGiven) {
  CellSizes wanted{0, 4 * cm, false, 0.1 * mm, 1 * cm, 1.2, {}, {0.7 * cm}};
  const std::vector<double> faces = GradedAxis(wanted).faces();
  expect_as_wanted(wanted, faces);
  const auto beside = sizes_beside(faces, 0.7 * cm, 0.1 * mm);
  EXPECT_NEAR(beside[0], 1, 1e-12);
  EXPECT_NEAR(beside[1], 1, 1e-12);
  const std::vector<double> sizes = widths(faces);
  const std::size_t lip = static_cast<std::size_t>(std::find(faces.begin(), faces.end(), 0.7 * cm) - faces.begin());
  EXPECT_NEAR(sizes[lip + 1] / sizes[lip], 0.2 / std::log(1.2), 1e-9) << "h has begun to grow";
  for (std::size_t i = lip + 2; i < lip + 12; ++i) EXPECT_NEAR(sizes[i] / sizes[i - 1], 1.2, 1e-9) << "cell " << i;
  EXPECT_GT(sizes.front(), 0.8 * mm) << "in the middle of the orifice";
  EXPECT_GT(sizes.back(), 4 * mm) << "at the wall";
}

TEST(GradedAxis, ReachesTheCoarsestFarAway) {
  CellSizes wanted{0, 1, false, 1 * mm, 2 * cm, 1.2, {}, {5 * cm}};
  const std::vector<double> sizes = widths(GradedAxis(wanted).faces());
  EXPECT_NEAR(sizes.back(), 2 * cm, 0.03 * cm);
  // Cells of a row that grows by 1.2, and of 2 cm: no more than one cell for each span and rise beyond that.
  const double rise = std::log(20) / std::log(1.2), way = (19 * mm) / std::log(1.2);
  EXPECT_LE(sizes.size(), rise + (1 - 5 * cm - way) / (2 * cm) + std::log(10) / std::log(1.2) + 4);
}

TEST(GradedAxis, WithoutFinePlacesIsUniform) {
  const CellSizes wanted{0, 1, false, 1 * mm, 0.3, 1.2, {}, {}};
  const std::vector<double> sizes = widths(GradedAxis(wanted).faces());
  ASSERT_EQ(sizes.size(), 4U);
  for (const double size : sizes) EXPECT_NEAR(size, 0.25, 1e-15);
  const CellSizes equal{0, 8 * mm, false, 1 * mm, 1 * mm, 1.2, {2 * mm, 5 * mm}, {}};
  for (const double size : widths(GradedAxis(equal).faces())) EXPECT_NEAR(size, 1 * mm, 1e-12);
}

TEST(GradedAxis, ACoarsestBeyondTheBoxIsNoLimit) {
  const CellSizes box{0, 4 * cm, false, 0.1 * mm, 4 * cm, 1.2, {}, {0.7 * cm}};
  CellSizes beyond = box;
  for (const double coarsest : {1.0, 1e30, 1e300}) {
    beyond.coarsest = coarsest;
    EXPECT_EQ(GradedAxis(beyond).faces(), GradedAxis(box).faces()) << coarsest;
  }
}

TEST(GradedAxis, PlanesThatAreNotFineAreHitWithoutRefinement) {
  const CellSizes wanted{0, 10 * cm, false, 0.1 * mm, 1 * cm, 1.2, {3.3 * cm, 4.6 * cm}, {}};
  const std::vector<double> faces = GradedAxis(wanted).faces();
  expect_as_wanted(wanted, faces);
  const std::vector<double> sizes = widths(faces);
  EXPECT_GT(*std::min_element(sizes.begin(), sizes.end()), 5 * mm) << "two of 6.5 mm between the planes";
  EXPECT_LE(faces.size(), 14U);
}

TEST(GradedAxis, CellsOfANarrowSlitAreGreaterThanTheFinest) {
  const CellSizes wanted{0, 10 * cm, false, 1 * mm, 1 * cm, 1.2, {}, {5 * cm, 5.17 * cm}};
  const std::vector<double> faces = GradedAxis(wanted).faces();
  expect_as_wanted(wanted, faces);
  EXPECT_NEAR(sizes_beside(faces, 5 * cm, 1 * mm)[1], 1.7, 1e-9) << "one cell: two would be of 0.85 mm";
  const CellSizes slack{0, 10 * cm, false, 1 * mm, 1 * cm, 1.2, {}, {5 * cm, 5.192 * cm}};
  EXPECT_NEAR(sizes_beside(GradedAxis(slack).faces(), 5 * cm, 1 * mm)[1], 0.96, 1e-3) << "two of 0.96 mm";
}

TEST(GradedAxis, WrapsRoundAPeriodicAxis) {
  CellSizes wanted{0, 10 * cm, true, 0.5 * mm, 1 * cm, 1.2, {}, {9.5 * cm}};
  std::vector<double> faces = GradedAxis(wanted).faces();
  expect_as_wanted(wanted, faces);
  EXPECT_LT(widths(faces).front(), 2.0 * mm) << "the place is 5 mm beyond the lower end";
  wanted.fine = {0};
  faces = GradedAxis(wanted).faces();
  expect_as_wanted(wanted, faces);
  EXPECT_NEAR(widths(faces).front(), 0.5 * mm, 1e-12);
  EXPECT_NEAR(widths(faces).back(), 0.5 * mm, 1e-12);
}

TEST(GradedAxis, RefinementCutsEachCell) {
  const CellSizes wanted{-4 * cm, 4 * cm, false, 0.2 * mm, 1 * cm, 1.3, {2.2 * cm}, {-0.7 * cm, 0.7 * cm}};
  const GradedAxis axis(wanted);
  const std::vector<double> once = axis.faces(), thrice = axis.faces(3);
  ASSERT_EQ(once.size(), axis.cells() + 1);
  ASSERT_EQ(thrice.size(), 3 * axis.cells() + 1);
  for (std::size_t i = 0; i < once.size(); ++i) EXPECT_NEAR(once[i], thrice[3 * i], 1e-14) << "face " << i;
  EXPECT_LE(greatest_ratio(widths(thrice), false), std::pow(1.3, 1.0 / 3) * (1 + 1e-7));
}

TEST(GradedAxis, PlanesThatDifferByRoundingAreOne) {
  const double lip = 1.4 * cm / 2, again = std::nextafter(lip, 1.0);
  const std::vector<double> faces = GradedAxis({0, 4 * cm, false, 1 * mm, 1 * cm, 1.2, {again}, {lip}}).faces();
  EXPECT_TRUE(has_face(faces, lip));
  EXPECT_FALSE(has_face(faces, again));
}

TEST(GradedAxis, WhatDoesNotFitNamesTheTwoPlanes) {
  const auto error = [](const CellSizes& wanted) {
    try {
      GradedAxis axis(wanted);
    } catch (const GradingError& e) {
      return std::pair(e.lower, e.upper);
    }
    return std::pair(0.0, 0.0);
  };
  EXPECT_EQ(error({0, 1, false, 0.01, 0.1, 1.2, {0.5, 0.505}, {}}), std::pair(0.5, 0.505)) << "closer than the finest";
  EXPECT_EQ(error({0, 1, false, 0.01, 0.01, 1.2, {0.075}, {}}), std::pair(0.0, 0.075)) << "7.5 cells of the only size";
  EXPECT_EQ(error({0, 1, false, 0.01, 0.1, 1.2, {0.5, 0.518, 0.528}, {}}), std::pair(0.518, 0.528))
      << "one cell of 0.018 beside one of 0.01 grows by more";
}

// ---- any wish, at random

class RandomWish {
 public:
  explicit RandomWish(unsigned seed) : pick_(seed) {}

  CellSizes next() {
    CellSizes wanted;
    const double size = std::pow(10.0, between(-3, 2));
    wanted.lower = between(-1, 1) * size;
    wanted.upper = wanted.lower + size * between(0.5, 2);
    wanted.periodic = between(0, 1) < 0.3;
    wanted.growth = 1 + std::pow(10.0, between(-2, 0));
    wanted.finest = (wanted.upper - wanted.lower) * std::pow(10.0, between(-4, -1.3));
    wanted.coarsest = wanted.finest * std::pow(10.0, between(0.35, 2));
    add(wanted, wanted.planes, 4);
    add(wanted, wanted.fine, 4);
    if (between(0, 1) < 0.2) wanted.fine.push_back(wanted.lower);
    return wanted;
  }

  double between(double a, double b) { return std::uniform_real_distribution<double>(a, b)(pick_); }

 private:
  void add(const CellSizes& wanted, std::vector<double>& list, int most) {
    for (int n = std::uniform_int_distribution<int>(0, most)(pick_); n > 0; --n)
      list.push_back(between(wanted.lower, wanted.upper));
  }
  std::mt19937 pick_;
};

double least_gap(const CellSizes& wanted) {
  std::vector<double> all{wanted.lower, wanted.upper};
  all.insert(all.end(), wanted.planes.begin(), wanted.planes.end());
  for (const double x : wanted.fine)
    if (x > wanted.lower) all.push_back(x);
  std::sort(all.begin(), all.end());
  double least = wanted.upper - wanted.lower;
  for (std::size_t i = 1; i < all.size(); ++i) least = std::min(least, all[i] - all[i - 1]);
  return least;
}

TEST(GradedAxis, KeepsItsPromisesWhateverIsWanted) {
  RandomWish wishes(20);
  int fitting = 0, roomy = 0;
  for (int k = 0; k < 4000; ++k) {
    SCOPED_TRACE(k);
    const CellSizes wanted = wishes.next();
    const double gap = least_gap(wanted);
    try {
      const std::vector<double> faces = GradedAxis(wanted).faces();
      expect_as_wanted(wanted, faces);
      if (gap >= 10 * wanted.finest && wanted.growth >= 1.1) expect_finest_beside(wanted, faces);
      ++fitting;
    } catch (const GradingError& error) {
      EXPECT_LT(gap, 10 * wanted.finest) << "planes at " << error.lower << " and " << error.upper;
    }
    roomy += gap >= 10 * wanted.finest;
    if (testing::Test::HasFailure()) break;
  }
  EXPECT_GT(roomy, 1500);
  EXPECT_GT(fitting, roomy);
}

TEST(GradedAxis, SymmetricWishesGiveTheSameBitsOnBothSides) {
  RandomWish wishes(7);
  int fitting = 0;
  for (int k = 0; k < 1000; ++k) {
    SCOPED_TRACE(k);
    CellSizes wanted = wishes.next();
    wanted.upper = std::abs(wanted.upper - wanted.lower);
    wanted.lower = -wanted.upper;
    for (std::vector<double>* list : {&wanted.planes, &wanted.fine}) {
      for (double& x : *list) x = wishes.between(wanted.lower, wanted.upper);
      const std::vector<double> one_side = *list;
      for (const double x : one_side) list->push_back(-x);
    }
    try {
      const std::vector<double> faces = GradedAxis(wanted).faces();
      for (std::size_t i = 0; i < faces.size(); ++i) ASSERT_EQ(faces[i], -faces[faces.size() - 1 - i]) << "face " << i;
      expect_as_wanted(wanted, faces);
      ++fitting;
    } catch (const GradingError&) {
    }
    if (testing::Test::HasFailure()) break;
  }
  EXPECT_GT(fitting, 300);
}

TEST(GradedAxis, MirroredWishesGiveMirroredFaces) {
  RandomWish wishes(11);
  for (int k = 0; k < 500; ++k) {
    SCOPED_TRACE(k);
    const CellSizes wanted = wishes.next();
    CellSizes mirrored = wanted;
    mirrored.lower = -wanted.upper;
    mirrored.upper = -wanted.lower;
    for (std::vector<double>* list : {&mirrored.planes, &mirrored.fine})
      for (double& x : *list) x = -x;
    std::vector<double> faces, others;
    try {
      faces = GradedAxis(wanted).faces();
    } catch (const GradingError&) {
    }
    try {
      others = GradedAxis(mirrored).faces();
    } catch (const GradingError&) {
    }
    ASSERT_EQ(faces.size(), others.size());
    for (std::size_t i = 0; i < faces.size(); ++i) ASSERT_EQ(faces[i], -others[faces.size() - 1 - i]) << "face " << i;
  }
}

}  // namespace
}  // namespace scree
