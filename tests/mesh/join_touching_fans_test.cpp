// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/join_touching_fans.h"

#include "mesh/boundary_loops.h"

#include <gtest/gtest.h>

#include <functional>

namespace loopmend {
namespace {

constexpr int cells = 6;
int at(int i, int j) { return j * (cells + 1) + i; }

/// The unit squares of a plane that are kept, two triangles each.
TriangleSoup squares(const std::function<bool(int i, int j)>& keep) {
  TriangleSoup soup;
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i) soup.points.emplace_back(i, j, 0);
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) {
      if (!keep(i, j)) continue;
      soup.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      soup.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return soup;
}

/// The faces that are chosen name a copy of the vertex, at the end of the points.
void double_vertex(TriangleSoup& soup, int v, const std::function<bool(const Vec3& middle)>& chosen) {
  const int copy = static_cast<int>(soup.points.size());
  soup.points.push_back(soup.points[v]);
  for (Triangle& t : soup.triangles) {
    if (!chosen((soup.points[t[0]] + soup.points[t[1]] + soup.points[t[2]]) / 3)) continue;
    std::replace(t.begin(), t.end(), v, copy);
  }
}

std::size_t holes_of(const TriangleSoup& soup) {
  const SurfaceModel model = make_surface_model(soup);
  std::size_t holes = 0;
  for (const BoundaryLoop& loop : find_boundary_loops(model)) holes += loop.kind == LoopKind::hole ? 1 : 0;
  return holes;
}

std::vector<int> after_joining(TriangleSoup& soup) {
  return join_touching_fans(soup, survey_vertices(soup.triangles, soup.points.size()));
}

/// Two squares are missing that touch at (3, 3), and the vertex there is double.
TEST(JoinTouchingFans, GivesTwoHolesThatTouchTheirOwnLoops) {
  const TriangleSoup whole = squares([](int i, int j) { return !(i == 2 && j == 2) && !(i == 3 && j == 3); });
  TriangleSoup soup = whole;
  double_vertex(soup, at(3, 3), [](const Vec3& middle) { return middle.x() > middle.y(); });
  ASSERT_NE(soup.triangles, whole.triangles);
  EXPECT_EQ(holes_of(soup), 1u);
  const std::vector<int> named = after_joining(soup);
  EXPECT_EQ(soup.triangles, whole.triangles);
  ASSERT_EQ(named.size(), whole.points.size() + 1);
  EXPECT_EQ(named.back(), at(3, 3));
  EXPECT_EQ(named[at(1, 1)], at(1, 1));
  EXPECT_EQ(soup.points.size(), whole.points.size() + 1);
  EXPECT_EQ(holes_of(soup), 2u);
}

/// The colour is another: what touches there is not one vertex of the scan.
TEST(JoinTouchingFans, LeavesVerticesOfOtherColours) {
  TriangleSoup soup = squares([](int i, int j) { return !(i == 2 && j == 2) && !(i == 3 && j == 3); });
  double_vertex(soup, at(3, 3), [](const Vec3& middle) { return middle.x() > middle.y(); });
  soup.colors.assign(soup.points.size(), {1, 2, 3, 255});
  soup.colors.back() = {9, 2, 3, 255};
  EXPECT_TRUE(after_joining(soup).empty());
}

/// A crack: the plane is cut along x = 3, and the vertices there are double.
TEST(JoinTouchingFans, LeavesCracks) {
  TriangleSoup soup = squares([](int, int) { return true; });
  for (int j = 0; j <= cells; ++j) double_vertex(soup, at(3, j), [](const Vec3& middle) { return middle.x() > 3; });
  const Triangles before = soup.triangles;
  EXPECT_TRUE(after_joining(soup).empty());
  EXPECT_EQ(soup.triangles, before);
}

/// Two planes whose corners meet at one place, one seen from above and one from below: sheets that touch.
TEST(JoinTouchingFans, LeavesSheetsThatFaceDifferentSides) {
  TriangleSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {-1, 0, 0}, {0, -1, 0}};
  soup.triangles = {{0, 1, 2}, {3, 5, 4}};
  EXPECT_TRUE(after_joining(soup).empty());
  soup.triangles = {{0, 1, 2}, {3, 4, 5}};
  EXPECT_EQ(after_joining(soup)[3], 0);
}

}  // namespace
}  // namespace loopmend
