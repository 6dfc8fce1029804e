// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/fairing.h"

#include "mesh/quality.h"
#include "remeshing/patch_remesh.h"
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

TEST(LinearFairing, LeavesAPlaneAPlane) {
  const SurfaceModel model =
      make_surface_model(cut(make_graph([](double x, double y) { return 0.3 * x - 0.2 * y; }, 1, 20),
                             [](const Vec3& p) { return p.head<2>().norm() < 0.4; }));
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  ASSERT_EQ(loops.size(), 2u);
  ASSERT_EQ(loops[1].kind, LoopKind::hole);
  Patch patch = *make_initial_patch(model, {loops[1]}, {}, {}).patch;
  test::disturb(patch, 0.05);
  const Points faired = linear_fairing(patch, 0, robust_clamp);
  ASSERT_EQ(faired.size(), patch.positions.size());
  ASSERT_GT(patch.free_count, 20);
  for (int i = 0; i < patch.free_count; ++i) {
    const Vec3 p = patch.to_mesh(faired[i]);
    EXPECT_NEAR(p.z(), 0.3 * p.x() - 0.2 * p.y(), 1e-9);
  }
  for (int i = patch.free_count; i < patch.vertex_count(); ++i) EXPECT_EQ(faired[i], patch.positions[i]);
}

TEST(LinearFairing, BringsAFlatFillerCloseToTheSphere) {
  Patch patch = test::start_of(test::open_sphere(4, 0.8));
  const auto error = [&] {
    double sum = 0;
    for (int i = 0; i < patch.free_count; ++i) sum += std::pow(patch.to_mesh(patch.positions[i]).norm() - 1, 2);
    return std::sqrt(sum / patch.free_count);
  };
  const double before = error();
  patch.positions = linear_fairing(patch, 0, robust_clamp);
  EXPECT_LT(error(), 0.05 * before);
}

TEST(LinearFairing, BendingPullsTheOtherWay) {
  const Patch patch = test::start_of(test::open_sphere(4, 0.8));
  const auto top = [&](double bending) {
    double highest = -1;
    const Points faired = linear_fairing(patch, bending, even_clamp);
    for (int i = 0; i < patch.free_count; ++i) highest = std::max(highest, patch.to_mesh(faired[i]).z());
    return highest;
  };
  EXPECT_LT(top(1e4), top(10));
  EXPECT_LT(top(10), top(0));
}

}  // namespace
}  // namespace loopmend
