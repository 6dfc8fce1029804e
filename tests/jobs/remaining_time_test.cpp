// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/remaining_time.h"

#include <gtest/gtest.h>

namespace loopmend::test {
namespace {

TEST(RemainingTime, IsInProportionToWhatIsLeft) {
  EXPECT_DOUBLE_EQ(seconds_left(10, 0.25).value_or(0), 30);
  EXPECT_DOUBLE_EQ(seconds_left(10, 0.5).value_or(0), 10);
}

TEST(RemainingTime, IsNotToldWhereItIsNotKnown) {
  EXPECT_FALSE(seconds_left(2.9, 0.5));
  EXPECT_FALSE(seconds_left(60, 0.04));
  EXPECT_FALSE(seconds_left(60, 0));
  EXPECT_FALSE(seconds_left(60, 1));
}

TEST(RemainingTime, OneStepMoreIsExpectedWhereMoreWereTakenThanUsual) {
  EXPECT_GT(steps_left(1), steps_left(2));
  EXPECT_DOUBLE_EQ(steps_left(5), steps_left(12));
  EXPECT_GE(steps_left(12), 1);
}

TEST(RemainingTime, AHoleOfTwiceTheEdgesIsFourTimesTheWork) {
  BoundaryLoop small, large;
  small.vertices.resize(1000);
  large.vertices.resize(2000);
  EXPECT_NEAR(work_of(large) / work_of(small), 4, 0.001);
}

TEST(RemainingTime, RepairsBeginWithNothingDoneAndNeverGoBack) {
  const std::set<Defect> defects{Defect::coincident_points, Defect::intersections, Defect::non_manifold};
  double before = 0;
  EXPECT_EQ(share_of_repair(defects, {RepairStage::join_vertices, 1, 3}), 0);
  for (const RepairStep& step :
       {RepairStep{RepairStage::cut_intersections, 2, 3}, RepairStep{RepairStage::separate, 3, 3},
        RepairStep{RepairStage::turn_outward, 3, 3}, RepairStep{RepairStage::measure_result}}) {
    const double share = share_of_repair(defects, step);
    EXPECT_GT(share, before);
    before = share;
  }
  EXPECT_LT(before, 1);
  EXPECT_EQ(share_of_repair({Defect::fragments}, {RepairStage::remove_fragments, 1, 1}), 0);
}

}  // namespace
}  // namespace loopmend::test
