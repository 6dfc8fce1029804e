// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/rounding_cracks.h"

#include "repair/watertight.h"
#include "samples/analytic_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <random>

namespace loopmend {
namespace {

JoinedCracks join_cracks(TriangleSoup& soup) {
  return join_rounding_cracks(soup, survey_vertices(soup.triangles, soup.points.size()));
}

/// The faces above the equator get vertices of their own there, each moved. @returns how many.
std::size_t tear(TriangleSoup& soup, const std::function<Vec3()>& move) {
  std::map<int, int> twin;
  for (Triangle& t : soup.triangles) {
    double height = 0;
    for (int v : t) height += soup.points[v].z();
    for (int& v : t) {
      if (height < 0 || std::abs(soup.points[v].z()) > 1e-9) continue;
      const auto [at, is_new] = twin.emplace(v, static_cast<int>(soup.points.size()));
      if (is_new) soup.points.push_back(soup.points[v] + move());
      v = at->second;
    }
  }
  return twin.size();
}

TEST(RoundingCracks, AreClosedAllRoundABall) {
  TriangleSoup soup = make_icosphere(4);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> noise(-5e-7, 5e-7);
  const std::size_t points = soup.points.size();
  const std::size_t count = tear(soup, [&] { return Vec3(noise(random), noise(random), noise(random)); });
  ASSERT_GT(count, 40U);
  ASSERT_GT(watertightness(soup).open_edges, 80U);
  const Points before = soup.points;
  const JoinedCracks cracks = join_cracks(soup);
  EXPECT_EQ(cracks.vertices, count);
  EXPECT_GT(cracks.largest, 5e-7);
  EXPECT_LT(cracks.largest, 9e-7);
  EXPECT_EQ(soup.points, before);
  for (std::size_t v = points; v < before.size(); ++v) EXPECT_LT(cracks.first[v], static_cast<int>(points));
  TriangleSoup of_one_piece = make_icosphere(4);
  EXPECT_EQ(soup.triangles, of_one_piece.triangles);
}

/// Each face of a ball far from the origin has corners of its own, rounded to single precision and moved by a unit in the last place.
TriangleSoup far_ball(const Vec3& center, double radius, double moved_by) {
  TriangleSoup ball = make_icosphere(3), torn;
  std::mt19937 random(1);
  std::uniform_int_distribution<int> units(-1, 1);
  for (const Triangle& t : ball.triangles) {
    Triangle own{};
    for (std::size_t k = 0; k < 3; ++k) {
      Vec3 p = center + radius * ball.points[static_cast<std::size_t>(t[k])];
      for (double& x : p) {
        const auto rounded = static_cast<float>(x);
        const double unit = static_cast<double>(std::nextafter(std::abs(rounded), 1e30F)) - std::abs(rounded);
        x = static_cast<double>(rounded) + moved_by * units(random) * unit;
      }
      const auto same = std::find(torn.points.begin(), torn.points.end(), p);
      own[k] = static_cast<int>(same - torn.points.begin());
      if (same == torn.points.end()) torn.points.push_back(p);
    }
    torn.triangles.push_back(own);
  }
  return torn;
}

/// At 100 000 a unit in the last place is 0.008 or 0.016, a tenth of some of these edges.
TEST(RoundingCracks, AreClosedFarFromTheOriginWhereTheLastPlacesAreNoSmallPartOfTheEdges) {
  TriangleSoup soup = far_ball({1e5, 2e5, 0}, 3, 1);
  ASSERT_GT(watertightness(soup).open_edges, 1000U);
  join_cracks(soup);
  EXPECT_EQ(watertightness(soup).open_edges, 0U);
  EXPECT_NEAR(watertightness(soup).volume, 4.0 / 3 * 3.14159265 * 27, 4);
}

/// The same distances between coordinates of double precision are no rounding.
TEST(RoundingCracks, StayWhereTheLastPlacesOfSinglePrecisionAreNotTheLast) {
  TriangleSoup soup = far_ball({1e5, 2e5, 0}, 3, 0.8);
  const std::size_t open = watertightness(soup).open_edges;
  join_cracks(soup);
  EXPECT_GT(watertightness(soup).open_edges, open / 2);
}

TEST(RoundingCracks, ZeroBesideANumberThatShouldBeZero) {
  TriangleSoup soup = make_icosphere(3);
  tear(soup, [] { return Vec3(0, 0, 6e-17); });
  EXPECT_GT(join_cracks(soup).vertices, 0U);
  EXPECT_EQ(watertightness(soup).open_edges, 0U);
}

/// A crack wider than rounding, rounding of a much larger part, and far from the origin.
TEST(RoundingCracks, AreMeasuredByTheSizeOfTheMesh) {
  for (const double size : {1e-3, 1.0, 1e5}) {
    TriangleSoup soup = make_icosphere(3);
    tear(soup, [] { return Vec3(0, 0, 1e-5); });
    for (Vec3& p : soup.points) p *= size;
    EXPECT_EQ(join_cracks(soup).vertices, 0U) << size;
    soup = make_icosphere(3);
    tear(soup, [] { return Vec3(0, 0, 1e-6); });
    for (Vec3& p : soup.points) p *= size;
    EXPECT_GT(join_cracks(soup).vertices, 0U) << size;
  }
  TriangleSoup far = make_icosphere(3);
  tear(far, [] { return Vec3(0, 0, 5e-4); });
  for (Vec3& p : far.points) p.x() += 1e3;
  EXPECT_GT(join_cracks(far).vertices, 0U);
}

TEST(RoundingCracks, LeaveHolesAndFineDetail) {
  TriangleSoup open = cut(make_icosphere(3), [](const Vec3& p) { return p.z() > 0.8; });
  EXPECT_EQ(join_cracks(open).vertices, 0U);
  // Cracks far below a millionth of the size of the whole: by their own edges, one is rounding and the other is not.
  TriangleSoup fine = make_icosphere(3);
  tear(fine, [] { return Vec3(0, 0, 1e-6); });
  for (Vec3& p : fine.points) p *= 1e-5;
  const int first = static_cast<int>(fine.points.size());
  for (const Vec3& p : {Vec3(0, 0, 100), Vec3(1, 0, 100), Vec3(0, 1, 100)}) fine.points.push_back(p);
  fine.triangles.push_back({first, first + 1, first + 2});
  EXPECT_GT(join_cracks(fine).vertices, 0U) << "1e-11 beside edges of 1e-6";
  TriangleSoup as_fine = make_icosphere(3);
  tear(as_fine, [] { return Vec3(0, 0, 0.01); });
  const std::size_t faces = as_fine.triangles.size();
  as_fine.points.emplace_back(0, 0, 1e6);
  as_fine.points.emplace_back(1, 0, 1e6);
  as_fine.points.emplace_back(0, 1, 1e6);
  const int last = static_cast<int>(as_fine.points.size()) - 1;
  as_fine.triangles.push_back({last - 2, last - 1, last});
  EXPECT_EQ(join_cracks(as_fine).vertices, 0U) << "0.01 is no rounding of edges of 0.15";
  EXPECT_EQ(as_fine.triangles.size(), faces + 1);
}

/// Three sheets whose edges lie within rounding: no two of them belong together more than the others.
TEST(RoundingCracks, NoEdgeGetsAThirdFace) {
  TriangleSoup soup;
  for (const double angle : {0.0, 2.0, 4.0}) {
    const int first = static_cast<int>(soup.points.size());
    soup.points.emplace_back(1e-7 * angle, 0, 0);
    soup.points.emplace_back(1e-7 * angle, 0, 1);
    soup.points.emplace_back(std::cos(angle), std::sin(angle), 0.5);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  const Triangles before = soup.triangles;
  EXPECT_EQ(join_cracks(soup).vertices, 0U);
  EXPECT_EQ(soup.triangles, before);
  soup.triangles.pop_back();
  EXPECT_EQ(join_cracks(soup).vertices, 2U);
}

TEST(RoundingCracks, NoFaceIsDoubled) {
  TriangleSoup soup;
  for (const double height : {0.0, 1e-7}) {
    const int first = static_cast<int>(soup.points.size());
    for (const Vec3& p : {Vec3(0, 0, height), Vec3(1, 0, height), Vec3(0, 1, height)}) soup.points.push_back(p);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  EXPECT_EQ(join_cracks(soup).vertices, 0U);
}

/// Two triangles that touch at their tips close nothing.
TEST(RoundingCracks, WhatOnlyTouchesStaysApart) {
  TriangleSoup soup;
  soup.points = {{0, 0, 0}, {1, 1, 0}, {1, -1, 0}, {-1e-8, 0, 0}, {-1, 1, 0}, {-1, -1, 0}};
  soup.triangles = {{0, 2, 1}, {3, 4, 5}};
  EXPECT_EQ(join_cracks(soup).vertices, 0U);
}

}  // namespace
}  // namespace loopmend
