// SPDX-License-Identifier: GPL-3.0-or-later
#include "remeshing/double_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace loopmend {
namespace {

TEST(SplitDoubleEdges, PartsWhatTwoSidesOfAPatchHaveInCommon) {
  // Places 0 and 3 are one vertex; both reach vertex 6, between two triangles each.
  Points points{{0, 0, 0}, {1, -1, 0}, {1, 1, 0}, {0, 0, 0}, {-1, 1, 0}, {-1, -1, 0}, {0, 1, 0}};
  Triangles triangles{{0, 1, 6}, {0, 6, 5}, {3, 6, 2}, {3, 4, 6}};
  split_double_edges(6, points, triangles);
  ASSERT_EQ(points.size(), 8u);
  EXPECT_EQ(points[7], Vec3(0, 0.5, 0));
  EXPECT_EQ(triangles.size(), 6u);
  std::map<std::pair<int, int>, int> edges;  // with vertex 0 for place 3
  const auto vertex = [](int v) { return v == 3 ? 0 : v; };
  for (const Triangle& t : triangles)
    for (int k = 0; k < 3; ++k) ++edges[std::minmax(vertex(t[k]), vertex(t[(k + 1) % 3]))];
  for (const auto& [edge, count] : edges) EXPECT_LE(count, 2);
}

TEST(SplitDoubleEdges, NeverTouchesTheBoundary) {
  // Two boundary edges in one place, as along a crack: vertices 0, 1 and 2, 3.
  Points points{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0.5, 1, 0}, {0.5, -1, 0}};
  Triangles triangles{{0, 1, 4}, {2, 3, 5}};
  const Triangles before = triangles;
  split_double_edges(4, points, triangles);
  EXPECT_EQ(triangles, before);
}

TEST(SplitDoubleEdges, LeavesOrdinaryPatchesAlone) {
  Points points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  Triangles triangles{{0, 1, 2}, {0, 2, 3}};
  const Triangles before = triangles;
  split_double_edges(4, points, triangles);
  EXPECT_EQ(triangles, before);
  EXPECT_EQ(points.size(), 4u);
}

TEST(SplitBeside, PutsAVertexBesideEachEdge) {
  Points points{{0, 0, 0}, {1, -1, 0}, {2, 0, 0}, {1, 1, 0.8}, {3, 2, 0}};
  Triangles triangles{{0, 1, 2}, {0, 2, 3}, {3, 2, 4}};
  split_beside({{0, 2}, {2, 3}}, points, triangles);
  ASSERT_EQ(points.size(), 7u);
  EXPECT_TRUE(points[5].isApprox(Vec3(1, 0, 0.1)));
  EXPECT_TRUE(points[6].isApprox(Vec3(1.5, 0.625, 0.3)));
  EXPECT_EQ(triangles.size(), 7u);
  std::map<std::pair<int, int>, int> edges;
  for (const Triangle& t : triangles)
    for (int k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
  for (const auto& [edge, count] : edges) EXPECT_EQ(count, 1);  // oriented as before
  EXPECT_FALSE(edges.contains({0, 2}) || edges.contains({2, 0}) || edges.contains({2, 3}) || edges.contains({3, 2}));
  const auto open = std::count_if(edges.begin(), edges.end(), [&](const auto& edge) {
    return !edges.contains({edge.first.second, edge.first.first});
  });
  EXPECT_EQ(open, 5);
}

}  // namespace
}  // namespace loopmend
