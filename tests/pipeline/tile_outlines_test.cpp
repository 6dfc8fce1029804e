// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/tile_outlines.h"

#include "samples/analytic_surfaces.h"
#include "samples/paper_inputs.h"

#include <gtest/gtest.h>

#include <cmath>

namespace loopmend {
namespace {

/// Two tiles of one wavy sheet, the second begins so far along x.
OverlappingOutlines of_two_tiles(double begin, double apart) {
  const auto height = [](double x, double y) { return 0.1 * std::sin(2 * x) * std::cos(y); };
  const TriangleSoup first = make_graph(height, 1, 20);
  TriangleSoup second = make_graph([&](double x, double y) { return height(x + begin, y) + apart; }, 1, 23);
  for (Vec3& p : second.points) p.x() += begin;
  const SurfaceModel model = make_surface_model(joined({first, second}));
  return find_overlapping_outlines(model, find_boundary_loops(model));
}

TEST(TileOutlines, TilesThatLieOnEachOtherAreCounted) {
  EXPECT_EQ(of_two_tiles(1.2, 0.005).count, 2U);
  EXPECT_EQ(of_two_tiles(0.8, 0).count, 2U);
  EXPECT_NEAR(of_two_tiles(1.2, 0.005).distance, 1.5 * 0.005, 0.002);
}

/// Its vertices lie over those of the ball.
TEST(TileOutlines, ACopyOfAPartOfABallIsCounted) {
  TriangleSoup tile = cut(make_icosphere(4), [](const Vec3& p) { return p.z() < 0.8; });
  for (Vec3& p : tile.points) p *= 1.004;
  const SurfaceModel model = make_surface_model(joined({make_icosphere(4), tile}));
  EXPECT_EQ(find_overlapping_outlines(model, find_boundary_loops(model)).count, 1U);
}

/// Their boundaries are no outlines of sheets.
TEST(TileOutlines, HalvesOfABallThatOverlapAreCounted) {
  const TriangleSoup upper = cut(make_icosphere(4), [](const Vec3& p) { return p.z() < -0.2; });
  TriangleSoup lower = cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.2; });
  for (Vec3& p : lower.points) p *= 1.004;
  const SurfaceModel model = make_surface_model(joined({upper, lower}));
  EXPECT_EQ(find_overlapping_outlines(model, find_boundary_loops(model)).count, 2U);
}

TEST(TileOutlines, TilesBesideOrFarAboveEachOtherAreNot) {
  EXPECT_EQ(of_two_tiles(2, 0).count, 0U);
  EXPECT_EQ(of_two_tiles(2.1, 0).count, 0U);
  EXPECT_EQ(of_two_tiles(1.9999, 1e-4).count, 0U);  // a crack
  EXPECT_EQ(of_two_tiles(1.2, 0.4).count, 0U);
}

}  // namespace
}  // namespace loopmend
