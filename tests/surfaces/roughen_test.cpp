// SPDX-License-Identifier: GPL-3.0-or-later
#include "surfaces/roughen.h"

#include "core/error.h"
#include "samples/analytic_surfaces.h"
#include "samples/mesh_facts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace loopmend {
namespace {

using test::mesh_facts;
using test::MeshFacts;

constexpr double pi = std::numbers::pi;

Vec3 onto_sphere(const Vec3& p) { return p.normalized(); }

TEST(Roughen, KeepsTheSurfaceAndMakesItIrregular) {
  const TriangleSoup sphere = make_icosphere(4);
  const TriangleSoup rough = roughen(sphere, 0.2, 0.2, 7, onto_sphere);
  const MeshFacts facts = mesh_facts(rough);
  EXPECT_EQ(facts.vertices, 2562);
  EXPECT_EQ(facts.faces, 5120);
  EXPECT_EQ(facts.euler_characteristic(), 2);
  EXPECT_TRUE(facts.oriented);
  EXPECT_TRUE(facts.vertex_manifold);
  EXPECT_TRUE(facts.all_used);
  EXPECT_EQ(facts.components, 1);
  EXPECT_GT(facts.min_angle_deg, 12);
  EXPECT_NEAR(facts.area, 4 * pi, 0.01 * 4 * pi);
  std::vector<int> valence(rough.points.size(), 0);
  for (const Triangle& t : rough.triangles) {
    for (int v : t) ++valence[v];
    const Vec3 normal = (rough.points[t[1]] - rough.points[t[0]]).cross(rough.points[t[2]] - rough.points[t[0]]);
    EXPECT_GT(normal.normalized().dot(rough.points[t[0]]), 0.9);
  }
  EXPECT_GT(std::count_if(valence.begin(), valence.end(), [](int n) { return n != 6; }), 1000);
  EXPECT_EQ(*std::min_element(valence.begin(), valence.end()), 4);
  for (std::size_t v = 0; v < rough.points.size(); ++v) {
    EXPECT_NEAR(rough.points[v].norm(), 1, 4e-16);
    EXPECT_GT((rough.points[v] - sphere.points[v]).norm(), 0);
  }
}

TEST(Roughen, IsDeterministicInItsSeed) {
  const TriangleSoup sphere = make_icosphere(2);
  const TriangleSoup one = roughen(sphere, 0.2, 0.2, 1, onto_sphere);
  const TriangleSoup same = roughen(sphere, 0.2, 0.2, 1, onto_sphere);
  const TriangleSoup other = roughen(sphere, 0.2, 0.2, 2, onto_sphere);
  EXPECT_EQ(one.points, same.points);
  EXPECT_EQ(one.triangles, same.triangles);
  EXPECT_NE(one.points, other.points);
}

TEST(Roughen, WithNothingToDoChangesNothing) {
  const TriangleSoup torus = make_torus(2, 0.5, 24, 8);
  const TriangleSoup same = roughen(torus, 0, 0, 1, [](const Vec3& p) { return p; });
  EXPECT_EQ(same.points, torus.points);
  EXPECT_EQ(mesh_facts(same).euler_characteristic(), 0);
  EXPECT_THROW(roughen(torus, 0.5, 0, 1, onto_sphere), InvalidArgument);
  EXPECT_THROW(roughen(torus, 0, 1.5, 1, onto_sphere), InvalidArgument);
}

}  // namespace
}  // namespace loopmend
