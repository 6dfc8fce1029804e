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

}  // namespace
}  // namespace loopmend::test
