// SPDX-License-Identifier: GPL-3.0-or-later
#include "texture/chart.h"

#include "samples/analytic_surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace loopmend {
namespace {

/// A quarter of a tube can be unrolled: lengths stay.
TEST(Chart, UnrollsWhatCanBeUnrolled) {
  TriangleSoup soup = make_graph([](double, double) { return 0; }, 1, 16);
  Points flat = soup.points;
  for (Vec3& p : soup.points) p = Vec3(std::sin(p.x()), p.y(), std::cos(p.x()));
  const auto chart = flatten(soup.points, soup.triangles, soup.triangles.size());
  ASSERT_TRUE(chart);
  for (const Triangle& t : soup.triangles)
    for (int k = 0; k < 3; ++k) {
      const double length = ((*chart)[t[k]] - (*chart)[t[(k + 1) % 3]]).norm();
      EXPECT_NEAR(length, (flat[t[k]] - flat[t[(k + 1) % 3]]).norm(), 0.002);
    }
}

/// The conformal map of half a sphere is the stereographic one: no triangle is turned round, angles stay.
TEST(Chart, KeepsAnglesOfHalfASphere) {
  const TriangleSoup soup = cut(make_icosphere(4), [](const Vec3& p) { return p.z() < 0; });
  const auto chart = flatten(soup.points, soup.triangles, soup.triangles.size());
  ASSERT_TRUE(chart);
  double worst = 0, area = 0;
  for (const Triangle& t : soup.triangles) {
    const Vec2 u = (*chart)[t[1]] - (*chart)[t[0]], v = (*chart)[t[2]] - (*chart)[t[0]];
    const Vec3 a = soup.points[t[1]] - soup.points[t[0]], b = soup.points[t[2]] - soup.points[t[0]];
    worst = std::max(
        worst, std::abs(std::acos(u.normalized().dot(v.normalized())) - std::acos(a.normalized().dot(b.normalized()))));
    area += (u.x() * v.y() - u.y() * v.x()) / 2;
  }
  EXPECT_LT(worst, 0.08) << "radians; measured: 0.063";
  EXPECT_NEAR(area, 2 * std::numbers::pi, 0.2);
}

TEST(Chart, WhatIsClosedHasNone) {
  const TriangleSoup ball = make_icosphere(2);
  EXPECT_FALSE(flatten(ball.points, ball.triangles, ball.triangles.size()));
}

}  // namespace
}  // namespace loopmend
