// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/triangle_soup.h"

#include <gtest/gtest.h>

namespace loopmend {
namespace {

constexpr Color white{255, 255, 255, 255}, red{255, 0, 0, 255};

TriangleSoup triangle(double z) { return {{{0, 0, z}, {1, 0, z}, {0, 1, z}}, {{0, 1, 2}}, {}}; }

TEST(JoinedSoups, PointAtTheirOwnPointsInOrder) {
  const TriangleSoup all = joined({triangle(0), triangle(1), triangle(2)});
  ASSERT_EQ(all.points.size(), 9u);
  EXPECT_EQ(all.points[7], Vec3(1, 0, 2));
  EXPECT_EQ(all.triangles, (Triangles{{0, 1, 2}, {3, 4, 5}, {6, 7, 8}}));
  EXPECT_TRUE(all.colors.empty());
  EXPECT_TRUE(joined({}).points.empty());
}

TEST(JoinedSoups, AreWhiteWhereOnlyOthersHaveColours) {
  TriangleSoup colored = triangle(0);
  colored.colors = {red, red, red};
  EXPECT_EQ(joined({colored, triangle(1)}).colors, (std::vector<Color>{red, red, red, white, white, white}));
  EXPECT_EQ(joined({triangle(1), colored}).colors, (std::vector<Color>{white, white, white, red, red, red}));
}

}  // namespace
}  // namespace loopmend
