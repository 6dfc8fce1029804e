// SPDX-License-Identifier: GPL-3.0-or-later
// Polygons into triangles: inside the polygon, oriented like it, always size - 2 of them.
#include "mesh/triangulate_polygon.h"

#include <gtest/gtest.h>
#include "support/processor_time.h"

#include <Eigen/Geometry>
#include <array>

#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

namespace loopmend {
namespace {

Triangles triangulate(const Points& points, std::vector<int> polygon = {}) {
  if (polygon.empty()) {
    polygon.resize(points.size());
    std::iota(polygon.begin(), polygon.end(), 0);
  }
  Triangles triangles;
  triangulate_polygon(points, polygon, triangles);
  EXPECT_EQ(triangles.size(), polygon.size() - 2);
  return triangles;
}

Vec3 area_vector(const Points& points, const Triangle& t) {
  const Vec3& a = points[t[0]];
  return 0.5 * (points[t[1]] - a).cross(points[t[2]] - a);
}

/// Inside and oriented alike: no triangle is turned over, and the areas add up.
void expect_covers(const Points& points, const Triangles& triangles, const Vec3& area) {
  Vec3 sum = Vec3::Zero();
  for (const Triangle& t : triangles) {
    sum += area_vector(points, t);
    EXPECT_GT(area_vector(points, t).dot(area), 0.0);
  }
  EXPECT_NEAR((sum - area).norm(), 0.0, 1e-12 * area.norm());
}

TEST(TriangulatePolygon, QuadTakesTheShorterDiagonal) {
  EXPECT_EQ(triangulate({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), (Triangles{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(triangulate({{0, 0, 0}, {2, -1, 0}, {4, 0, 0}, {2, 1, 0}}), (Triangles{{0, 1, 3}, {1, 2, 3}}));
}

TEST(TriangulatePolygon, ConcaveQuadTakesTheDiagonalInside) {
  const Points dart = {
      {0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}};  // reflex at vertex 2, the longer diagonal is inside
  expect_covers(dart, triangulate(dart), {0, 0, 4});
  for (int turn = 1; turn < 4; ++turn) {
    std::vector<int> polygon;
    polygon.reserve(4);
    for (int i = 0; i < 4; ++i) polygon.push_back((i + turn) % 4);
    expect_covers(dart, triangulate(dart, polygon), {0, 0, 4});
  }
}

TEST(TriangulatePolygon, ConcavePolygonInEveryPlaneAndDirection) {
  const double xs[] = {0, 4, 4, 3, 3, 1, 1, 0};  // the letter U
  const double ys[] = {0, 0, 3, 3, 1, 1, 3, 3};
  for (int plane = 0; plane < 3; ++plane) {
    for (const bool reversed : {false, true}) {
      Points points;
      for (int i = 0; i < 8; ++i) {
        const int k = reversed ? 7 - i : i;
        Vec3 p(0, 0, 0.1);
        p[plane] = xs[k];
        p[(plane + 1) % 3] = ys[k];
        p[(plane + 2) % 3] = 0.3 * xs[k] - 0.2 * ys[k];
        points.push_back(p);
      }
      Vec3 area = Vec3::Zero();
      for (std::size_t i = 0; i < 8; ++i) area += 0.5 * points[i].cross(points[(i + 1) % 8]);
      expect_covers(points, triangulate(points), area);
    }
  }
}

TEST(TriangulatePolygon, HoleJoinedByADoubleEdge) {
  const Points points = {{0, 0, 0}, {6, 0, 0}, {6, 6, 0}, {0, 6, 0}, {2, 2, 0}, {2, 4, 0}, {4, 4, 0}, {4, 2, 0}};
  const Triangles triangles = triangulate(points, {0, 1, 2, 3, 0, 4, 5, 6, 7, 4});
  expect_covers(points, triangles, {0, 0, 32});
}

TEST(TriangulatePolygon, CornersInTheMiddleOfAnEdge) {
  const Points points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}};
  expect_covers(points, triangulate(points), {0, 0, 4});
}

TEST(TriangulatePolygon, DegenerateOnesStillGiveTheirNumberOfTriangles) {
  triangulate({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}});             // on a line
  triangulate({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}});  // at one place
  triangulate({{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}, {-1, 1, 0}});            // crosses itself
  triangulate({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2, 0, 1, 2, 0, 0});         // vertices again and again
  triangulate({{0, 0, 0}, {1e308, 0, 0}, {1e308, 1e308, 0}, {0, 1e308, 1e308}, {-1e308, 5, 5}});
  triangulate({{0, 0, 0}, {1e-320, 0, 0}, {1e-320, 1e-320, 0}, {0, 1e-320, 0}, {-1e-320, 0, 0}});
}

TEST(TriangulatePolygon, LargePolygonsDoNotTakeForEver) {
  const double start = test::processor_seconds();
  Points star;
  for (int i = 0; i < 20000; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 20000;
    star.push_back((i % 2 == 0 ? 1.0 : 0.5) * Vec3(std::cos(angle), std::sin(angle), 0.0));
  }
  triangulate(star);
  std::vector<int> knot;
  knot.reserve(20000);
  for (int i = 0; i < 20000; ++i) knot.push_back((i * 7919) % 20000);
  triangulate(star, knot);
  EXPECT_LT(test::processor_seconds() - start, 10);
}

/// Beyond some thousand corners they are inserted in another order; the triangles are those of the polygon all the same.
TEST(TriangulatePolygon, LargeOutlines) {
  constexpr int size = 20'000;
  Points points;
  std::vector<int> polygon;
  for (int k = 0; k < size; ++k) {
    const double angle = 2 * std::numbers::pi * k / size, radius = 1 + 0.3 * std::sin(12 * angle);
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                        0.1 * angle * (2 * std::numbers::pi - angle));
    polygon.push_back(k);
  }
  Triangles triangles;
  triangulate_polygon(points, polygon, triangles);
  ASSERT_EQ(triangles.size(), static_cast<std::size_t>(size) - 2);
  double area = 0;  // seen from above: r² / 2 over the angle is π (1 + 0.3² / 2)
  for (const Triangle& t : triangles) {
    const double part = (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]).z() / 2;
    EXPECT_GE(part, 0);
    area += part;
  }
  EXPECT_NEAR(area, std::numbers::pi * 1.045, 1e-5);
}

TEST(TriangulateSeenFlat, AnArrowhead) {
  const Points points = {{0, 0, 0}, {2, 2, 0.1}, {0, 1, 0}, {-2, 2, 0.1}};
  EXPECT_EQ(triangulate_seen_flat(points, std::array{0, 1, 2, 3}), (Triangles{{0, 1, 2}, {0, 2, 3}}));
}

TEST(TriangulateSeenFlat, NoneWhereThePolygonCrossesOrTouchesItself) {
  const Points crossing = {{0, 0, 0}, {3, 0, 0}, {0, 1, 0}, {3, 2, 0}};
  EXPECT_TRUE(triangulate_seen_flat(crossing, std::array{0, 1, 2, 3}).empty());
  const Points touching = {{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0}};
  EXPECT_TRUE(triangulate_seen_flat(touching, std::array{0, 1, 2, 3, 4, 5}).empty());
}

}  // namespace
}  // namespace loopmend
