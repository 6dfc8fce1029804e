// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/watertight.h"

#include "samples/analytic_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace loopmend {
namespace {

using Words = std::vector<std::string>;

TriangleSoup moved(TriangleSoup soup, const Vec3& by) {
  for (Vec3& p : soup.points) p += by;
  return soup;
}

TEST(Watertight, SphereIsPrintableAndItsVolumeIsKnown) {
  const TriangleSoup sphere = make_icosphere(4);
  const Watertightness found = watertightness(sphere);
  EXPECT_TRUE(found.printable());
  EXPECT_EQ(faults(found), Words());
  EXPECT_EQ(found.pieces, 1u);
  EXPECT_NEAR(found.volume, 4 * std::numbers::pi / 3, 0.02);
  EXPECT_NEAR(watertightness(moved(sphere, Vec3(1e6, 0, 0))).volume, found.volume, 1e-6);
}

TEST(Watertight, EveryTriangleWithItsOwnCornersIsTheSameSurface) {
  const TriangleSoup sphere = make_icosphere(2);
  TriangleSoup apart;
  for (const Triangle& t : sphere.triangles) {
    const int first = static_cast<int>(apart.points.size());
    for (int v : t) apart.points.push_back(sphere.points[v]);
    apart.triangles.push_back({first, first + 1, first + 2});
  }
  EXPECT_TRUE(watertightness(apart).printable());
  EXPECT_EQ(watertightness(apart).pieces, 1u);
}

/// The volume of both is positive.
TEST(Watertight, OneOfTwoBodiesInsideOutIsNotReadyToPrint) {
  TriangleSoup small = moved(make_icosphere(2), Vec3(5, 0, 0));
  for (Vec3& p : small.points) p *= 0.5;
  for (Triangle& t : small.triangles) std::swap(t[1], t[2]);
  const Watertightness found = watertightness(joined({make_icosphere(2), small}));
  EXPECT_GT(found.volume, 0);
  EXPECT_FALSE(found.printable());
  EXPECT_EQ(faults(found), Words{"1 body or cavity that is inside out"});
}

/// Bodies with a common corner are one piece when points in one place are joined.
TEST(Watertight, ABodyInsideOutThatTouchesAnotherIsNotReadyToPrint) {
  const TriangleSoup ball = make_icosphere(2);
  TriangleSoup small = ball;
  for (Vec3& p : small.points) p = 0.5 * p + 1.5 * ball.points[0];
  for (Triangle& t : small.triangles) std::swap(t[1], t[2]);
  for (Vec3& p : small.points)
    if ((p - ball.points[0]).norm() < 1e-12) p = ball.points[0];
  const Watertightness found = watertightness(joined({ball, small}));
  EXPECT_EQ(found.pieces, 1u);
  EXPECT_GT(found.volume, 0);
  EXPECT_EQ(found.inverted_shells, 1u);
  EXPECT_FALSE(found.printable());
}

TEST(Watertight, HolesAreCountedByBoundaries) {
  TriangleSoup sphere = make_icosphere(3);
  sphere = cut(sphere, [](const Vec3& p) { return std::abs(p.z()) > 0.9; });
  const Watertightness found = watertightness(sphere);
  EXPECT_FALSE(found.encloses());
  EXPECT_EQ(found.open_boundaries, 2u);
  EXPECT_EQ(faults(found), Words{"2 open boundaries"});
}

TEST(Watertight, HolesThatTouchAreCountedEach) {
  TriangleSoup sphere = make_icosphere(3);
  const int v = sphere.triangles.front()[0];
  std::vector<std::size_t> around;  // v
  for (std::size_t f = 0; f < sphere.triangles.size(); ++f)
    if (std::find(sphere.triangles[f].begin(), sphere.triangles[f].end(), v) != sphere.triangles[f].end())
      around.push_back(f);
  const Triangle first = sphere.triangles[around.front()];
  const auto shared = [&](std::size_t f) {
    return std::count_if(first.begin(), first.end(), [&](int corner) {
      const Triangle& t = sphere.triangles[f];
      return std::find(t.begin(), t.end(), corner) != t.end();
    });
  };
  const std::size_t second = *std::find_if(around.begin(), around.end(), [&](std::size_t f) { return shared(f) == 1; });
  sphere.triangles.erase(sphere.triangles.begin() + static_cast<std::ptrdiff_t>(std::max(second, around.front())));
  sphere.triangles.erase(sphere.triangles.begin() + static_cast<std::ptrdiff_t>(std::min(second, around.front())));
  const Watertightness found = watertightness(sphere);
  EXPECT_EQ(found.open_edges, 6u);
  EXPECT_EQ(found.open_boundaries, 2u);
}

TEST(Watertight, TriangleTurnedRoundIsFound) {
  TriangleSoup sphere = make_icosphere(2);
  std::swap(sphere.triangles[7][0], sphere.triangles[7][1]);
  const Watertightness found = watertightness(sphere);
  EXPECT_EQ(found.reversed_edges, 3u);
  EXPECT_FALSE(found.printable());
}

TEST(Watertight, SurfaceTurnedInsideOutIsFound) {
  TriangleSoup sphere = make_icosphere(2);
  for (Triangle& t : sphere.triangles) std::swap(t[0], t[1]);
  EXPECT_TRUE(watertightness(sphere).encloses());
  EXPECT_EQ(faults(watertightness(sphere)), Words{"inside out"});
}

TEST(Watertight, FinOnAnEdgeIsNonManifold) {
  TriangleSoup sphere = make_icosphere(2);
  const Triangle t = sphere.triangles.front();
  sphere.points.emplace_back(0, 0, 3);
  sphere.triangles.push_back({t[0], t[1], static_cast<int>(sphere.points.size()) - 1});
  const Watertightness found = watertightness(sphere);
  EXPECT_EQ(found.non_manifold_edges, 1u);
  EXPECT_EQ(found.open_edges, 2u);
  EXPECT_EQ(found.open_boundaries, 1u);
}

TEST(Watertight, BodiesThatTouchAlongAnEdgeAreStillBodies) {
  TriangleSoup both;
  both.points = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}};
  both.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}, {0, 1, 4}, {0, 4, 5}, {0, 5, 1}, {1, 5, 4}};
  const Watertightness found = watertightness(both);
  EXPECT_EQ(found.touching_edges, 1u);
  EXPECT_EQ(found.non_manifold_edges, 0u);
  EXPECT_TRUE(found.encloses());
  EXPECT_EQ(found.intersections, 0u);
}

