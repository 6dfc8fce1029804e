// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/stitch_boundaries.h"

#include "core/error.h"
#include "mesh/boundary_loops.h"
#include "samples/analytic_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <random>

namespace loopmend {
namespace {

/// Flat squares of a width, from a corner on.
TriangleSoup tile(double left, double width, int columns, int rows, double height) {
  TriangleSoup soup;
  for (int y = 0; y <= rows; ++y)
    for (int x = 0; x <= columns; ++x) soup.points.emplace_back(left + width * x / columns, height * y / rows, 0);
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      const int a = y * (columns + 1) + x, b = a + 1, c = b + columns + 1, d = a + columns + 1;
      soup.triangles.push_back({a, b, c});
      soup.triangles.push_back({a, c, d});
    }
  return soup;
}

std::vector<BoundaryLoop> loops_of(const TriangleSoup& soup) { return find_boundary_loops(make_surface_model(soup)); }

TEST(StitchBoundaries, LeavesAHoleAndADistantNeighborAlone) {
  const TriangleSoup soup =
      joined({cut(make_icosphere(3), [](const Vec3& p) { return p.z() > 0.8; }), tile(3, 1, 3, 3, 1)});
  const StitchedSurface stitched = stitch_boundaries(make_surface_model(soup));
  EXPECT_EQ(stitched.joined_vertices + stitched.split_faces + stitched.removed_faces, 0u);
  EXPECT_EQ(stitched.soup.triangles, soup.triangles);
}

TEST(StitchBoundaries, ZipsTilesThatNearlyCoincide) {
  TriangleSoup soup = joined({tile(0, 4, 4, 6, 6), tile(4, 4, 4, 6, 6)});
  std::mt19937 random(1);
  std::uniform_real_distribution<double> noise(-0.03, 0.03);
  for (std::size_t v = 35; v < soup.points.size(); ++v)
    soup.points[v] += Vec3(noise(random), noise(random), noise(random));
  ASSERT_EQ(loops_of(soup).size(), 2u);
  const StitchedSurface stitched = stitch_boundaries(make_surface_model(soup));
  EXPECT_EQ(stitched.joined_vertices, 7u);
  EXPECT_EQ(stitched.soup.points, soup.points);
  const auto loops = loops_of(stitched.soup);
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_EQ(loops[0].edges(), 2 * (8 + 6));
}

TEST(StitchBoundaries, SplitsFacesAtJunctions) {
  // The right tile has twice the vertices along the common side.
  const TriangleSoup soup = joined({tile(0, 4, 4, 6, 6), tile(4, 4, 4, 12, 6)});
  const StitchedSurface stitched = stitch_boundaries(make_surface_model(soup));
  EXPECT_EQ(stitched.joined_vertices, 7u);
  EXPECT_EQ(stitched.split_faces, 6u);
  EXPECT_EQ(stitched.soup.triangles.size(), soup.triangles.size() + 6);
  const auto loops = loops_of(stitched.soup);
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_EQ(loops[0].edges(), 8 + 6 + 8 + 12);
}

/// Every vertex of one side lies somewhere on the edges of the other, some of them near a vertex.
TEST(StitchBoundaries, JoinsRowsOfVerticesOfAnyNumbers) {
  for (const auto& [rows, others] : {std::pair(13, 29), std::pair(7, 30), std::pair(24, 25), std::pair(5, 61)}) {
    const TriangleSoup soup = joined({tile(0, 4, 4, rows, 6), tile(4, 4, 4, others, 6)});
    const auto loops = loops_of(stitch_boundaries(make_surface_model(soup)).soup);
    ASSERT_EQ(loops.size(), 1u) << rows << " and " << others;
    EXPECT_EQ(loops[0].edges(), 8 + 8 + rows + others);
  }
}

/// The boundaries of both cross the other's inside and each other: vertices come near edges by chance, and nothing closes.
TEST(StitchBoundaries, LeavesOverlappingTilesAlone) {
  const TriangleSoup soup = joined({tile(0, 4.1, 37, 37, 4), tile(3.3, 4.1, 41, 41, 4.07)});
  const StitchedSurface stitched = stitch_boundaries(make_surface_model(soup));
  EXPECT_FALSE(stitched.any());
  EXPECT_EQ(stitched.soup.triangles, soup.triangles);
  const NearBoundaries near = near_boundaries(make_surface_model(soup));
  EXPECT_EQ(near.vertices + near.faces + near.closing.size(), 0U);
}

/// Triangles of their own, long in one direction: a prism whose corners differ by 1e-4 of its radius.
TEST(StitchBoundaries, JoinsTheTrianglesOfALongThinBody) {
  constexpr int sides = 48;
  constexpr double length = 20;
  const auto corner = [](int k, double z) {
    const double angle = 2 * 3.14159265358979 * k / sides;
    return Vec3(std::cos(angle), std::sin(angle), z);
  };
  std::vector<std::array<Vec3, 3>> faces;
  for (int k = 0; k < sides; ++k) {
    faces.push_back({corner(k, 0), corner(k + 1, 0), corner(k + 1, length)});
    faces.push_back({corner(k, 0), corner(k + 1, length), corner(k, length)});
    faces.push_back({Vec3(0, 0, 0), corner(k + 1, 0), corner(k, 0)});
    faces.push_back({Vec3(0, 0, length), corner(k, length), corner(k + 1, length)});
  }
  std::mt19937 random(3);
  std::uniform_real_distribution<double> noise(-1e-4, 1e-4);
  TriangleSoup soup;
  for (const auto& face : faces) {
    const int first = static_cast<int>(soup.points.size());
    for (const Vec3& p : face) soup.points.push_back(p + Vec3(noise(random), noise(random), noise(random)));
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  const StitchedSurface stitched = stitch_boundaries(make_surface_model(soup));
  EXPECT_EQ(stitched.soup.triangles.size(), faces.size());
  EXPECT_TRUE(loops_of(stitched.soup).empty());
  double volume = 0;
  for (const Triangle& t : stitched.soup.triangles)
    volume += stitched.soup.points[t[0]].dot(stitched.soup.points[t[1]].cross(stitched.soup.points[t[2]])) / 6;
  EXPECT_NEAR(volume, sides / 2.0 * std::sin(2 * 3.14159265358979 / sides) * length, 1e-3 * length);
}

TEST(StitchBoundaries, ClosesATJunctionWhoseEndsAreSharedAlready) {
  // One vertex more on one side of an inner edge: a flat loop of three edges.
  TriangleSoup soup = tile(0, 4, 4, 4, 4);
  const int a = 2 * 5 + 1, b = a + 1, extra = static_cast<int>(soup.points.size());
  soup.points.push_back((soup.points[a] + soup.points[b]) / 2);
  for (Triangle& t : soup.triangles)
    for (int k = 0; k < 3; ++k)
      if (t[k] == a && t[(k + 1) % 3] == b) {
        const int apex = t[(k + 2) % 3];
        t = {a, extra, apex};
        soup.triangles.push_back({extra, b, apex});
        ASSERT_EQ(loops_of(soup).size(), 2u);
        const StitchedSurface stitched = stitch_boundaries(make_surface_model(soup));
        EXPECT_EQ(stitched.split_faces, 1u);
        EXPECT_EQ(loops_of(stitched.soup).size(), 1u);
        return;
      }
  FAIL() << "no such edge";
}

TEST(StitchBoundaries, ASlitIsClosedAndAHoleBesideItStaysOne) {
  // Cut along the equator for half a turn; a cap is missing as well.
  TriangleSoup soup = cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.8; });
  const std::size_t before = soup.points.size();
  std::map<int, int> twin;
  for (std::size_t v = 0; v < before; ++v)
    if (const Vec3 p = soup.points[v]; std::abs(p.z()) < 1e-12 && p.x() > 0.3) {
      twin[static_cast<int>(v)] = static_cast<int>(soup.points.size());
      soup.points.push_back(p);
    }
  ASSERT_GT(twin.size(), 5u);
  for (Triangle& t : soup.triangles) {
    double z = 0;
    for (int v : t) z += soup.points[static_cast<std::size_t>(v)].z();
    for (int& v : t)
      if (z > 0 && twin.contains(v)) v = twin[v];
  }
  const auto open = loops_of(soup);
  const StitchedSurface stitched = stitch_boundaries(make_surface_model(soup));
  const auto loops = loops_of(stitched.soup);
  EXPECT_GE(open.size(), 2u);
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_EQ(loops[0].kind, LoopKind::hole);
  EXPECT_NEAR(loops[0].center.z(), 0.8, 0.05);
}

