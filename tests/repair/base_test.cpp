// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/base.h"

#include "core/error.h"
#include "repair/watertight.h"
#include "samples/analytic_surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace loopmend {
namespace {

BoundaryLoop only_loop(const SurfaceModel& model) {
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  EXPECT_EQ(loops.size(), 1U);
  return loops.front();
}

TEST(Base, StandsStraightUnderADome) {
  const SurfaceModel model =
      make_surface_model(trim_boundaries(cut(make_icosphere(4), [](const Vec3& p) { return p.z() < 0.3; })));
  const BoundaryLoop loop = only_loop(model);
  const TriangleSoup soup = with_base(model, loop, 0.5);
  const Watertightness found = watertightness(soup);
  EXPECT_TRUE(found.printable());
  double lowest_of_loop = 1;
  for (int v : loop.vertices) lowest_of_loop = std::min(lowest_of_loop, model.mesh.point(TriMesh::VertexHandle(v)).z());
  double lowest = 1;
  for (std::size_t v = model.soup.points.size(); v < soup.points.size(); ++v)
    lowest = std::min(lowest, soup.points[v].z());
  EXPECT_NEAR(lowest, lowest_of_loop - 0.5, 1e-3);  // the loop's own plane leans by its raggedness
  for (std::size_t v = 0; v < model.soup.points.size(); ++v) ASSERT_EQ(soup.points[v], model.soup.points[v]);
  // The cap of a ball above 0.3, and a cylinder of the loop's radius below.
  const double pi = std::acos(-1.0), height = 0.7, radius2 = 1 - 0.09;
  EXPECT_NEAR(found.volume, pi * height * height * (3 - height) / 3 + pi * radius2 * 0.5, 0.12);
}

TEST(Base, OfAnExactTubeIsExact) {
  TriangleSoup tube = make_cylinder(2, 32);
  const SurfaceModel model = make_surface_model(tube);
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  ASSERT_EQ(loops.size(), 2U);
  for (const BoundaryLoop& loop : loops) {
    const TriangleSoup soup = with_base(model, loop, 0.75);
    double low = 0, high = 0;
    for (const Vec3& p : soup.points) {
      EXPECT_NEAR(p.head<2>().norm(), 1,
                  1e-12);  // no vertex within: the plane's triangles have the corners of the wall
      low = std::min(low, p.z());
      high = std::max(high, p.z());
    }
    EXPECT_NEAR(high - low, 2.75, 1e-12);
    const std::vector<BoundaryLoop> left = find_boundary_loops(make_surface_model(soup));
    ASSERT_EQ(left.size(), 1U);
    EXPECT_NEAR((left.front().center - loop.center).norm(), 2, 1e-9);  // the other end
  }
}

/// Under z = f over the square from -1 to 1: the volume is 4 (mean of f - lowest f + distance).
TEST(Base, LiesBehindASheetOfAnyShape) {
  const auto volume_under = [](const std::function<double(double, double)>& f) {
    const SurfaceModel sheet = make_surface_model(make_graph(f, 1, 32));
    const Watertightness found = watertightness(with_base(sheet, only_loop(sheet), 0.5));
    EXPECT_TRUE(found.printable());
    return found.volume;
  };
  EXPECT_NEAR(volume_under([](double, double) { return 0; }), 2, 1e-9);
  EXPECT_NEAR(volume_under([](double x, double y) { return x * x - y * y; }), 4 * 1.5, 0.01);
  EXPECT_NEAR(volume_under([](double x, double y) { return 0.4 * (x * x + y * y); }), 4 * (0.8 / 3 + 0.5), 0.01);
  EXPECT_NEAR(volume_under([](double x, double y) { return -0.4 * (x * x + y * y); }), 4 * (0.8 - 0.8 / 3 + 0.5), 0.01);
}

TEST(Base, RefusesWhatItWouldCut) {
  const SurfaceModel dome = make_surface_model(cut(make_icosphere(3), [](const Vec3& p) { return p.z() < 0.3; }));
  EXPECT_THROW(with_base(dome, only_loop(dome), 0), InvalidArgument);
  EXPECT_THROW(with_base(dome, only_loop(dome), -1), InvalidArgument);
  // Another ball in the way of the wall.
  TriangleSoup other = make_icosphere(2);
  for (Vec3& p : other.points) p += Vec3(1, 0, -1);
  const SurfaceModel both =
      make_surface_model(joined({cut(make_icosphere(3), [](const Vec3& p) { return p.z() < 0.3; }), other}));
  EXPECT_THROW(with_base(both, only_loop(both), 1), InvalidArgument);
}

}  // namespace
}  // namespace loopmend
