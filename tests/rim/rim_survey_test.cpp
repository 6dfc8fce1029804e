// SPDX-License-Identifier: GPL-3.0-or-later
#include "rim/rim_survey.h"

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

class RimSurveyOf : public testing::TestWithParam<bool> {
 protected:
  Patch patch = test::start_of(GetParam() ? test::rough_open_sphere(4, 0.8) : test::open_sphere(4, 0.8));
};

TEST_P(RimSurveyOf, DoesNotDependOnWhatFillsTheLoops) {
  const RimSurvey with = survey_rim(patch), without = survey_rim(emptied(patch));
  ASSERT_FALSE(with.fits.vertices.empty());
  EXPECT_EQ(with.fits.vertices, without.fits.vertices);
  EXPECT_EQ(with.fits.H2, without.fits.H2);
  EXPECT_EQ(with.fits.H4, without.fits.H4);
  EXPECT_EQ(with.fits.residual, without.fits.residual);
  EXPECT_EQ(with.strays.largest, without.strays.largest);
  EXPECT_EQ(with.strays.median, without.strays.median);
  ASSERT_EQ(with.loops.size(), without.loops.size());
  for (std::size_t k = 0; k < with.loops[0].size(); ++k) {
    EXPECT_EQ(with.loops[0][k].H, without.loops[0][k].H);
    EXPECT_EQ(with.loops[0][k].H_sigma, without.loops[0][k].H_sigma);
  }
}

TEST_P(RimSurveyOf, SaysWhatFitsToThePatchSay) {
  const RimSurvey survey = survey_rim(emptied(patch));
  const RimRoughness now = rim_roughness(patch, survey.fits), plain = rim_roughness(patch);
  EXPECT_EQ(now.kind, plain.kind);
  EXPECT_EQ(now.unevenness, plain.unevenness);
  EXPECT_EQ(now.correlation, plain.correlation);
  EXPECT_EQ(now.noise, plain.noise);
  EXPECT_EQ(now.growth, plain.growth);
  EXPECT_EQ(now.bending, plain.bending);
  EXPECT_EQ(rim_summaries(patch, now, survey.loops)[0].H_sigma, rim_summaries(patch, plain)[0].H_sigma);
  const CalmSurroundings calm = without_strays(patch, survey.strays), plainly = without_strays(patch);
  EXPECT_EQ(calm.strays, plainly.strays);
  EXPECT_EQ(calm.patch.positions, plainly.patch.positions);
}

INSTANTIATE_TEST_SUITE_P(SmoothAndRough, RimSurveyOf, testing::Bool());

}  // namespace
}  // namespace loopmend