/// A triangle with two junctions on each of its sides, in a plane of small triangles: closed in one run, without slivers.
TEST(StitchBoundaries, SplitsAFaceAtAllItsSidesAtOnce) {
  constexpr int sides = 3;
  TriangleSoup soup;
  const auto corner = [](int i, int j) { return Vec3(i, j, 0); };  // of a grid, coarse in the middle
  const auto point = [&](int i, int j) {
    const Vec3 p = corner(i, j);
    const auto at = std::find(soup.points.begin(), soup.points.end(), p);
    if (at != soup.points.end()) return static_cast<int>(at - soup.points.begin());
    soup.points.push_back(p);
    return static_cast<int>(soup.points.size()) - 1;
  };
  const auto in_coarse = [&](double x, double y) { return x > 3 && y > 3 && x + y < 6 + sides; };
  for (int j = 0; j < 9; ++j)
    for (int i = 0; i < 9; ++i) {
      if (!in_coarse(i + 1 / 3.0, j + 1 / 3.0))
        soup.triangles.push_back({point(i, j), point(i + 1, j), point(i, j + 1)});
      if (!in_coarse(i + 2 / 3.0, j + 2 / 3.0))
        soup.triangles.push_back({point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)});
    }
  soup.triangles.push_back({point(3, 3), point(3 + sides, 3), point(3, 3 + sides)});
  ASSERT_GT(loops_of(soup).size(), 1u);
  const NearBoundaries near = near_boundaries(make_surface_model(soup));
  EXPECT_EQ(near.vertices, 0u);
  EXPECT_EQ(near.faces, 1u);
  EXPECT_EQ(near.closing.size(), 9u + 3u);
  const StitchedSurface stitched = stitch_boundaries(make_surface_model(soup));
  EXPECT_EQ(stitched.split_faces, 1u);
  EXPECT_EQ(stitched.soup.triangles.size(), soup.triangles.size() + 6);  // nine corners: seven triangles
  const auto loops = loops_of(stitched.soup);
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_EQ(loops[0].edges(), 4 * 9);
  double area = 0;
  for (const Triangle& t : stitched.soup.triangles) {
    const Vec3 &a = stitched.soup.points[t[0]], &b = stitched.soup.points[t[1]], &c = stitched.soup.points[t[2]];
    EXPECT_GE((b - a).cross(c - a).z(), 1 - 1e-12);
    area += (b - a).cross(c - a).z() / 2;
  }
  EXPECT_NEAR(area, 81, 1e-12);
}

