// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/interpolate.h"

#include "core/error.h"
#include "samples/analytic_surfaces.h"
#include "samples/paper_inputs.h"

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <cmath>
#include <cstring>
#include <functional>
#include <numbers>
#include <random>

namespace loopmend {
namespace {

TriangleSoup cube() {
  TriangleSoup soup;
  for (int k = 0; k < 8; ++k) soup.points.emplace_back(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
  soup.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return soup;
}

TriangleSoup tetrahedron(const Points& points) {
  TriangleSoup soup;
  soup.points = points;
  soup.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  return soup;
}

TriangleSoup octahedron() {
  TriangleSoup soup;
  soup.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  soup.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return soup;
}

/// Rings of n vertices each, joined by triangles; ring j, vertex i lies at place(j, angle).
TriangleSoup rings(int n, int count, const std::function<Vec3(int, double)>& place) {
  TriangleSoup soup;
  for (int j = 0; j < count; ++j)
    for (int i = 0; i < n; ++i) soup.points.push_back(place(j, 2 * std::numbers::pi * (i + 0.5 * (j % 2)) / n));
  for (int j = 0; j + 1 < count; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * n + i, b = j * n + (i + 1) % n, c = a + n, d = b + n;
      if (j % 2 == 0)
        soup.triangles.insert(soup.triangles.end(), {{a, b, c}, {b, d, c}});
      else
        soup.triangles.insert(soup.triangles.end(), {{a, b, d}, {a, d, c}});
    }
  return soup;
}

/// Largest distance from the sphere, in its radius.
double off_the_sphere(const Interpolation& result, double radius, const Vec3& center = Vec3::Zero()) {
  double worst = 0;
  for (const Vec3& p : result.surface.points) worst = std::max(worst, std::abs((p - center).norm() / radius - 1));
  return worst;
}

Interpolation interpolated(const TriangleSoup& soup, int subdivisions) {
  SubdivisionOptions options;
  options.subdivisions = subdivisions;
  options.boundary = PolyhedronBoundary::smooth;
  return interpolate_points(make_surface_model(soup), options, EvolutionOptions{}, {});
}

void expect_valid(const Interpolation& result) {
  EXPECT_EQ(result.outcome.status, PatchStatus::converged) << result.outcome.message;
  EXPECT_TRUE(result.outcome.validity.is_clean());
}

TEST(InterpolatePoints, ADodecahedronBecomesTheSphere) {
  const TriangleSoup dodecahedron = make_dodecahedron();
  ASSERT_EQ(dodecahedron.points.size(), 20u);
  ASSERT_EQ(dodecahedron.triangles.size(), 36u);
  const Interpolation result = interpolate_points(make_surface_model(dodecahedron), {}, EvolutionOptions{}, {});
  expect_valid(result);
  EXPECT_EQ(result.outcome.patch.free_count, 1134);
  EXPECT_LT(off_the_sphere(result, 1), 1e-5);
  ASSERT_EQ(result.fixed_count, 20);
  EXPECT_EQ(std::memcmp(result.surface.points.data(), dodecahedron.points.data(), 20 * sizeof(Vec3)), 0);
}

TEST(InterpolatePoints, SoDoIcosahedronAndCubeAtEverySubdivision) {
  const std::vector<double> icosahedral{1e-4, 3e-6, 3e-6},
      cubic{1e-3, 3e-5, 3e-6};  // then the flow stops before the fits do
  for (int k : {2, 3, 4}) {
    const Interpolation ball = interpolated(make_icosphere(0), k), box = interpolated(cube(), k);
    expect_valid(ball);
    EXPECT_LT(off_the_sphere(ball, 1), icosahedral[k - 2]) << k;
    expect_valid(box);
    EXPECT_LT(off_the_sphere(box, std::sqrt(3.0)), cubic[k - 2]) << k;
  }
}

TEST(InterpolatePoints, OnlyTheNamedVerticesAreHeld) {
  const TriangleSoup ball = make_icosphere(1);
  TriangleSoup scattered = ball;
  for (std::size_t i = 12; i < scattered.points.size(); ++i) scattered.points[i] *= 0.9;  // dents between the corners
  SubdivisionOptions subdivision;
  subdivision.subdivisions = 2;
  for (int i = 0; i < 12; ++i) subdivision.fixed.push_back(i);
  const Interpolation result = interpolate_points(make_surface_model(scattered), subdivision, EvolutionOptions{}, {});
  expect_valid(result);
  EXPECT_EQ(result.fixed_count, 12);
  EXPECT_LT(off_the_sphere(result, 1), 1e-3);
}

// Patches without loops had an infinite radius, and the flow stopped at its first bold step.
TEST(InterpolatePoints, SoDoTetrahedronAndOctahedron) {
  const TriangleSoup four = tetrahedron({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}});
  const std::vector<double> tetrahedral{0.01, 1e-3, 1e-4}, octahedral{2e-3, 4e-5, 4e-6};
  for (int k : {2, 3, 4}) {
    const Interpolation ball = interpolated(four, k), other = interpolated(octahedron(), k);
    expect_valid(ball);
    EXPECT_LT(off_the_sphere(ball, std::sqrt(3.0)), tetrahedral[k - 2]) << k;
    expect_valid(other);
    EXPECT_LT(off_the_sphere(other, 1), octahedral[k - 2]) << k;
  }
}

TEST(InterpolatePoints, AnyFourPointsGiveTheSphereThroughThem) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto shake = [&]() -> Vec3 { return 0.8 * Vec3(unit(random), unit(random), unit(random)); };
  for (int seed = 0; seed < 12; ++seed) {
    const Points p{Vec3(1, 1, 1) + shake(), Vec3(1, -1, -1) + shake(), Vec3(-1, 1, -1) + shake(),
                   Vec3(-1, -1, 1) + shake()};
    Eigen::Matrix3d A;
    Vec3 b;
    for (int i = 0; i < 3; ++i) {
      A.row(i) = 2 * (p[i + 1] - p[0]).transpose();
      b[i] = p[i + 1].squaredNorm() - p[0].squaredNorm();
    }
    const Vec3 center = A.partialPivLu().solve(b);
    for (int k : {2, 3, 4}) {
      const Interpolation ball = interpolated(tetrahedron(p), k);
      EXPECT_TRUE(ball.outcome.validity.is_clean());
      if (k > 2) {  // on 34 vertices one of twelve stalls
        EXPECT_EQ(ball.outcome.status, PatchStatus::converged) << seed;
      }
      const double off = off_the_sphere(ball, (p[0] - center).norm(), center);
      EXPECT_LT(off, k < 4 ? 0.05 : 3e-3) << seed;
    }
  }
}

TEST(InterpolatePoints, AnOpenPolyhedronGetsSmoothBoundaries) {
  TriangleSoup box = cube();
  box.triangles.erase(box.triangles.begin() + 2, box.triangles.begin() + 4);  // the lid
  EXPECT_THROW(interpolate_points(make_surface_model(box), {}, EvolutionOptions{}, {}), InvalidArgument);
  const Interpolation result = interpolated(box, 3);
  expect_valid(result);
  ASSERT_EQ(result.fixed_count, 8 + 4 * 7);
  for (int i = 8; i < result.fixed_count; ++i) {
    EXPECT_NEAR(result.surface.points[i].z(), 1, 1e-12);
    EXPECT_NEAR(result.surface.points[i].norm(), std::sqrt(3.0), 1e-9);  // the circle through the boundary's corners
  }
  EXPECT_EQ(std::memcmp(result.surface.points.data(), box.points.data(), 8 * sizeof(Vec3)), 0);
  EXPECT_LT(off_the_sphere(result, std::sqrt(3.0)), 3e-3);
}

// Vertices on a surface, boundaries that wave up and down on it. Twice as many vertices: at least eight times as near.
TEST(InterpolatePoints, OpenPatchesOfSphereAndCylinderComeOutNearThem) {
  double last_cap = 1, last_tube = 1;
  for (int n : {6, 12, 24}) {
    const TriangleSoup cap = rings(n, n / 3 + 1, [&](int j, double t) {
      const double inward = 0.4, angle = inward + (1 - inward) * 3 * j / n * (1 + 0.2 * std::cos(2 * t));
      return Vec3(std::sin(angle) * std::cos(t), std::sin(angle) * std::sin(t), std::cos(angle));
    });
    const TriangleSoup tube = rings(n, n / 3 + 1, [&](int j, double t) {
      return Vec3(std::cos(t), std::sin(t), (6.0 * j / n - 1) * (1 + 0.15 * std::cos(3 * t)));
    });
    const Interpolation belt = interpolated(cap, 2), cylinder = interpolated(tube, 2);
    expect_valid(belt);
    expect_valid(cylinder);
    const double off_cap = off_the_sphere(belt, 1);
    double off_tube = 0;
    for (const Vec3& p : cylinder.surface.points) off_tube = std::max(off_tube, std::abs(std::hypot(p.x(), p.y()) - 1));
    EXPECT_LT(off_cap, last_cap / 8) << n;
    EXPECT_LT(off_tube, last_tube / 8) << n;
    last_cap = off_cap;
    last_tube = off_tube;
  }
  EXPECT_LT(last_cap, 1e-5);
  EXPECT_LT(last_tube, 1e-5);
}

TEST(InterpolatePoints, RefusesWhatIsNoPolyhedron) {
  TriangleSoup triangle;
  triangle.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.triangles = {{0, 1, 2}};
  EXPECT_THROW(interpolate_points(make_surface_model(triangle), {}, EvolutionOptions{}, {}), InvalidArgument);
  TriangleSoup fin = cube();
  fin.points.emplace_back(3, 0, 0);
  fin.triangles.push_back({1, 3, 8});
  EXPECT_THROW(interpolate_points(make_surface_model(fin), {}, EvolutionOptions{}, {}), InvalidArgument);
  SubdivisionOptions wrong;
  wrong.subdivisions = 9;
  EXPECT_THROW(interpolate_points(make_surface_model(cube()), wrong, EvolutionOptions{}, {}), InvalidArgument);
  wrong = {};
  wrong.fixed = {0, 1, 2};
  EXPECT_THROW(interpolate_points(make_surface_model(cube()), wrong, EvolutionOptions{}, {}), InvalidArgument);
}

}  // namespace
}  // namespace loopmend
