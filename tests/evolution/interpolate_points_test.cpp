#include "evolution/interpolate_points.h"

#include "core/error.h"
#include "samples/analytic_surfaces.h"
#include "samples/paper_inputs.h"

#include <gtest/gtest.h>

#include <cstring>

namespace loopmend {
namespace {

TriangleSoup cube() {
  TriangleSoup soup;
  for (int k = 0; k < 8; ++k) soup.points.emplace_back(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
  soup.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return soup;
}

/// Largest distance from the sphere through the fixed vertices, in its radius.
double off_the_sphere(const Interpolation& result, double radius) {
  double worst = 0;
  for (const Vec3& p : result.surface.points) worst = std::max(worst, std::abs(p.norm() / radius - 1));
  return worst;
}

void expect_valid(const Interpolation& result) {
  EXPECT_EQ(result.evolved.status, EvolutionStatus::converged) << result.evolved.message;
  EXPECT_TRUE(result.evolved.is_valid());
}

TEST(InterpolatePoints, ADodecahedronBecomesTheSphere) {
  const TriangleSoup dodecahedron = make_dodecahedron();
  ASSERT_EQ(dodecahedron.points.size(), 20u);
  ASSERT_EQ(dodecahedron.triangles.size(), 36u);
  const Interpolation result = interpolate_points(make_surface_model(dodecahedron), {}, EvolutionOptions{}, {});
  expect_valid(result);
  EXPECT_EQ(result.evolved.patch.free_count, 1134);
  EXPECT_LT(off_the_sphere(result, 1), 3e-4);
  ASSERT_EQ(result.fixed_count, 20);
  EXPECT_EQ(std::memcmp(result.surface.points.data(), dodecahedron.points.data(), 20 * sizeof(Vec3)), 0);
}

TEST(InterpolatePoints, SoDoIcosahedronAndCubeAtEverySubdivision) {
  double last = 1;
  for (int k : {2, 3, 4}) {
    SubdivisionOptions subdivision;
    subdivision.subdivisions = k;
    const Interpolation ball =
        interpolate_points(make_surface_model(make_icosphere(0)), subdivision, EvolutionOptions{}, {});
    expect_valid(ball);
    EXPECT_LT(off_the_sphere(ball, 1), last / 3);
    last = off_the_sphere(ball, 1);
  }
  const Interpolation box = interpolate_points(make_surface_model(cube()), {}, EvolutionOptions{}, {});
  expect_valid(box);
  EXPECT_LT(off_the_sphere(box, std::sqrt(3.0)), 3e-3);
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

TEST(InterpolatePoints, AnOpenPolyhedronKeepsItsRims) {
  TriangleSoup box = cube();
  box.triangles.erase(box.triangles.begin() + 2, box.triangles.begin() + 4);  // the lid
  SubdivisionOptions subdivision;
  EXPECT_THROW(interpolate_points(make_surface_model(box), subdivision, EvolutionOptions{}, {}), InvalidArgument);
  subdivision.rim = PolyhedronRim::keep;
  const Interpolation result = interpolate_points(make_surface_model(box), subdivision, EvolutionOptions{}, {});
  expect_valid(result);
  EXPECT_EQ(result.fixed_count, 8 + 4 * 7);
  for (int i = 8; i < result.fixed_count; ++i) EXPECT_EQ(result.surface.points[i].z(), 1);
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