/// Two balls, mirror images of each other, that share an edge; in each a hole begins at one end of it.
TriangleSoup touching_balls(int level) {
  const TriangleSoup ball = make_icosphere(level);
  const Triangle shared = ball.triangles.front();
  const int a = shared[0], b = shared[1];
  const auto is_beside = [&](int v, int w) {
    return std::ranges::any_of(ball.triangles, [&](const Triangle& t) {
      return std::ranges::count(t, v) > 0 && std::ranges::count(t, w) > 0;
    });
  };
  int middle = 0;  // of the hole: beside a, and not beside b
  while (middle == a || !is_beside(middle, a) || is_beside(middle, b)) ++middle;
  const Vec3 along = (ball.points[b] - ball.points[a]).normalized(), center = (ball.points[a] + ball.points[b]) / 2;
  const Vec3 across = (center - along.dot(center) * along).normalized();
  TriangleSoup soup;
  soup.points = ball.points;
  const int count = static_cast<int>(ball.points.size());
  for (const Vec3& p : ball.points) soup.points.push_back(p - 2 * across.dot(p - center) * across);
  const auto mirrored = [&](int v) { return v == a || v == b ? v : v + count; };
  for (const Triangle& t : ball.triangles) {
    if (std::ranges::count(t, middle) > 0) continue;
    soup.triangles.push_back(t);
    soup.triangles.push_back({mirrored(t[0]), mirrored(t[2]), mirrored(t[1])});
  }
  return soup;
}

