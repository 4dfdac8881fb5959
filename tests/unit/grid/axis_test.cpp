#include <gtest/gtest.h>

#include "scree/grid/lattice.hpp"

namespace scree {
namespace {

const std::vector<double> faces{1.0, 1.1, 1.4, 1.6, 2.2};  // widths 0.1 0.3 0.2 0.6

TEST(Axis, MetricsInsideFollowTheFaces) {
  const Axis axis(faces, false);
  EXPECT_EQ(axis.cells(), 4);
  const double widths[] = {0.1, 0.3, 0.2, 0.6}, centres[] = {1.05, 1.25, 1.5, 1.9};
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(axis.width(i), widths[i], 1e-15) << "cell " << i;
    EXPECT_NEAR(axis.centre(i), centres[i], 1e-15) << "cell " << i;
    EXPECT_EQ(axis.face(i), faces[i]) << "face " << i;
  }
  EXPECT_EQ(axis.face(4), faces[4]);
  EXPECT_NEAR(axis.distance(1), 0.2, 1e-15) << "from centre 0 to centre 1";
  EXPECT_NEAR(axis.lower_share(1), 0.25, 1e-15) << ".1 of .1 + .3";
  EXPECT_NEAR(axis.lower_share(3), 0.25, 1e-15) << ".2 of .2 + .6";
}

struct Continuation {
  const char* name;
  bool periodic;
  std::array<double, 3> widths_below, widths_above;  ///< of cells -3 -2 -1 and 4 5 6
  double distance_at_start, distance_at_end, share_at_start, share_at_end;
};

TEST(Axis, MetricsBeyondTheEndsMirrorOrWrap) {
  const Continuation rows[] = {
      {"closed", false, {0.2, 0.3, 0.1}, {0.6, 0.2, 0.3}, 0.1, 0.6, 0.5, 0.5},
      {"periodic", true, {0.3, 0.2, 0.6}, {0.1, 0.3, 0.2}, 0.35, 0.35, 6.0 / 7, 6.0 / 7},
  };
  for (const Continuation& row : rows) {
    SCOPED_TRACE(row.name);
    const Axis axis(faces, row.periodic);
    EXPECT_EQ(axis.periodic(), row.periodic);
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(axis.width(k - 3), row.widths_below[k], 1e-15) << "cell " << k - 3;
      EXPECT_NEAR(axis.width(4 + k), row.widths_above[k], 1e-15) << "cell " << 4 + k;
    }
    EXPECT_NEAR(axis.distance(0), row.distance_at_start, 1e-15);
    EXPECT_NEAR(axis.distance(4), row.distance_at_end, 1e-15);
    EXPECT_NEAR(axis.lower_share(0), row.share_at_start, 1e-15);
    EXPECT_NEAR(axis.lower_share(4), row.share_at_end, 1e-15);
    for (int i = -halo; i < 4 + halo; ++i)
      EXPECT_NEAR(axis.face(i + 1) - axis.face(i), axis.width(i), 1e-14) << "faces about cell " << i;
  }
}

TEST(Axis, ShorterThanTheHaloStillHasMetrics) {
  const Axis mirrored({0.0, 1.0, 3.0}, false), wrapped({0.0, 1.0, 3.0}, true);
  const double mirror[] = {2, 2, 1, 1, 2, 2, 1, 1}, wrap[] = {2, 1, 2, 1, 2, 1, 2, 1};
  for (int i = -halo; i <= 2 + halo - 1; ++i) {
    EXPECT_EQ(mirrored.width(i), mirror[i + halo]) << "closed, cell " << i;
    EXPECT_EQ(wrapped.width(i), wrap[i + halo]) << "periodic, cell " << i;
  }
}

}  // namespace
}  // namespace scree
