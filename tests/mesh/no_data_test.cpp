// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/no_data.h"

#include <gtest/gtest.h>

namespace loopmend {
namespace {

Points terrain(double height) {
  Points points;
  for (int y = 0; y < 10; ++y)
    for (int x = 0; x < 10; ++x) points.emplace_back(x, y, height + 0.1 * x * y);
  return points;
}

TEST(NoData, FindsTheVerticesOfTheMark) {
  for (const double mark : {-9999.0, -32768.0, -3.4028234663852886e38}) {
    Points points = terrain(400);
    for (int v : {3, 17, 55}) points[v].z() = mark;
    const NoDataVertices found = find_no_data(points);
    EXPECT_EQ(found.value, mark);
    EXPECT_EQ(found.vertices, (std::vector<int>{3, 17, 55}));
  }
}

TEST(NoData, FindsTheLowestFloatInFewerDigits) {
  for (const double mark : {-3.4e38, -3.40282e38, -3.4028235e38}) {
    Points points = terrain(400);
    points[17].z() = mark;
    EXPECT_EQ(find_no_data(points).vertices, std::vector<int>{17}) << mark;
  }
}

TEST(NoData, LeavesWhatIsASurface) {
  EXPECT_TRUE(find_no_data(terrain(400)).vertices.empty());
  EXPECT_TRUE(find_no_data(terrain(-9999)).vertices.empty());  // the lowest of many heights
  EXPECT_TRUE(find_no_data({}).vertices.empty());
  Points wide = terrain(0);  // -9999 is as near to the others as they are to one another
  wide[0].x() = 20000;
  wide[1].x() = -9999;
  EXPECT_TRUE(find_no_data(wide).vertices.empty());
}

}  // namespace
}  // namespace loopmend
