// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/self_intersections.h"

#include <gtest/gtest.h>

#include <random>

namespace loopmend {
namespace {

struct Soup {
  Points points;
  Triangles triangles;
  void add(const Vec3& a, const Vec3& b, const Vec3& c) {
    const int n = static_cast<int>(points.size());
    for (const Vec3& p : {a, b, c}) points.push_back(p);
    triangles.push_back({n, n + 1, n + 2});
  }
};

/// Triangles at random in a flat box, many of which cut one another.
Soup random_soup(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-1, 1), way(-0.4, 0.4);
  Soup soup;
  for (int k = 0; k < count; ++k) {
    const Vec3 p(place(random), 3 * place(random), 0.1 * place(random));
    const auto near = [&] { return Vec3(p + Vec3(way(random), way(random), way(random))); };
    soup.add(p, near(), near());
  }
  return soup;
}

/// Pair by pair.
std::vector<std::pair<int, int>> by_brute_force(const Soup& soup, int count) {
  std::vector<std::pair<int, int>> pairs;
  for (int f = 0; f < count; ++f)
    for (int g = f + 1; g < static_cast<int>(soup.triangles.size()); ++g) {
      const auto a = soup.points.begin() + 3L * f, b = soup.points.begin() + 3L * g;
      const Points both{a[0], a[1], a[2], b[0], b[1], b[2]};
      if (!self_intersections(both, {{0, 1, 2}, {3, 4, 5}}, 1).empty()) pairs.emplace_back(f, g);
    }
  return pairs;
}

TEST(SelfIntersections, FindsEveryPairOfWhichOneIsAmongTheFirst) {
  const Soup soup = random_soup(300, 1);
  for (int count : {300, 120}) {
    const auto expected = by_brute_force(soup, count);
    EXPECT_GT(expected.size(), 50u);
    EXPECT_EQ(self_intersections(soup.points, soup.triangles, count), expected);
  }
}

TEST(SelfIntersections, ManyTrianglesBesideChangeNothing) {
  Soup soup = random_soup(300, 2);
  const auto expected = self_intersections(soup.points, soup.triangles, 200);
  for (int k = 0; k < 25000; ++k) {  // a stair beside them: so many are searched in another way
    const double x = 5 + 0.1 * k;
    soup.add({x, 0, 0}, {x + 0.05, 0, 0}, {x, 0.05, 0.01});
  }
  EXPECT_EQ(self_intersections(soup.points, soup.triangles, 200), expected);
}

/// Corners in one place are shared by more pairs than three: an array of three was written beyond its end.
TEST(SelfIntersections, CollapsedTrianglesCutNothing) {
  Soup soup;
  const Vec3 p(0.1, 0.1, 0);
  soup.add({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  soup.add(p, p, p);
  soup.add(p, p, {0.1, 0.1, 1});
  soup.add({0.1, 0.1, -1}, p, p);
  EXPECT_TRUE(self_intersections(soup.points, soup.triangles, 4).empty());
  soup.add({0.1, 0.1, -1}, {0.2, 0.1, 1}, {0.1, 0.2, 1});
  EXPECT_EQ(self_intersections(soup.points, soup.triangles, 5), (std::vector{std::pair{0, 4}}));
}

TEST(SelfIntersections, TrianglesThatShareAnEdgeOrACornerDoNotCut) {
  const Points points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.2}, {-1, -1, 0.1}, {-1, 0, 0.3}};
  EXPECT_TRUE(self_intersections(points, {{0, 1, 2}, {1, 3, 2}, {0, 5, 4}}, 3).empty());
}

}  // namespace
}  // namespace loopmend
