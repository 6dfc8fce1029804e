// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/minimum_weight_triangulation.h"
#include "filling/sorted_triangles.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <utility>

namespace loopmend {
namespace {

/// A wavy ring with a collar of triangles that leave it at all angles.
OpenLoop wavy_loop(int n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> wave(-0.4, 0.4);
  OpenLoop loop;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    loop.points.emplace_back((1 + wave(random)) * std::cos(angle), (1 + wave(random)) * std::sin(angle), wave(random));
  }
  for (int i = 0; i < n; ++i) {
    const Vec3 middle = (loop.points[i] + loop.points[(i + 1) % n]) / 2;
    loop.across.push_back(1.5 * middle + Vec3(0, 0, wave(random)));
  }
  return loop;
}

/// By CGAL, whose search is the same but measures every triangle. It knows of no chords that are present.
Triangles triangulation_by_cgal(const OpenLoop& loop) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  std::vector<Point> points, across;
  for (const Vec3& p : loop.points) points.emplace_back(p.x(), p.y(), p.z());
  for (const Vec3& p : loop.across) across.emplace_back(p.x(), p.y(), p.z());
  std::vector<CGAL::Triple<int, int, int>> found;
  CGAL::Polygon_mesh_processing::triangulate_hole_polyline(
      points, across, std::back_inserter(found),
      CGAL::parameters::use_delaunay_triangulation(false).use_2d_constrained_delaunay_triangulation(false));
  Triangles triangles;
  for (const auto& t : found) triangles.push_back({t.first, t.second, t.third});
  return triangles;
}

TEST(LeastFolded, FindsWhatCgalFinds) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    const OpenLoop loop = wavy_loop(4 + static_cast<int>(seed), seed);
    const Triangles found = minimum_weight_triangulation(loop);
    ASSERT_EQ(found.size() + 2, loop.points.size());
    EXPECT_EQ(sorted(found), sorted(triangulation_by_cgal(loop))) << "seed " << seed;
  }
}

TEST(LeastFolded, OfEqualsTooAndWithPointsInOneLine) {
  OpenLoop square;  // flat: all dihedrals are equal, and the area of all triangulations is the same
  for (int side = 0; side < 4; ++side)
    for (int k = 0; k < 6; ++k) {
      const Vec3 along(k / 6.0, 0, 0);
      square.points.push_back(Eigen::AngleAxisd(side * std::numbers::pi / 2, Vec3::UnitZ()) *
                              (along - Vec3(0.5, 0.5, 0)));
    }
  for (const Vec3& p : square.points) square.across.push_back(2 * p);
  ASSERT_EQ(minimum_weight_triangulation(square).size(), 22u);
  EXPECT_EQ(sorted(minimum_weight_triangulation(square)), sorted(triangulation_by_cgal(square)));
  for (Vec3& p : square.points) p = p.array().round();
  EXPECT_EQ(sorted(minimum_weight_triangulation(square)), sorted(triangulation_by_cgal(square)));
}

TEST(LeastFolded, WindsLikeTheLoop) {
  for (int n : {3, 4, 12, 60}) {
    const Triangles found = minimum_weight_triangulation(wavy_loop(n, 2));
    ASSERT_EQ(found.size(), static_cast<std::size_t>(n - 2));
    std::map<std::pair<int, int>, int> edges;
    for (const Triangle& t : found)
      for (int k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
    EXPECT_EQ(edges.size(), 3 * found.size()) << "a directed edge twice";
    for (int i = 0; i < n; ++i) EXPECT_TRUE(edges.contains({i, (i + 1) % n})) << n << ": edge " << i;
  }
}

TEST(LeastFolded, ChordsThatArePresentAreNotMade) {
  OpenLoop loop = wavy_loop(9, 1);
  const auto chords = [&] {
    std::set<std::pair<int, int>> result;
    for (const Triangle& t : minimum_weight_triangulation(loop))
      for (int k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax(t[k], t[(k + 1) % 3]);
        if (high > low + 1 && high - low < 8) result.insert({low, high});
      }
    return result;
  };
  loop.present = chords();
  ASSERT_EQ(loop.present.size(), 6u);
  for (const auto& chord : chords()) EXPECT_EQ(loop.present.count(chord), 0u);
  // With all of them there is no way.
  for (int i = 0; i < 9; ++i)
    for (int k = i + 2; k < 9; ++k) loop.present.insert({i, k});
  EXPECT_TRUE(chords().empty());
}

}  // namespace
}  // namespace loopmend
