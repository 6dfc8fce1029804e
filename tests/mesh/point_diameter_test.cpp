// SPDX-License-Identifier: GPL-3.0-or-later
// The largest distance between points, bit for bit that of all pairs.
#include "mesh/point_diameter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace loopmend {
namespace {

double by_all_pairs(const Points& points) {
  double squared = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) squared = std::max(squared, (points[i] - points[j]).squaredNorm());
  return std::sqrt(squared);
}

Points many(int count, const std::function<Vec3(int)>& place) {
  Points points;
  for (int k = 0; k < count; ++k) points.push_back(place(k));
  return points;
}

TEST(PointDiameter, IsThatOfAllPairsToTheLastBit) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (const int count : {0, 1, 2, 3, 16, 17, 40, 1000}) {
    const double t = 2 * std::numbers::pi / std::max(1, count);
    const auto cloud = [&](int) { return Vec3(normal(random), normal(random), 1e-3 * normal(random)); };
    const auto circle = [&](int k) { return Vec3(std::cos(t * k), std::sin(t * k), 0); };
    const auto far_ellipse = [&](int k) { return Vec3(1e6 + 3 * std::cos(t * k), 1e5 + std::sin(t * k), k * 1e-9); };
    const auto line = [](int k) { return Vec3(0.1, 0.1 * ((k * 7919) % 1000), 0.3); };
    const auto ball = [&](int) { return Vec3(cloud(0).normalized()); };
    const auto one_place = [](int) { return Vec3(0.1, 0.2, 0.3); };
    for (const std::function<Vec3(int)>& place :
         std::vector<std::function<Vec3(int)>>{cloud, circle, far_ellipse, line, ball, one_place}) {
      const Points points = many(count, place);
      EXPECT_EQ(diameter_of(points), by_all_pairs(points)) << count;
    }
  }
}

TEST(PointDiameter, OfALongLoop) {  // all pairs of a million points would take hours
  const int count = 1000000;
  const Points points = many(count, [&](int k) {
    const double t = 2 * std::numbers::pi * k / count;
    return Vec3(std::cos(t), std::sin(t), 0.01 * std::sin(3 * t));
  });
  EXPECT_NEAR(diameter_of(points), 2 * std::sqrt(1 + 1e-4), 1e-9);
}

}  // namespace
}  // namespace loopmend
