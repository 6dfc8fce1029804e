// SPDX-License-Identifier: GPL-3.0-or-later
#include "edges/side_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace loopmend {
namespace {

TEST(SideSurface, FitsWhatItIsMadeFor) {
  const auto points_of = [](auto&& place) {
    Points points;
    for (int i = 0; i < 9; ++i)
      for (int k = 0; k < 9; ++k) points.push_back(place(0.1 * i - 0.4, 0.1 * k - 0.4));
    return points;
  };
  const auto plane = SideSurface::fit(points_of([](double x, double y) { return Vec3(x, y, 2 + x - y); }),
                                      Vec3(-1, 1, 1).normalized(), 1);
  EXPECT_EQ(plane->kind(), SideSurface::Kind::plane);
  EXPECT_LT((plane->foot({0, 0, 5}) - Vec3(1, -1, 4)).norm(), 1e-9);
  const auto cone = SideSurface::fit(
      points_of([](double x, double y) { return Vec3((2 + y) * std::cos(x), (2 + y) * std::sin(x), y); }),
      Vec3(1, 0, 0), 1);
  EXPECT_EQ(cone->kind(), SideSurface::Kind::quadric);
  // Far from the samples, too.
  const Vec3 foot = cone->foot({1.1, 1.1, -0.4});
  EXPECT_NEAR(foot.head<2>().norm(), 2 + foot.z(), 1e-6);
  EXPECT_FALSE(SideSurface::fit({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)}, Vec3(0, 0, 1), 1));
}

TEST(SideSurface, SurfacesMeetInACommonPoint) {
  const auto side = [](const Vec3& normal, double offset) {
    const Vec3 u = normal.unitOrthogonal(), v = normal.cross(u);
    const Vec3 o = offset * normal;
    return *SideSurface::fit({o, o + u, o + v, o - u, o - v}, normal, 1);
  };
  const SideSurface x = side(Vec3::UnitX(), 1), y = side(Vec3::UnitY(), 2), z = side(Vec3::UnitZ(), 3);
  const std::vector<const SideSurface*> two{&x, &y}, three{&x, &y, &z};
  EXPECT_LT((common_point(two, {0, 0, 5}, 10) - Vec3(1, 2, 5)).norm(), 1e-12);
  EXPECT_LT((common_point(three, {0, 0, 5}, 10) - Vec3(1, 2, 3)).norm(), 1e-12);
  // Out of reach: the mean of the feet.
  EXPECT_LT((common_point(two, {0, 0, 5}, 1) - Vec3(0.5, 1, 5)).norm(), 1e-12);
}

/// Two circles of vertices, through which two planes go as well; the edges between them lie on the cylinder.
TEST(SideSurface, MiddlesOfEdgesDecideWhereThePointsDoNot) {
  Points circles, middles;
  for (int i = -8; i <= 8; ++i) {
    const Vec3 low(std::cos(0.1 * i), std::sin(0.1 * i), -1), high(low.x(), low.y(), 1);
    circles.insert(circles.end(), {low, high});
    middles.push_back((low + high) / 2);
  }
  const auto surface = SideSurface::fit(circles, Vec3::UnitX(), 1, SideSurface::Kinds::all, middles);
  ASSERT_TRUE(surface);
  EXPECT_LT(surface->rms(), 1e-9);
  for (const double z : {-0.7, 0.0, 0.4}) {
    const Vec3 foot = surface->foot(Vec3(1.1, 0.1, z));
    EXPECT_NEAR(foot.head<2>().norm(), 1, 1e-6) << z;
    EXPECT_NEAR(foot.z(), z, 1e-6);
  }
}

}  // namespace
}  // namespace loopmend
