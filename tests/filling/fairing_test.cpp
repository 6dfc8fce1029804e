#include "filling/fairing.h"

#include "filling/patch_remesh.h"
#include "mesh/quality.h"
#include "support/patches.h"

#include <gtest/gtest.h>

namespace loopmend {
namespace {

TEST(MinimalSurface, KeepsThePlaneAndLowersTheArea) {
  Points points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.4, 0.6, 0.5}};
  const Triangles triangles{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  for (int k = 0; k < 20; ++k) points = minimal_surface_step(points, triangles, 4);
  EXPECT_NEAR(points[4].z(), 0, 1e-3);
}

TEST(PatchRemesh, OutAndBackIsTheIdentity) {
  const Patch patch = test::start_of(test::rough_open_sphere(4, 0.8));
  const Patch same = with_interior(patch, open_for_remeshing(patch));
  ASSERT_EQ(same.positions.size(), patch.positions.size());
  for (int i = 0; i < patch.vertex_count(); ++i) EXPECT_EQ(same.positions[i], patch.positions[i]);
  EXPECT_EQ(same.ring, patch.ring);
  EXPECT_EQ(same.view_vertex, patch.view_vertex);
  EXPECT_EQ(same.loops, patch.loops);
  EXPECT_EQ(same.patch_triangles, patch.patch_triangles);
  EXPECT_EQ(count_folds(same.positions, same.triangles, same.patch_triangles), 0);
}

}  // namespace
}  // namespace loopmend
