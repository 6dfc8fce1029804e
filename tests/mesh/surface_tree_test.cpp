// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface_tree.h"

#include "samples/analytic_surfaces.h"

#include <gtest/gtest.h>

namespace loopmend {
namespace {

TEST(SurfaceTree, FindsTheClosestPointAndItsTriangle) {
  const Points points = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {5, 5, 5}, {6, 5, 5}, {5, 6, 5}, {7, 7, 7}};
  const SurfaceTree tree(points, {{6, 6, 6}, {0, 1, 2}, {3, 4, 5}});  // the first has no area
  const SurfacePoint over = tree.closest({0.5, 0.25, 3});
  EXPECT_EQ(over.triangle, 1);
  EXPECT_NEAR((over.place - Vec3(0.5, 0.25, 0)).norm(), 0, 1e-15);
  const SurfacePoint beside = tree.closest({6, 6, 7});
  EXPECT_EQ(beside.triangle, 2);
  EXPECT_NEAR((beside.place - Vec3(5.5, 5.5, 5)).norm(), 0, 1e-15);
}

TEST(SurfaceTree, IsRightOnASphere) {
  const TriangleSoup sphere = make_icosphere(4);
  const SurfaceTree tree(sphere.points, sphere.triangles);
  for (const Vec3& p : make_icosphere(2).points) {
    EXPECT_NEAR((tree.closest(3 * p).place - p).norm(), 0, 1e-12);  // its points are vertices of the finer one
    EXPECT_NEAR((tree.closest(0.5 * p).place).norm(), 1, 5e-3);
  }
}

TEST(SurfaceTree, OfNoTrianglesFindsNone) {
  EXPECT_EQ(SurfaceTree({}, {}).closest({1, 2, 3}).triangle, -1);
  const Points point = {{1, 1, 1}};
  EXPECT_EQ(SurfaceTree(point, {{0, 0, 0}}).closest({1, 2, 3}).triangle, -1);
}

}  // namespace
}  // namespace loopmend
