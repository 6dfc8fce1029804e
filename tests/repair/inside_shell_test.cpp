// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/inside_shell.h"

#include "core/random.h"
#include "samples/analytic_surfaces.h"
#include "support/box.h"

#include <gtest/gtest.h>

#include <cmath>

namespace loopmend {
namespace {

using Place = InsideShell::Place;

InsideShell shell_of(const TriangleSoup& soup, const Vec3& move = Vec3::Zero()) {
  Points corners;
  for (const Triangle& t : soup.triangles)
    for (int v : t) corners.push_back(soup.points[v] + move);
  return InsideShell(std::move(corners));
}

/// Points that are no nearer to the torus than its triangles are: the formula decides.
TEST(InsideShell, KnowsATorusNearAndFarFromTheOrigin) {
  constexpr double major = 2, minor = 0.7;
  const TriangleSoup torus = make_torus(major, minor, 90, 40);
  for (const Vec3& move : {Vec3(0, 0, 0), Vec3(5e5, -3e6, 1e6)}) {
    const InsideShell shell = shell_of(torus, move);
    Random random(7);
    int inside = 0, outside = 0;
    while (inside + outside < 4000) {
      const Vec3 p = Vec3(random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-1, 1));
      const double depth = minor - std::hypot(std::hypot(p.x(), p.y()) - major, p.z());
      if (std::abs(depth) < 0.02) continue;
      ASSERT_EQ(shell.of(p + move), depth > 0 ? Place::inside : Place::outside) << p.transpose();
      ++(depth > 0 ? inside : outside);
    }
    EXPECT_GT(inside, 400);
  }
}

/// Rays that meet an edge or a corner, and points on the surface.
TEST(InsideShell, DecidesExactlyWhereRoundingMight) {
  const InsideShell cube = shell_of(test::box(Vec3(0, 0, 0), Vec3(1, 1, 1)));
  const Vec3 ray(0.3713, 0.2917, 1);
  EXPECT_EQ(cube.of(Vec3(1, 1, 1) - 0.5 * ray), Place::inside);
  EXPECT_EQ(cube.of(Vec3(0, 0, 0) - 0.5 * ray), Place::outside);
  EXPECT_EQ(cube.of(Vec3(1, 0.5, 1) - 0.25 * ray), Place::inside);
  EXPECT_EQ(cube.of(Vec3(0, 0.5, 0) - 0.25 * ray), Place::outside);
  for (const Vec3& p : {Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(0.5, 0.25, 0), Vec3(0.5, 0.25, 1), Vec3(1, 0.25, 0.5),
                        Vec3(0, 0.5, 0.5), Vec3(0.5, 0, 0)})
    EXPECT_EQ(cube.of(p), Place::on_surface) << p.transpose();
}

/// A needle's triangles reach across the whole grid.
TEST(InsideShell, KnowsABodyOfLongTriangles) {
  TriangleSoup needle = make_icosphere(4);
  for (Vec3& p : needle.points) p = Vec3(1000 * p.x(), 1000 * p.x() + p.y(), p.z());
  const InsideShell shell = shell_of(needle);
  for (double x = -990; x < 1000; x += 7.3) {
    EXPECT_EQ(shell.of(Vec3(x, x + 0.001, 0.002)), Place::inside) << x;
    EXPECT_EQ(shell.of(Vec3(x, x + 1.1, 0)), Place::outside) << x;
  }
}

}  // namespace
}  // namespace loopmend
