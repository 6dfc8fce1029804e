// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/seam_profile.h"

#include "core/error.h"
#include "support/patches.h"

#include <gtest/gtest.h>

namespace loopmend {
namespace {

TEST(SeamProfile, IsConstantAcrossTheSeamOfASphere) {
  const Patch patch = test::exact_sphere_patch(4, 0.8);
  const std::vector<ProfilePoint> profile = seam_profile(patch, 0, 3, 0.5);
  ASSERT_GT(profile.size(), 8u);
  EXPECT_LT(profile.front().distance, -0.2);
  EXPECT_GT(profile.back().distance, 0.3);
  int at_seam = 0;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    EXPECT_NEAR(profile[i].H, -1, 0.02);
    at_seam += profile[i].distance == 0;
    if (i > 0) {
      EXPECT_LE(profile[i - 1].distance, profile[i].distance);
    }
  }
  EXPECT_EQ(at_seam, 2);
  for (double jump : seam_jumps(patch, 0)) EXPECT_LT(jump, 0.05);
  EXPECT_LT(wide_curvature_jump(patch), 0.05);
}

TEST(SeamProfile, ShowsTheJumpOfAFlatFiller) {
  const Patch patch = test::start_of(test::open_sphere(4, 0.8));  // a lid that is all but flat
  const std::vector<ProfilePoint> profile = seam_profile(patch, 0, 0, 0.5);
  EXPECT_NEAR(profile.front().H, -1, 0.05);
  EXPECT_NEAR(profile.back().H, 0, 0.1);
  EXPECT_GT(wide_curvature_jump(patch), 0.5);
}

TEST(SeamProfile, RefusesALoopOrEdgeThatIsNotThere) {
  const Patch patch = test::exact_sphere_patch(3, 0.8);
  EXPECT_THROW(seam_profile(patch, 1, 0, 1), InvalidArgument);
  EXPECT_THROW(seam_profile(patch, 0, 1000, 1), InvalidArgument);
  EXPECT_THROW(seam_jumps(patch, -1), InvalidArgument);
}

}  // namespace
}  // namespace loopmend
