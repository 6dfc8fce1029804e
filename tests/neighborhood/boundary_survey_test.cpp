// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighborhood/boundary_survey.h"

#include "support/patches.h"

#include <gtest/gtest.h>

namespace loopmend {
namespace {

/// The loops of a patch, and what is around them, without its free vertices.
Patch emptied(const Patch& patch) {
  Patch empty = patch;
  const int n = patch.free_count;
  empty.free_count = empty.patch_triangles = 0;
  empty.positions.erase(empty.positions.begin(), empty.positions.begin() + n);
  empty.ring.erase(empty.ring.begin(), empty.ring.begin() + n);
  empty.view_vertex.erase(empty.view_vertex.begin(), empty.view_vertex.begin() + n);
  empty.triangles.assign(patch.triangles.begin() + patch.patch_triangles, patch.triangles.end());
  for (Triangle& t : empty.triangles)
    for (int& v : t) v -= n;
  for (auto& loop : empty.loops)
    for (int& v : loop) v -= n;
  return empty;
}

class BoundarySurveyOf : public testing::TestWithParam<bool> {
 protected:
  Patch patch = test::start_of(GetParam() ? test::rough_open_sphere(4, 0.8) : test::open_sphere(4, 0.8));
};

TEST_P(BoundarySurveyOf, DoesNotDependOnWhatFillsTheLoops) {
  const BoundarySurvey with = survey_boundary(patch), without = survey_boundary(emptied(patch));
  EXPECT_GT(with.split.relief, 0);
  EXPECT_EQ(with.split.relief, without.split.relief);
  EXPECT_EQ(with.split.noise, without.split.noise);
  EXPECT_EQ(with.split.relief_height, without.split.relief_height);
  EXPECT_EQ(with.split.noise_height, without.split.noise_height);
  EXPECT_EQ(with.split.radius, without.split.radius);
  ASSERT_EQ(with.loops.size(), without.loops.size());
  for (std::size_t k = 0; k < with.loops[0].size(); ++k) {
    EXPECT_EQ(with.loops[0][k].H, without.loops[0][k].H);
    EXPECT_EQ(with.loops[0][k].H_sigma, without.loops[0][k].H_sigma);
  }
}

INSTANTIATE_TEST_SUITE_P(SmoothAndRough, BoundarySurveyOf, testing::Bool());

}  // namespace
}  // namespace loopmend