TEST(StitchBoundaries, BodiesThatTouchStayApart) {
  for (const int level : {3, 4}) {
    const SurfaceModel model = make_surface_model(touching_balls(level));
    ASSERT_EQ(find_boundary_loops(model).size(), 2u);
    EXPECT_TRUE(near_boundaries(model).closing.empty());
    EXPECT_FALSE(stitch_boundaries(model).any());
  }
}

/// The edges of spikes at missing data are long, and tell nothing of which vertices are near.
TEST(StitchBoundaries, SpikesDoNotJoinTheOutlineBesideThem) {
  TriangleSoup soup = tile(0, 20, 20, 20, 20);
  for (const int x : {5, 7, 9, 11}) soup.points[static_cast<std::size_t>(x)].z() = -9999;
  const SurfaceModel model = make_surface_model(soup);
  EXPECT_EQ(near_boundaries(model).vertices, 0u);
  EXPECT_FALSE(stitch_boundaries(model).any());
}

TEST(StitchBoundaries, TakesALengthOrAPartOfTheEdges) {
  // Tiles with a gap of 0.3 between them; edges of 1.
  const TriangleSoup soup = joined({tile(0, 4, 4, 6, 6), tile(4.3, 4, 4, 6, 6)});
  const SurfaceModel model = make_surface_model(soup);
  EXPECT_FALSE(stitch_boundaries(model).any());
  EXPECT_EQ(stitch_boundaries(model, {0.35, std::nullopt}).joined_vertices, 7u);
  EXPECT_EQ(stitch_boundaries(model, {0.1, 0.31}).joined_vertices, 7u);
  EXPECT_FALSE(stitch_boundaries(model, {0.1, 0.29}).any());
  EXPECT_FALSE(stitch_boundaries(model, {0.25, std::nullopt}).any());
  EXPECT_EQ(near_boundaries(model).closing.size(), 0u);
  EXPECT_EQ(near_boundaries(model, {0.1, 0.31}).closing.size(), 12u);
  EXPECT_EQ(near_boundaries(model, {0.1, 0.31}).vertices, 7u);
}

/// Boundaries at which a view ends are none.
TEST(StitchBoundaries, FindsTheSameInAViewAroundTheLoops) {
  TriangleSoup soup = joined({tile(0, 20, 20, 20, 20), tile(20.02, 20, 20, 20, 20)});
  const NearBoundaries whole = near_boundaries(make_surface_model(soup));
  const SurfaceModel view = make_view_around_loops(soup, {});
  ASSERT_LT(view.mesh.n_faces(), soup.triangles.size());
  const NearBoundaries around = near_boundaries(view);
  EXPECT_EQ(whole.vertices, 21u);
  EXPECT_EQ(around.vertices, whole.vertices);
  EXPECT_EQ(around.closing, whole.closing);
  int closing = 0;
  for (const BoundaryLoop& loop : find_boundary_loops(view)) closing += closing_edges(view, loop, around);
  EXPECT_EQ(closing, 40);
}

TEST(StitchBoundaries, RefusesATolerance) {
  const SurfaceModel model = make_surface_model(tile(0, 1, 1, 1, 1));
  for (double wrong : {-0.1, 0.5}) EXPECT_THROW(stitch_boundaries(model, {wrong, std::nullopt}), InvalidArgument);
  EXPECT_THROW(stitch_boundaries(model, {0.1, -1.0}), InvalidArgument);
}

}  // namespace
}  // namespace loopmend
