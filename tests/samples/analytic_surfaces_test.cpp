// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/analytic_surfaces.h"

#include "core/error.h"
#include "mesh_facts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace loopmend {
namespace {

using test::mesh_facts;
using test::MeshFacts;

constexpr double pi = std::numbers::pi;

void expect_clean(const MeshFacts& facts) {
  EXPECT_TRUE(facts.oriented);
  EXPECT_TRUE(facts.vertex_manifold);
  EXPECT_TRUE(facts.all_used);
  EXPECT_EQ(facts.components, 1);
}

TEST(Icosphere, HasTheCountsOfASplitIcosahedron) {
  for (int level = 0; level <= 5; ++level) {
    const MeshFacts facts = mesh_facts(make_icosphere(level));
    const int quads = 1 << (2 * level);
    EXPECT_EQ(facts.vertices, 10 * quads + 2);
    EXPECT_EQ(facts.edges, 30 * quads);
    EXPECT_EQ(facts.faces, 20 * quads);
    EXPECT_EQ(facts.euler_characteristic(), 2);
    EXPECT_TRUE(facts.loops.empty());
    EXPECT_GT(facts.min_angle_deg, 47);
    expect_clean(facts);
  }
}

TEST(Icosphere, LiesOnTheUnitSphereWithOutwardNormals) {
  const TriangleSoup sphere = make_icosphere(4);
  const Points normals = test::unit_normals(sphere);
  for (std::size_t v = 0; v < sphere.points.size(); ++v) {
    EXPECT_NEAR(sphere.points[v].norm(), 1, 4e-16);
    EXPECT_GT(normals[v].dot(sphere.points[v]), 0.999);
  }
}

TEST(Icosphere, AreaAndVolumeConvergeWithSecondOrder) {
  double area_error = 0;
  double volume_error = 0;
  for (int level = 2; level <= 6; ++level) {
    const TriangleSoup sphere = make_icosphere(level);
    const double area_now = 4 * pi - mesh_facts(sphere).area;
    const double volume_now = 4 * pi / 3 - test::signed_volume(sphere);
    EXPECT_GT(area_now, 0);
    EXPECT_GT(volume_now, 0);
    if (level > 2) {
      EXPECT_NEAR(area_error / area_now, 4, 0.1);
      EXPECT_NEAR(volume_error / volume_now, 4, 0.1);
    }
    area_error = area_now;
    volume_error = volume_now;
  }
}

TEST(Icosphere, RefusesLevelsOutOfRange) {
  EXPECT_THROW(make_icosphere(-1), InvalidArgument);
  EXPECT_THROW(make_icosphere(9), InvalidArgument);
}

TEST(Cylinder, IsAnOpenTubeOfRadiusOne) {
  const TriangleSoup cylinder = make_cylinder(3, 40);
  const MeshFacts facts = mesh_facts(cylinder);
  const int rows = 19;  // 3 / (2π/40) = 19.1
  EXPECT_EQ(facts.vertices, 40 * (rows + 1));
  EXPECT_EQ(facts.faces, 2 * 40 * rows);
  EXPECT_EQ(facts.euler_characteristic(), 0);
  ASSERT_EQ(facts.loops.size(), 2U);
  EXPECT_EQ(facts.loops[0].size(), 40U);
  EXPECT_EQ(facts.loops[1].size(), 40U);
  expect_clean(facts);
  // A polygon of 40 sides instead of the circle: its area is known exactly.
  EXPECT_NEAR(facts.area, 3 * 80 * std::sin(pi / 40), 1e-12);
  const Points normals = test::unit_normals(cylinder);
  for (std::size_t v = 0; v < cylinder.points.size(); ++v) {
    const Vec3& p = cylinder.points[v];
    EXPECT_NEAR(p.head<2>().norm(), 1, 1e-15);
    EXPECT_GE(p.z(), 0);
    EXPECT_LE(p.z(), 3);
    EXPECT_GT(normals[v].dot(Vec3(p.x(), p.y(), 0)), 0.99);
  }
}

TEST(Cylinder, RefusesWhatIsNoCylinder) {
  EXPECT_THROW(make_cylinder(0, 40), InvalidArgument);
  EXPECT_THROW(make_cylinder(1, 7), InvalidArgument);
}

TEST(Revolution, FollowsItsProfile) {
  const auto radius = [](double z) { return std::cosh(z); };
  const TriangleSoup catenoid = make_revolution(radius, -1, 1, 160, 50);
  const MeshFacts facts = mesh_facts(catenoid);
  EXPECT_EQ(facts.vertices, 160 * 51);
  EXPECT_EQ(facts.euler_characteristic(), 0);
  expect_clean(facts);
  for (const Vec3& p : catenoid.points) EXPECT_NEAR(p.head<2>().norm(), std::cosh(p.z()), 1e-14);
  EXPECT_NEAR(facts.area, pi * (2 + std::sinh(2.0)), 0.005 * facts.area);
  EXPECT_THROW(make_revolution([](double z) { return z; }, -1, 1, 16, 4), InvalidArgument);
}

TEST(Torus, IsClosedWithTheRightCountsAndOutwardNormals) {
  const TriangleSoup torus = make_torus(2, 0.5, 60, 20);
  const MeshFacts facts = mesh_facts(torus);
  EXPECT_EQ(facts.vertices, 1200);
  EXPECT_EQ(facts.faces, 2400);
  EXPECT_EQ(facts.euler_characteristic(), 0);
  EXPECT_TRUE(facts.loops.empty());
  expect_clean(facts);
  for (const Vec3& p : torus.points) {
    EXPECT_NEAR(std::hypot(p.head<2>().norm() - 2, p.z()), 0.5, 1e-15);
  }
  EXPECT_NEAR(test::signed_volume(torus), 2 * pi * pi * 2 * 0.25, 0.03 * test::signed_volume(torus));
  EXPECT_NEAR(facts.area, 4 * pi * pi * 2 * 0.5, 0.01 * facts.area);
  EXPECT_THROW(make_torus(1, 1, 60, 20), InvalidArgument);
}

TEST(Graph, IsASheetWithNormalsUp) {
  const auto saddle = [](double x, double y) { return x * y; };
  const TriangleSoup graph = make_graph(saddle, 2, 31);
  const MeshFacts facts = mesh_facts(graph);
  EXPECT_EQ(facts.vertices, 32 * 32);
  EXPECT_EQ(facts.faces, 2 * 31 * 31);
  EXPECT_EQ(facts.euler_characteristic(), 1);
  expect_clean(facts);
  for (const Vec3& n : test::unit_normals(graph)) EXPECT_GT(n.z(), 0);
  EXPECT_EQ(graph.points.front(), Vec3(-2, -2, 4));
  EXPECT_EQ(graph.points.back(), Vec3(2, 2, 4));
}

TEST(Cut, TakesEveryTriangleWithACornerInsideAndKeepsTheOrder) {
  const TriangleSoup sphere = make_icosphere(4);
  const auto inside = [](const Vec3& p) { return p.z() > 0.9; };
  const TriangleSoup open = cut(sphere, inside);
  const MeshFacts facts = mesh_facts(open);
  EXPECT_TRUE(facts.oriented);
  EXPECT_TRUE(facts.all_used);
  EXPECT_EQ(facts.euler_characteristic(), 1);
  EXPECT_EQ(facts.loops.size(), 1U);
  std::size_t triangle = 0;
  for (const Triangle& t : sphere.triangles) {
    if (inside(sphere.points[t[0]]) || inside(sphere.points[t[1]]) || inside(sphere.points[t[2]])) continue;
    for (int k = 0; k < 3; ++k) EXPECT_EQ(open.points[open.triangles[triangle][k]], sphere.points[t[k]]);
    ++triangle;
  }
  EXPECT_EQ(triangle, open.triangles.size());
}

TEST(Cut, TakesColorsAlong) {
  TriangleSoup sphere = make_icosphere(1);
  for (std::size_t v = 0; v < sphere.points.size(); ++v) {
    sphere.colors.push_back({static_cast<unsigned char>(v), 1, 2, 3});
  }
  const Vec3 gone = sphere.points[0];
  const TriangleSoup open = cut(sphere, [&](const Vec3& p) { return p == gone; });
  ASSERT_EQ(open.colors.size(), sphere.points.size() - 1);
  EXPECT_EQ(open.colors[0][0], 1);
}

TEST(Cut, OfEverythingIsEmpty) {
  const TriangleSoup nothing = cut(make_icosphere(1), [](const Vec3&) { return true; });
  EXPECT_TRUE(nothing.points.empty());
  EXPECT_TRUE(nothing.triangles.empty());
}

TEST(TrimBoundaries, LeavesOneFanAtEveryVertexAndNothingHanging) {
  // Points at odd coordinates. Without two of them the faces at (1, 1) are two fans; two corners of the grid hang on by
  // one edge.
  const TriangleSoup grid = make_graph([](double, double) { return 0.0; }, 7, 7);
  const TriangleSoup pierced =
      cut(grid, [](const Vec3& p) { return std::abs(p.y() - 1) < 0.1 && std::abs(std::abs(p.x() - 1) - 2) < 0.1; });
  ASSERT_FALSE(mesh_facts(pierced).vertex_manifold);
  ASSERT_GT(mesh_facts(pierced).hanging_faces, 0);
  const MeshFacts trimmed = mesh_facts(trim_boundaries(pierced));
  expect_clean(trimmed);
  EXPECT_EQ(trimmed.hanging_faces, 0);
  EXPECT_EQ(trimmed.loops.size(), 2U);
  EXPECT_GT(trimmed.faces, static_cast<int>(pierced.triangles.size()) - 16);
}

}  // namespace
}  // namespace loopmend
