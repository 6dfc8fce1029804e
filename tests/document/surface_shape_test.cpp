// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/surface_shape.h"

#include "samples/analytic_surfaces.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace loopmend::test {
namespace {

Eigen::Map<const Eigen::Vector3f> point(const SurfaceShape& shape, int v) {
  return Eigen::Map<const Eigen::Vector3f>(shape.points.data() + 3 * static_cast<std::ptrdiff_t>(v));
}

SurfaceShape ball(int level) {
  SurfaceShape shape = shape_of(make_icosphere(level), Vec3::Zero());
  for (std::size_t v = 0; v < shape.points.size() / 3; ++v) {
    shape.H.push_back(v % 7 == 0 ? std::nanf("") : -1.0F);
    for (unsigned char c : {v % 2 ? 90 : 110, 0, 255}) shape.colors.push_back(c);
  }
  return shape;
}

TEST(SurfaceShape, ACubePartedAtItsCreasesHasTheNormalsOfItsSides) {
  TriangleSoup cube;
  for (int v = 0; v < 8; ++v) cube.points.emplace_back(v & 1, (v >> 1) & 1, (v >> 2) & 1);
  cube.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  const SurfaceShape shape = parted_at_creases(shape_of(cube, Vec3::Zero()), 50);
  ASSERT_EQ(shape.points.size(), 3U * 24);
  ASSERT_EQ(shape.normals.size(), 3U * 24);
  for (std::size_t t = 0; t < shape.triangles.size(); ++t) {
    const int v = shape.triangles[t], given = cube.triangles[t / 3][t % 3];
    EXPECT_EQ(point(shape, v).cast<double>(), cube.points[given]);
    const Eigen::Map<const Eigen::Vector3f> normal(shape.normals.data() + 3 * static_cast<std::ptrdiff_t>(v));
    EXPECT_EQ(normal.lpNorm<1>(), 1);
    EXPECT_EQ(normal.lpNorm<Eigen::Infinity>(), 1);
  }
}

TEST(SurfaceShape, ABallHasNoCreasesToPartAt) {
  const SurfaceShape whole = shape_of(make_icosphere(3), Vec3::Zero());
  const SurfaceShape parted = parted_at_creases(whole, 50);
  EXPECT_EQ(parted.points, whole.points);
  EXPECT_EQ(parted.normals, whole.normals);
  EXPECT_EQ(parted.triangles, whole.triangles);
}

TEST(SurfaceShape, SlicesHaveAllTriangles) {
  const SurfaceShape whole = ball(3);
  const int count = static_cast<int>(whole.triangles.size() / 3);
  std::vector<int> number;
  int seen = 0;
  for (int begin = 0; begin < count; begin += 300) {
    std::vector<int> triangles(static_cast<std::size_t>(std::min(300, count - begin)));
    std::iota(triangles.begin(), triangles.end(), begin);
    const auto slice = with_triangles(whole, triangles, number);
    ASSERT_EQ(slice->triangles.size(), 3 * triangles.size());
    EXPECT_EQ(slice->own_triangles, static_cast<int>(triangles.size()));
    EXPECT_LT(slice->points.size(), whole.points.size());
    EXPECT_EQ(slice->normals.size(), slice->points.size());
    EXPECT_EQ(slice->colors.size(), slice->points.size());
    EXPECT_EQ(3 * slice->H.size(), slice->points.size());
    for (int i = 0; i < static_cast<int>(slice->triangles.size()); ++i, ++seen)
      ASSERT_EQ(point(*slice, slice->triangles[i]), point(whole, whole.triangles[3 * begin + i]));
    EXPECT_TRUE(std::all_of(number.begin(), number.end(), [](int n) { return n == -1; }));
  }
  EXPECT_EQ(seen, 3 * count);
}

TEST(SurfaceShape, ASmallOneIsNotReduced) { EXPECT_EQ(with_reduced(ball(5)).reduced, nullptr); }

using Triples = std::vector<std::array<int, 3>>;

Triples triples(const SurfaceShape& shape) {
  Triples all;
  for (std::size_t t = 0; t < shape.triangles.size(); t += 3)
    all.push_back({shape.triangles[t], shape.triangles[t + 1], shape.triangles[t + 2]});
  std::sort(all.begin(), all.end());
  return all;
}

TEST(SurfaceShape, CurvatureIsAddedToASharedListOfTriangles) {
  const SurfaceShape plain = with_reduced(ball(7));
  const std::size_t vertices = plain.points.size() / 3;
  CurvatureField field{std::vector<double>(vertices, -2), std::vector<double>(vertices, 4),
                       Points(vertices, Vec3::UnitX())};
  field.normals.front() = Vec3::Zero();  // no fit
  const SurfaceShape colored = with_reduced(with_curvature(plain, field));
  EXPECT_EQ(colored.triangles.data(), plain.triangles.data()) << "12 bytes a triangle";
  EXPECT_EQ(colored.own_triangles, plain.own_triangles);
  EXPECT_EQ(colored.points, plain.points);
  EXPECT_EQ(colored.colors, plain.colors);
  EXPECT_EQ(colored.H, std::vector<float>(vertices, -2));
  EXPECT_EQ(colored.K, std::vector<float>(vertices, 4));
  const auto normal = [](const SurfaceShape& shape, std::size_t v) {
    return Eigen::Vector3f(shape.normals.data() + 3 * static_cast<std::ptrdiff_t>(v));
  };
  EXPECT_EQ(normal(colored, 0), normal(plain, 0));
  EXPECT_EQ(normal(colored, 1), Eigen::Vector3f::UnitX().eval());
  ASSERT_NE(colored.reduced, nullptr);
  EXPECT_EQ(colored.reduced->H.size(), plain.reduced->points.size() / 3);
}

TEST(SurfaceShape, ALargeOneKeepsItsTrianglesAndNearOnesFollowEachOther) {
  const SurfaceShape before = ball(7), after = with_reduced(before);
  EXPECT_EQ(triples(after), triples(before));
  EXPECT_EQ(after.points, before.points);
  const std::size_t slice = after.triangles.size() / 16;
  double sum = 0;
  for (std::size_t begin = 0; begin < after.triangles.size(); begin += slice) {
    Eigen::AlignedBox3f box;
    for (std::size_t i = begin; i < begin + slice; ++i) box.extend(Eigen::Vector3f(point(after, after.triangles[i])));
    sum += box.volume();
  }
  EXPECT_LT(sum, 3 * 8) << "three boxes around all; slices of triangles in no order have sixteen";
}

TEST(SurfaceShape, ALargeOneIsReducedToItsMeans) {
  const SurfaceShape large = with_reduced(ball(7));
  ASSERT_NE(large.reduced, nullptr);
  const SurfaceShape& reduced = *large.reduced;
  const int vertices = static_cast<int>(reduced.points.size() / 3);
  EXPECT_GT(vertices, 20'000);
  EXPECT_LE(vertices, 60'000);
  EXPECT_EQ(reduced.own_triangles, static_cast<int>(reduced.triangles.size() / 3));
  // Closed and of one piece, as the ball is: V - E + F = 2, where E = 3/2 F; cells with two sheets are not met here.
  EXPECT_NEAR(vertices - 0.5 * reduced.own_triangles, 2, 0.01 * vertices);
  for (int v : reduced.triangles) ASSERT_TRUE(v >= 0 && v < vertices);
  for (int v = 0; v < vertices; ++v) {
    ASSERT_NEAR(point(reduced, v).norm(), 1, 2e-4);  // a cell is some 0.01 wide
    const Eigen::Map<const Eigen::Vector3f> normal(reduced.normals.data() + 3 * static_cast<std::ptrdiff_t>(v));
    ASSERT_GT(normal.dot(point(reduced, v)), 0.999);
    const float H = reduced.H[v];
    ASSERT_TRUE(H == -1.0F || std::isnan(H)) << "unknown only where no vertex of the cell is known";
    const int red = reduced.colors[3 * static_cast<std::size_t>(v)];
    ASSERT_TRUE(red >= 90 && red <= 110);
  }
}

TEST(SurfaceShape, NearlyConstantValuesLieInTheMiddleOfTheirHalfOfTheColors) {
  const auto ramp = [](float from, float to) {
    std::vector<float> values(101);
    for (int k = 0; k <= 100; ++k)
      values[static_cast<std::size_t>(k)] = from + (to - from) * static_cast<float>(k) / 100;
    return values;
  };
  EXPECT_DOUBLE_EQ(symmetric_range(ramp(-1, -1)), 2);
  EXPECT_DOUBLE_EQ(symmetric_range(ramp(4, 5)), 10);
  EXPECT_DOUBLE_EQ(symmetric_range(ramp(0, 5)), 4.9);
  EXPECT_DOUBLE_EQ(symmetric_range(ramp(-5, 5), 100), 5);
  EXPECT_DOUBLE_EQ(symmetric_range(ramp(-1, -5), 100), 5);
}

}  // namespace
}  // namespace loopmend::test
