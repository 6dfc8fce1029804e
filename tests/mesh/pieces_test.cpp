// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/pieces.h"

#include "core/random.h"
#include "mesh/boundary_loops.h"
#include "samples/analytic_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace loopmend {
namespace {

/// A flat sheet with a square hole around the origin.
TriangleSoup sheet() {
  return cut(make_graph([](double, double) { return 0.0; }, 2, 40),
             [](const Vec3& p) { return p.cwiseAbs().maxCoeff() < 1; });
}

TriangleSoup disc(double x, double z, double radius) {
  TriangleSoup soup = cut(make_graph([](double, double) { return 0.0; }, radius, 6), [](const Vec3&) { return false; });
  for (Vec3& p : soup.points) p += Vec3(x, 0, z);
  return soup;
}

std::vector<HoleWithIslands> islands_of(const std::vector<TriangleSoup>& parts) {
  const SurfaceModel model = make_surface_model(joined(parts));
  return find_islands(model, find_boundary_loops(model));
}

TEST(FindIslands, FindsThePiecesWithinAHole) {
  const std::vector<HoleWithIslands> found = islands_of({sheet(), disc(-0.5, 0.1, 0.2), disc(0.5, -0.1, 0.3)});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].islands.size(), 2u);
}

TEST(FindIslands, LeavesWhatIsBesideAboveOrPartOfTheSheet) {
  EXPECT_TRUE(islands_of({sheet()}).empty());
  EXPECT_TRUE(islands_of({sheet(), disc(5, 0, 0.3)}).empty());
  EXPECT_TRUE(islands_of({sheet(), disc(0, 3, 0.3)}).empty());
  EXPECT_TRUE(islands_of({sheet(), disc(0.9, 0.3, 0.3)}).empty()) << "half over the rim";
}

TEST(PiecesOf, NumbersThem) {
  const SurfaceModel model = make_surface_model(joined({make_icosphere(1), make_icosphere(0)}));
  const std::vector<int> piece = pieces_of(model.mesh);
  EXPECT_EQ(piece.front(), 0);
  EXPECT_EQ(piece[79], 0);
  EXPECT_EQ(piece[80], 80);
  EXPECT_EQ(piece.back(), 80);
}

TEST(LowestConnectedVertices, AreThoseOfThePieces) {
  // Backwards, so that the lowest vertex of each piece is reached last.
  TriangleSoup soup = joined({make_icosphere(2), make_icosphere(1)});
  const int first = static_cast<int>(make_icosphere(2).points.size()), all = static_cast<int>(soup.points.size());
  std::reverse(soup.points.begin(), soup.points.end());
  for (Triangle& t : soup.triangles) t = {all - 1 - t[0], all - 1 - t[1], all - 1 - t[2]};
  TriMesh mesh = make_surface_model(soup).mesh;
  mesh.add_vertex(Vec3(9, 9, 9));
  const std::vector<int> lowest = lowest_connected_vertices(mesh);
  ASSERT_EQ(lowest.size(), static_cast<std::size_t>(all) + 1);
  for (int v = 0; v < all; ++v) ASSERT_EQ(lowest[v], v < all - first ? 0 : all - first) << v;
  EXPECT_EQ(lowest[all], all) << "it has no edge";
}

/// However low it is, and whatever the noise of its faces.
TEST(BoundaryLoops, BothEndsOfALowNoisyTubeAreHoles) {
  for (const double height : {0.1, 0.3, 0.6})
    for (const unsigned seed : {1, 2, 3}) {
      TriangleSoup tube = make_revolution([](double) { return 1; }, 0, height, 48, 4);
      Random random(seed);
      for (Vec3& p : tube.points) p += 0.008 * Vec3(random.bell(), random.bell(), random.bell());
      for (const BoundaryLoop& loop : find_boundary_loops(make_surface_model(tube)))
        EXPECT_EQ(loop.kind, LoopKind::hole) << height << ' ' << seed << ' ' << loop.onward;
    }
}

}  // namespace
}  // namespace loopmend