TEST(Watertight, TwoSpheresThatCutEachOtherIntersect) {
  const TriangleSoup sphere = make_icosphere(2);
  const Watertightness apart = watertightness(joined({sphere, moved(sphere, Vec3(3, 0, 0))}));
  EXPECT_TRUE(apart.printable());
  EXPECT_EQ(apart.pieces, 2u);
  const Watertightness both = watertightness(joined({sphere, moved(sphere, Vec3(1, 0.01, 0.02))}));
  EXPECT_TRUE(both.encloses());
  EXPECT_GT(both.intersections, 20u);
  EXPECT_FALSE(both.printable());
}

TEST(Watertight, TrianglesWithoutThreeCornersAreNotLookedAt) {
  TriangleSoup sphere = make_icosphere(1);
  sphere.triangles.push_back({0, 0, 1});
  EXPECT_TRUE(watertightness(sphere).printable());
}

TEST(Watertight, NothingIsNotPrintable) { EXPECT_FALSE(watertightness({}).printable()); }

TEST(Watertight, CrossingPairsAreCountedUpToAMillion) {
  // 1100 strips one way across 1100 the other way: each cuts each.
  TriangleSoup soup;
  const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    const int first = static_cast<int>(soup.points.size());
    soup.points.insert(soup.points.end(), {a, b, c});
    soup.triangles.push_back({first, first + 1, first + 2});
  };
  const int n = 1100;
  for (int k = 0; k < n; ++k) {
    const double at = (k + 0.5) / n;
    add({at, -1, 0}, {at, 2, 0}, {at + 0.1 / n, -1, 0});
    add({-1, at, -1}, {2, at, -1}, {0.5, at, 4});
  }
  EXPECT_EQ(watertightness(soup).intersections, most_intersections);
  soup.triangles.resize(2 * 20);  // 20 of each
  EXPECT_EQ(watertightness(soup).intersections, 400u);
}

}  // namespace
}  // namespace loopmend
