// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/zip_boundaries.h"

#include "mesh/boundary_loops.h"
#include "repair/stitch_boundaries.h"
#include "samples/analytic_surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace loopmend {
namespace {

/// Points on two circles, the second run through the other way.
struct TwoCircles {
  Points points;
  std::vector<int> a, b;
};

TwoCircles two_circles(int n, int m, double turn) {
  TwoCircles circles;
  for (int k = 0; k < n; ++k) {
    const double angle = 2 * std::numbers::pi * k / n;
    circles.a.push_back(static_cast<int>(circles.points.size()));
    circles.points.emplace_back(std::cos(angle), std::sin(angle), 0);
  }
  for (int k = 0; k < m; ++k) {
    const double angle = turn - 2 * std::numbers::pi * k / m;
    circles.b.push_back(static_cast<int>(circles.points.size()));
    circles.points.emplace_back(std::cos(angle), std::sin(angle), 0.01);
  }
  return circles;
}

TEST(ZipBoundaries, EveryVertexIsInAPairOrOnAnEdge) {
  for (const auto& [n, m] : {std::pair(24, 24), std::pair(24, 31), std::pair(70, 20), std::pair(5, 30)}) {
    const TwoCircles circles = two_circles(n, m, 0.1);
    const std::optional<ZippedBoundaries> zipped = zip_boundaries(circles.points, circles.a, circles.b);
    ASSERT_TRUE(zipped) << n << " and " << m;
    std::vector<int> seen(circles.points.size(), 0);
    for (const auto& [v, w] : zipped->pairs) {
      ++seen[static_cast<std::size_t>(v)];
      ++seen[static_cast<std::size_t>(w)];
    }
    for (const auto& [ends, on] : zipped->on_edges)
      for (const int v : on) ++seen[static_cast<std::size_t>(v)];
    EXPECT_EQ(seen, std::vector<int>(circles.points.size(), 1)) << n << " and " << m;
  }
}

TEST(ZipBoundaries, OfTenTimesAsManyVerticesThereIsNoMatch) {
  const TwoCircles circles = two_circles(4, 60, 0);
  EXPECT_FALSE(zip_boundaries(circles.points, circles.a, circles.b));
}

/// Half a ball with its boundary scattered. @param sign  1: the upper half
TriangleSoup half_ball(int around, double sign, unsigned seed, double scatter) {
  TriangleSoup half = make_revolution([](double z) { return std::sqrt(1 - z * z); }, 0, 0.5, around, 6);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> noise(-scatter, scatter);
  for (Vec3& p : half.points) {
    if (p.z() == 0) p += Vec3(noise(random), noise(random), noise(random));
    p.z() *= sign;
  }
  if (sign < 0)
    for (Triangle& t : half.triangles) std::swap(t[1], t[2]);
  return half;
}

std::size_t count_of_loops(const TriangleSoup& soup) { return find_boundary_loops(make_surface_model(soup)).size(); }

/// The sides cross to and fro, so that nearest vertices do not pair one by one.
TEST(ZipBoundaries, HalvesWithScatteredBoundariesAreClosedByStitching) {
  for (const auto& [n, m] : {std::pair(48, 48), std::pair(48, 61), std::pair(40, 80)}) {
    const TriangleSoup soup = joined({half_ball(n, 1, 1, 0.02), half_ball(m, -1, 2, 0.02)});
    ASSERT_EQ(count_of_loops(soup), 4U);
    EXPECT_EQ(count_of_loops(stitch_boundaries(make_surface_model(soup), {0.1, 0.08}).soup), 2U) << n << " and " << m;
  }
}

/// Outlines as near to each other, of which the surfaces do not run on towards each other.
TEST(ZipBoundaries, LayersAndShellsStayApart) {
  const TriangleSoup layer = half_ball(48, 1, 1, 0);
  TriangleSoup other = layer;
  for (Vec3& p : other.points) p *= 1.02;
  EXPECT_FALSE(zips_whole_boundaries(make_surface_model(joined({layer, other})), {0.1, 0.05}));
  for (Triangle& t : other.triangles) std::swap(t[1], t[2]);
  EXPECT_FALSE(zips_whole_boundaries(make_surface_model(joined({layer, other})), {0.1, 0.05}));
}

}  // namespace
}  // namespace loopmend
