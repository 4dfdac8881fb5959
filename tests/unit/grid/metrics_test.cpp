/// Operators on a graded grid: exact for linear functions, conservative, and means that weigh by volume.
#include "scree/grid/metrics.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace scree {
namespace {

class MetricsTest : public ::testing::Test {
 protected:
  void SetUp() override {
    box_.dim = 1;
    box_.faces[0] = {0, 1, 3, 4, 8};
    ASSERT_EQ(create_dm(PETSC_COMM_SELF, box_, 1, 2, &dm_), 0);
    lattice_ = std::make_unique<Lattice>(box_, dm_);
  }
  void TearDown() override { EXPECT_EQ(DMDestroy(&dm_), 0); }
  Metrics grid() const { return {*lattice_}; }

  Box box_;
  DM dm_ = nullptr;
  std::unique_ptr<Lattice> lattice_;
};

TEST_F(MetricsTest, DifferencesOfLinearFunctionsAreExact) {
  const auto f = [](double x) { return 3 * x - 1; };
  const Axis& x = grid().axis(0);
  for (int i = 1; i < 4; ++i)
    EXPECT_DOUBLE_EQ(difference_at_face(grid(), 0, Index{{i, 0, 0}}, f(x.centre(i - 1)), f(x.centre(i))), 3) << i;
  for (int i = 0; i < 4; ++i) {
    EXPECT_DOUBLE_EQ(difference_in_cell(grid(), 0, Index{{i, 0, 0}}, f(x.face(i)), f(x.face(i + 1))), 3) << i;
    EXPECT_DOUBLE_EQ(difference_to_face(grid(), 0, Index{{i, 0, 0}}, f(x.centre(i)), f(x.face(i + 1))), 3) << i;
  }
}

TEST_F(MetricsTest, WhatLeavesACellEntersTheNext) {
  const Axis& x = grid().axis(0);
  for (int i = 1; i < 4; ++i) {
    const double out = out_of_cell(grid(), 0, Index{{i - 1, 0, 0}}, End::upper, 2.0) * x.width(i - 1);
    const double in = out_of_cell(grid(), 0, Index{{i, 0, 0}}, End::lower, 2.0) * x.width(i);
    EXPECT_DOUBLE_EQ(out, in);
  }
}

TEST_F(MetricsTest, ControlVolumesFillTheBox) {
  double sum = 0;
  for (int i = 0; i <= 4; ++i) sum += grid().control_length(0, Index{{i, 0, 0}});
  EXPECT_DOUBLE_EQ(sum, 8);
  EXPECT_DOUBLE_EQ(out_of_control_volume(grid(), 0, Index{}, End::upper, 1.0), 2);  // half a cell of 1
  EXPECT_DOUBLE_EQ(out_of_control_volume(grid(), 0, Index{{1, 0, 0}}, End::lower, 3.0), 2);
}

TEST_F(MetricsTest, MeansWeighByShare) {
  EXPECT_DOUBLE_EQ(face_mean(grid(), 0, Index{{1, 0, 0}}, 3.0, 0.0), 1);  // widths 1 and 2
  EXPECT_DOUBLE_EQ(share_of_cell(grid(), 0, Index{{0, 0, 0}}, 1), 1.0 / 3);
  EXPECT_DOUBLE_EQ(share_of_cell(grid(), 0, Index{{1, 0, 0}}, 0), 2.0 / 3);
  EXPECT_DOUBLE_EQ(share_of_cell(grid(), 0, Index{{0, 0, 0}}, 0), 1);  // on a side
}

TEST_F(MetricsTest, UpwindingBesideABarrierMirrorsTheCell) {
  const AdvectionMetrics open = face_metrics(grid(), 0, Index{{1, 0, 0}}, false, false);
  const AdvectionMetrics mirrored = face_metrics(grid(), 0, Index{{1, 0, 0}}, true, true);
  EXPECT_EQ(open.far_lower, 1);
  EXPECT_EQ(open.far_upper, 1);
  EXPECT_EQ(mirrored.far_lower, 2);
  EXPECT_EQ(mirrored.far_upper, 2);
  EXPECT_EQ(open.lower_reach, 1);
}

}  // namespace
}  // namespace scree
