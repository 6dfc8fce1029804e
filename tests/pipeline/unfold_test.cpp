// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/unfold.h"
#include "mesh/quality.h"
#include "support/patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace loopmend {
namespace {

double largest_bend_deg(const Patch& patch) {
  double cosine = 1;
  for (const Bend& bend : bends(patch.positions, patch.triangles, static_cast<int>(patch.triangles.size())))
    cosine = std::min(cosine, bend.cosine);
  return std::acos(cosine) * 180 / std::numbers::pi;
}

TEST(Unfold, LeavesAPatchWithoutFoldsAsItIs) {
  Patch patch = test::exact_sphere_patch(3, 0.7);
  const Points before = patch.positions;
  EXPECT_FALSE(unfold(patch, 140, {}));
  EXPECT_EQ(patch.positions, before);
}

TEST(Unfold, OpensAFoldAndMovesNothingFarFromIt) {
  Patch patch = test::exact_sphere_patch(3, 0.7);
  // One free vertex pushed across the scan: the triangles at the seam beside it turn over.
  int near = -1;
  for (int f = 0; f < patch.patch_triangles && near < 0; ++f) {
    const Triangle& t = patch.triangles[f];
    for (int k = 0; k < 3; ++k)
      if (patch.ring[t[k]] == 0 && patch.ring[t[(k + 1) % 3]] == 1 && patch.ring[t[(k + 2) % 3]] == 1) near = t[k];
  }
  ASSERT_GE(near, 0);
  const Vec3 center = patch.to_frame(Vec3(0, 0, 1));
  const Points exact = patch.positions;
  const Vec3 outward = patch.positions[near] - center;
  patch.positions[near] = patch.to_frame(patch.to_mesh(patch.positions[near] + 0.6 * outward).normalized());
  ASSERT_GT(largest_bend_deg(patch), 150);
  const Points folded = patch.positions;
  EXPECT_TRUE(unfold(patch, 140, {}));
  EXPECT_LE(largest_bend_deg(patch), 140);
  for (int v = 0; v < patch.vertex_count(); ++v) {
    if (v >= patch.free_count) {
      ASSERT_EQ(patch.positions[v], folded[v]);
    } else if ((exact[v] - exact[near]).norm() > outward.norm()) {
      EXPECT_EQ(patch.positions[v], folded[v]) << v;
    }
  }
}

}  // namespace
}  // namespace loopmend
