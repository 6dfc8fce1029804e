// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/plane_cut.h"

#include "core/error.h"
#include "mesh/boundary_loops.h"
#include "mesh/scan_attributes.h"
#include "repair/watertight.h"
#include "samples/analytic_surfaces.h"
#include "support/sharp_surfaces.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

namespace loopmend {
namespace {

using testing::HasSubstr;

const double pi = std::acos(-1.0);

double new_area(const CutSurface& cut, const Vec3& normal) {
  double area = 0;
  const std::size_t first = cut.soup.triangles.size() - cut.counts.new_faces;
  for (std::size_t f = first; f < cut.soup.triangles.size(); ++f) {
    const Triangle& t = cut.soup.triangles[f];
    const Vec3 n = (cut.soup.points[t[1]] - cut.soup.points[t[0]]).cross(cut.soup.points[t[2]] - cut.soup.points[t[0]]);
    EXPECT_GT(n.dot(normal), 0) << "outward";
    area += n.norm() / 2;
  }
  return area;
}

/// The points and whole faces that stay come first, in their order and bit by bit.
void expect_kept(const CutSurface& cut, const TriangleSoup& given, const CutPlane& plane) {
  std::vector<Vec3> stay;
  std::vector<char> is_used(given.points.size(), 0);
  for (const Triangle& t : given.triangles)
    for (int v : t) is_used[v] = 1;
  for (std::size_t v = 0; v < given.points.size(); ++v)
    if (is_used[v] && (given.points[v] - plane.point).dot(plane.normal) < 0) stay.push_back(given.points[v]);
  ASSERT_LE(stay.size(), cut.soup.points.size());
  EXPECT_TRUE(std::equal(stay.begin(), stay.end(), cut.soup.points.begin()));
  for (std::size_t v = stay.size(); v < cut.soup.points.size(); ++v)
    ASSERT_NEAR((cut.soup.points[v] - plane.point).dot(plane.normal), 0, 1e-12);
}

TEST(PlaneCut, ACubeKeepsTheVolumeBehindThePlane) {
  for (const double height : {0.3, 0.25, 0.5}) {  // the last two through vertices of the grid
    const TriangleSoup cube = test::make_cube(4);
    const CutPlane plane = make_cut_plane({5, 7, height}, {0, 0, 3});
    const CutSurface cut = cut_by_plane(cube, plane);
    const Watertightness found = watertightness(cut.soup);
    EXPECT_TRUE(found.printable()) << height;
    const Watertightness whole = watertightness(cube);
    const double low = -std::min_element(cube.points.begin(), cube.points.end(), [](const Vec3& a, const Vec3& b) {
                          return a.z() < b.z();
                        })->z();
    const double side = std::cbrt(whole.volume);
    EXPECT_NEAR(found.volume, side * side * (height + low), 1e-12);
    EXPECT_NEAR(new_area(cut, plane.normal), side * side, 1e-12);
    EXPECT_EQ(cut.counts.closed, 1U);
    EXPECT_EQ(cut.counts.left_open, 0U);
  }
}

TEST(PlaneCut, ObliquePartsOfACubeAddUp) {
  const TriangleSoup cube = test::make_cube(5);
  const double volume = watertightness(cube).volume;
  std::mt19937 random(3);
  std::normal_distribution<double> any(0, 1);
  Vec3 middle = Vec3::Zero();
  for (const Vec3& p : cube.points) middle += p / static_cast<double>(cube.points.size());
  for (int k = 0; k < 20; ++k) {
    const Vec3 normal(any(random), any(random), any(random));
    const Vec3 point = middle + 0.1 * Vec3(any(random), any(random), any(random));
    const CutSurface one = cut_by_plane(cube, make_cut_plane(point, normal));
    const CutSurface other = cut_by_plane(cube, make_cut_plane(point, -normal));
    EXPECT_EQ(watertightness(one.soup).open_edges, 0U);
    EXPECT_NEAR(watertightness(one.soup).volume + watertightness(other.soup).volume, volume, 1e-11);
    EXPECT_NEAR(new_area(one, normal), new_area(other, -normal), 1e-12);
  }
}

TEST(PlaneCut, ASphereLosesItsCap) {
  const TriangleSoup ball = make_icosphere(5);
  const CutPlane plane = make_cut_plane({0.1, 0, 0.4}, {0, 0, 1});
  const CutSurface cut = cut_by_plane(ball, plane);
  const Watertightness found = watertightness(cut.soup);
  EXPECT_TRUE(found.printable());
  const double cap = pi * 0.6 * 0.6 * (3 - 0.6) / 3, error = 4 * pi / 3 - watertightness(ball).volume;
  EXPECT_NEAR(found.volume, 4 * pi / 3 - cap, error);
  EXPECT_NEAR(new_area(cut, plane.normal), pi * (1 - 0.16), error);
  expect_kept(cut, ball, plane);
}

/// A pipe's wall: an outer tube, an inner one that looks inward, and both ends as rings.
TriangleSoup pipe(int n) {
  TriangleSoup soup;
  for (const double radius : {1.0, 0.6})
    for (const double z : {-1.0, 1.0})
      for (int k = 0; k < n; ++k)
        soup.points.emplace_back(radius * std::cos(2 * pi * k / n), radius * std::sin(2 * pi * k / n), z);
  const auto quads = [&](int from, int to) {
    for (int k = 0; k < n; ++k) {
      const int next = (k + 1) % n;
      soup.triangles.push_back({from + k, from + next, to + next});
      soup.triangles.push_back({from + k, to + next, to + k});
    }
  };
  quads(0, n);          // outer wall, upwards
  quads(3 * n, 2 * n);  // inner wall, downwards
  quads(n, 3 * n);      // upper end
  quads(2 * n, 0);      // lower end
  return soup;
}

TEST(PlaneCut, ATubeIsClosedByARing) {
  const int n = 48;
  const TriangleSoup tube = pipe(n);
  const double ring = n / 2.0 * std::sin(2 * pi / n) * (1 - 0.36);
  ASSERT_NEAR(watertightness(tube).volume, 2 * ring, 1e-12);
  const CutSurface cut = cut_by_plane(tube, make_cut_plane({0, 0, 0.25}, {0, 0, 1}));
  EXPECT_EQ(cut.counts.closed, 2U);
  EXPECT_TRUE(watertightness(cut.soup).printable());
  EXPECT_NEAR(watertightness(cut.soup).volume, 1.25 * ring, 1e-12);
  EXPECT_NEAR(new_area(cut, Vec3::UnitZ()), ring, 1e-12);
  // Along its axis: two rectangles of the wall.
  const CutSurface half = cut_by_plane(tube, make_cut_plane({0, 0.01, 0}, {0, 1, 0}));
  EXPECT_EQ(half.counts.closed, 2U);
  EXPECT_TRUE(watertightness(half.soup).printable());
}

TEST(PlaneCut, AHollowBallIsClosedByARing) {
  TriangleSoup ball = make_icosphere(3), cavity = make_icosphere(3);
  for (Vec3& p : cavity.points) p *= 0.5;
  for (Triangle& t : cavity.triangles) std::swap(t[1], t[2]);
  const CutSurface cut = cut_by_plane(joined({ball, cavity}), make_cut_plane({0, 0, 0.11}, {0, 0, 1}));
  EXPECT_EQ(cut.counts.closed, 2U);
  EXPECT_TRUE(watertightness(cut.soup).printable());
  EXPECT_NEAR(new_area(cut, Vec3::UnitZ()), pi * (1 - 0.25), 0.05);
}

TEST(PlaneCut, ATorusAcrossHasTwoDisks) {
  const TriangleSoup torus = make_torus(2, 0.5, 64, 32);
  const double disk = 16 * std::sin(2 * pi / 32) * 0.25;  // of 32 corners
  const CutSurface cut = cut_by_plane(torus, make_cut_plane({0, 0, 0}, {1, 0, 0}));
  EXPECT_EQ(cut.counts.closed, 2U);
  EXPECT_EQ(cut.counts.left_open, 0U);
  EXPECT_TRUE(watertightness(cut.soup).printable());
  EXPECT_NEAR(watertightness(cut.soup).volume, watertightness(torus).volume / 2, 1e-9);
  EXPECT_NEAR(new_area(cut, Vec3::UnitX()), 2 * disk, 2e-2);
}

TEST(PlaneCut, ABoundaryStaysALoop) {
  const TriangleSoup bust = cut(make_icosphere(4), [](const Vec3& p) { return p.z() < -0.5; });
  // Across the neck: the opening below stays.
  const CutSurface above = cut_by_plane(bust, make_cut_plane({0, 0, 0.31}, {0, 0, 1}));
  EXPECT_EQ(above.counts.closed, 1U);
  EXPECT_EQ(find_boundary_loops(make_surface_model(above.soup)).size(), 1U);
  // Through the opening: the section ends there.
  const CutSurface through = cut_by_plane(bust, make_cut_plane({0.01, 0, 0}, {1, 0, 0}));
  EXPECT_EQ(through.counts.closed, 0U);
  EXPECT_EQ(through.counts.left_open, 1U);
  EXPECT_EQ(through.counts.new_faces, 0U);
  EXPECT_EQ(find_boundary_loops(make_surface_model(through.soup)).size(), 1U);
}

/// A base of 4 by 4 with a tower on it: the plane holds the upper side of the base, or the lower side of a bar on the tower.
TEST(PlaneCut, FacesInThePlaneStayWhereMaterialLiesBehindThem) {
  TriangleSoup steps = test::make_cube(4);
  const double volume = watertightness(steps).volume, side = std::cbrt(volume);
  double top = -1e9;
  for (const Vec3& p : steps.points) top = std::max(top, p.z());
  // Away from the cube, nothing of its upper side goes.
  TriangleSoup tower = test::make_cube(2);
  for (Vec3& p : tower.points) p.z() += 10 * side;
  const CutSurface cut = cut_by_plane(joined({steps, tower}), make_cut_plane({0, 0, top}, {0, 0, 1}));
  EXPECT_EQ(cut.counts.divided_faces, 0U);
  EXPECT_EQ(cut.soup.triangles, steps.triangles);
  EXPECT_NEAR(watertightness(cut.soup).volume, volume, 1e-12);
  // From the other side, the upper side of the cube goes with it.
  const CutSurface rest = cut_by_plane(joined({steps, tower}), make_cut_plane({0, 0, top}, {0, 0, -1}));
  EXPECT_EQ(rest.counts.new_faces, 0U);
  EXPECT_EQ(rest.soup.triangles, tower.triangles);
}

TEST(PlaneCut, ColorsAndColumnsAreLinear) {
  TriangleSoup ball = make_icosphere(3);
  auto attributes = std::make_shared<ScanAttributes>();
  AttributeColumn heat("heat", ScalarType::float64), label("label", ScalarType::int32);
  const auto value = [](const Vec3& p) { return 3 + 2 * p.x() - p.y() + 0.5 * p.z(); };
  for (const Vec3& p : ball.points) heat.push(value(p));
  for (std::size_t f = 0; f < ball.triangles.size(); ++f) label.push(static_cast<double>(f));
  attributes->points = {heat};
  attributes->faces = {label};
  attributes->point_count = ball.points.size();
  attributes->triangle_count = ball.triangles.size();
  ball.attributes = attributes;
  const CutSurface cut = cut_by_plane(ball, make_cut_plane({0, 0, 0.2}, {0.2, 0.1, 1}));
  const TriangleSoup& soup = cut.soup;
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    const int row = point_row(soup, v);
    ASSERT_GE(row, 0);
    ASSERT_NEAR(soup.attributes->points[0].value(static_cast<std::size_t>(row)), value(soup.points[v]), 1e-5);
  }
  std::size_t new_faces = 0;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) new_faces += triangle_row(soup, f) < 0;
  EXPECT_EQ(new_faces, cut.counts.new_faces);
}

TEST(PlaneCut, APlaneThatCutsNothingIsRefused) {
  const TriangleSoup ball = make_icosphere(2);
  const auto words = [&](double height) -> std::string {
    try {
      cut_by_plane(ball, make_cut_plane({0, 0, height}, {0, 0, 1}));
    } catch (const InvalidArgument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(words(1.5), HasSubstr("misses the surface"));
  EXPECT_THAT(words(1.5), HasSubstr("from -2.5 to -0.5"));
  EXPECT_THAT(words(1001), HasSubstr("from -1002 to -1000"));
  EXPECT_THAT(words(-1.5), HasSubstr("remove the whole surface"));
  EXPECT_THROW(make_cut_plane({0, 0, 0}, {0, 0, 0}), InvalidArgument);
}

}  // namespace
}  // namespace loopmend
