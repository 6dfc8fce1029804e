// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/section_profile.h"

#include "analysis/curvature_field.h"

#include "core/error.h"
#include "support/patches.h"

#include <gtest/gtest.h>

#include <cmath>

namespace loopmend {
namespace {

std::vector<float> floats(const std::vector<double>& values) { return {values.begin(), values.end()}; }

TEST(SectionProfile, RunsOnceAcrossTheSphereCap) {
  const Patch patch = test::exact_sphere_patch(4, 0.8);
  const std::vector<float> H = floats(curvature_field(patch).H);
  for (double angle : {0.0, 0.7, 2.0}) {
    const SectionProfile profile = section_profile(patch, 0, angle, H);
    ASSERT_GT(profile.arc.size(), 10u);
    // In, through the patch, out: two changes of side.
    int changes = 0;
    for (std::size_t i = 1; i < profile.side.size(); ++i) changes += profile.side[i] != profile.side[i - 1];
    EXPECT_EQ(changes, 2);
    EXPECT_EQ(profile.side.front(), SectionProfile::Side::neighborhood);
    // The patch's part is an arc of a great circle of the unit sphere, and lies in the middle.
    double first = 0, last = 0;
    for (std::size_t i = 0; i < profile.arc.size(); ++i) {
      EXPECT_GE(profile.arc[i], profile.arc[i > 0 ? i - 1 : 0]);
      EXPECT_NEAR(profile.path[i].norm(), 1, 0.01);
      const auto [a, b] = profile.edge[i];
      const double t = profile.weight[i];
      EXPECT_GE(t, 0);
      EXPECT_LE(t, 1);
      const Vec3 on_edge = (1 - t) * patch.positions[a] + t * patch.positions[b];
      EXPECT_LT((patch.to_mesh(on_edge) - profile.path[i]).norm(), 1e-12);
      if (profile.side[i] != SectionProfile::Side::patch) continue;
      first = std::min(first, profile.arc[i]);
      last = std::max(last, profile.arc[i]);
      EXPECT_NEAR(profile.value[i], -1, 0.05);
    }
    EXPECT_NEAR(first, -last, 1e-9);
    EXPECT_NEAR(last, std::acos(0.8), 0.08);
  }
}

TEST(SectionProfile, RefusesWhatDoesNotFit) {
  const Patch patch = test::exact_sphere_patch(3, 0.8);
  EXPECT_THROW(section_profile(patch, 1, 0, std::vector<float>(patch.positions.size())), InvalidArgument);
  EXPECT_THROW(section_profile(patch, 0, 0, std::vector<float>(3)), InvalidArgument);
}

}  // namespace
}  // namespace loopmend
