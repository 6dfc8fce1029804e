// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/delaunay.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>

namespace loopmend {
namespace {

const Points octahedron = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};

TEST(HullFacets, ThoseOfAnOctahedronLookOutwards) {
  const Triangles facets = hull_facets(octahedron);
  ASSERT_EQ(facets.size(), 8u);
  double volume = 0;
  for (const auto& [a, b, c] : facets) volume += octahedron[a].dot(octahedron[b].cross(octahedron[c])) / 6;
  EXPECT_DOUBLE_EQ(volume, 4.0 / 3);
}

TEST(HullFacets, AreInAnOrderOfTheirOwn) {
  const Triangles facets = hull_facets(octahedron);
  EXPECT_TRUE(std::is_sorted(facets.begin(), facets.end()));
  for (const Triangle& t : facets) EXPECT_EQ(t[0], *std::min_element(t.begin(), t.end()));
}

TEST(HullFacets, LeaveOutWhatLiesWithin) {
  Points points = octahedron;
  points.push_back({0.1, 0.1, 0.1});
  EXPECT_EQ(hull_facets(points), hull_facets(octahedron));
}

TEST(HullFacets, NoneInAPlane) { EXPECT_TRUE(hull_facets({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}).empty()); }

TEST(DelaunayFaces, ATetrahedronWithAPointWithin) {
  const Triangles faces = delaunay_faces({{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}, {0, 0, 0}});
  EXPECT_EQ(faces.size(), 10u);  // four outside, one at each of the six edges
  for (const Triangle& t : faces) EXPECT_TRUE(t[0] < t[1] && t[1] < t[2]);
}

TEST(DelaunayFaces, InAPlaneThoseOfThePlane) {
  Triangles faces = delaunay_faces({{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1.5, 0}});
  std::sort(faces.begin(), faces.end());
  EXPECT_EQ(faces, (Triangles{{0, 1, 2}, {1, 2, 3}}));
}

TEST(DelaunayFaces, NoneOnALine) { EXPECT_TRUE(delaunay_faces({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}).empty()); }

}  // namespace
}  // namespace loopmend
