// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/surface_distance.h"

#include "samples/analytic_surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace loopmend {
namespace {

TriangleSoup soup_of(Points points, Triangles triangles) {
  TriangleSoup soup;
  soup.points = std::move(points);
  soup.triangles = std::move(triangles);
  return soup;
}

/// Upward.
TriangleSoup square() { return soup_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}); }

std::vector<double> distances(const Points& points, const TriangleSoup& surface) {
  return signed_distances(points, surface, SurfaceTree(surface.points, surface.triangles));
}

TEST(SurfaceDistance, IsPositiveWhereTheNormalsLook) {
  const std::vector<double> d = distances({{0.5, 0.25, 2}, {0.25, 0.5, -3}, {0.5, 0.5, 0}}, square());
  EXPECT_DOUBLE_EQ(d[0], 2);
  EXPECT_DOUBLE_EQ(d[1], -3);
  EXPECT_DOUBLE_EQ(std::abs(d[2]), 0);
}

TEST(SurfaceDistance, IsThatOfTheClosestPlaceBesideTheSurface) {
  const std::vector<double> d = distances({{4, 0.5, 4}, {-3, -4, 0}}, square());
  EXPECT_DOUBLE_EQ(d[0], 5);
  EXPECT_DOUBLE_EQ(std::abs(d[1]), 5);
}

TEST(SurfaceDistance, OfABallInABall) {
  const TriangleSoup inner = make_icosphere(2), outer = make_icosphere(5);
  Points small = inner.points, large = inner.points;
  for (Vec3& p : small) p *= 0.9;
  for (Vec3& p : large) p *= 1.2;
  // The vertices of the inner ball are vertices of the outer one.
  for (double d : distances(large, outer)) EXPECT_NEAR(d, 0.2, 1e-12);
  for (double d : distances(small, outer)) EXPECT_NEAR(d, -0.1, 1e-3);
}

TEST(SurfaceDistance, IsNotKnownWithoutASurface) {
  const std::vector<double> d = distances({{0, 0, 0}}, soup_of(square().points, {{0, 0, 1}}));
  ASSERT_EQ(d.size(), 1U);
  EXPECT_TRUE(std::isnan(d[0]));
  EXPECT_EQ(summary_of(d).count, 0U);
}

TEST(SurfaceDistance, IsSummed) {
  const DistanceSummary summary = summary_of({3, -4, std::nan(""), 0, 1});
  EXPECT_EQ(summary.count, 4U);
  EXPECT_DOUBLE_EQ(summary.mean, 0);
  EXPECT_DOUBLE_EQ(summary.rms, std::sqrt(26.0 / 4));
  EXPECT_EQ(summary.largest, 4);
  EXPECT_EQ(summary.nearly_all, 4);
}

}  // namespace
}  // namespace loopmend
