// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/select_triangles.h"

#include <gtest/gtest.h>

namespace loopmend {
namespace {

TriangleSoup strip() {
  TriangleSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 2, 0}, {9, 9, 9}};
  soup.triangles = {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}};
  soup.colors = {{1, 0, 0, 255}, {2, 0, 0, 255}, {3, 0, 0, 255}, {4, 0, 0, 255}, {5, 0, 0, 255}, {6, 0, 0, 255}};
  return soup;
}

TEST(SelectTriangles, KeepsTheOrderAndDropsPointsThatNoneOfThemUses) {
  const TriangleSelection part = select_triangles(strip(), {0, 1, 1});
  EXPECT_EQ(part.soup.points, (Points{{1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 2, 0}}));
  EXPECT_EQ(part.soup.triangles, (Triangles{{0, 2, 1}, {1, 2, 3}}));
  EXPECT_EQ(part.point_number, (std::vector<int>{-1, 0, 1, 2, 3, -1}));
  ASSERT_EQ(part.soup.colors.size(), 4U);
  EXPECT_EQ(part.soup.colors[0], (Color{2, 0, 0, 255}));
  EXPECT_EQ(part.soup.colors[3], (Color{5, 0, 0, 255}));
}

TEST(SelectTriangles, OfNoneIsEmpty) {
  const TriangleSelection none = select_triangles(strip(), {0, 0, 0});
  EXPECT_TRUE(none.soup.points.empty() && none.soup.triangles.empty() && none.soup.colors.empty());
}

}  // namespace
}  // namespace loopmend
