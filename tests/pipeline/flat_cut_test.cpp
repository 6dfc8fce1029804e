// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/flat_cut.h"

#include "pipeline/fill_holes.h"
#include "samples/analytic_surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace loopmend {
namespace {

/// A surface of revolution about z, open above in a plane.
SurfaceModel open_above(const std::function<double(double)>& radius, double top) {
  return make_surface_model(make_revolution(radius, 0, top, 40, 64));
}

BoundaryLoop upper(const SurfaceModel& model) {
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  return loops[0].center.z() > loops[1].center.z() ? loops[0] : loops[1];
}

TEST(FlatCut, IsTheEndOfATubeAndOfACone) {
  const SurfaceModel tube = open_above([](double) { return 1.0; }, 3);
  EXPECT_TRUE(is_flat_cut(tube, upper(tube)));
  const SurfaceModel cone = open_above([](double z) { return 2 - 0.3 * z; }, 3);
  EXPECT_TRUE(is_flat_cut(cone, upper(cone)));
  const SurfaceModel bell = open_above([](double z) { return 1 + 0.05 * z * z; }, 3);
  EXPECT_TRUE(is_flat_cut(bell, upper(bell)));
}

TEST(FlatCut, IsNotWhatIsMissingOfABallOrInAPlane) {
  for (double top : {-0.2, 0.3, 0.7}) {
    const SurfaceModel ball =
        make_surface_model(make_revolution([](double z) { return std::sqrt(1 - z * z); }, -0.9, top, 40, 64));
    EXPECT_FALSE(is_flat_cut(ball, upper(ball))) << top;
  }
  const SurfaceModel ragged =
      make_surface_model(cut(make_cylinder(4, 48), [](const Vec3& p) { return p.z() > 0.3 * p.x(); }));
  for (const BoundaryLoop& loop : find_boundary_loops(ragged))
    EXPECT_EQ(is_flat_cut(ragged, loop), loop.planarity < 0.003);
}

TEST(FlatCut, IsClosedByAPlane) {
  SurfaceModel tube = open_above([](double) { return 1.0; }, 3);
  const std::size_t before = tube.soup.points.size();
  for (const HoleResult& result : fill_all_holes(tube)) {
    EXPECT_EQ(result.outcome().made_by, "flat cap") << result.message;
    EXPECT_NE(result.reason().find("boundary exact"), std::string::npos);
  }
  ASSERT_GT(tube.soup.points.size(), before + 100);
  for (std::size_t v = before; v < tube.soup.points.size(); ++v) {
    const double z = tube.soup.points[v].z();
    EXPECT_NEAR(std::min(std::abs(z), std::abs(z - 3)), 0, 1e-9);
  }
}

}  // namespace
}  // namespace loopmend
