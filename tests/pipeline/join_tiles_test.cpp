// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/join_tiles.h"

#include "mesh/boundary_loops.h"
#include "mesh/pieces.h"
#include "mesh/self_intersections.h"
#include "pipeline/fill_holes.h"
#include "samples/analytic_surfaces.h"
#include "samples/paper_inputs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace loopmend {
namespace {

double height(double x, double y) { return 0.1 * std::sin(2 * x) * std::cos(y); }

/// A tile two wide of one wavy sheet, with its corner and its distance from the sheet.
TriangleSoup tile(double x, double y, double apart, int cells) {
  TriangleSoup soup = make_graph([&](double s, double t) { return height(s + x, t + y) + apart; }, 1, cells);
  for (Vec3& p : soup.points) p += Vec3(x, y, 0);
  return soup;
}

JoinedTiles join(SurfaceModel& model, double distance) {
  return join_tiles(model, distance, [&](TriangleSoup soup) { model = make_surface_model(std::move(soup)); });
}

int parts(const SurfaceModel& model) {
  int count = 0;
  parts_of_points(model, count);
  return count;
}

TEST(JoinTiles, MakesOneSheetOfFourWithHolesForGaps) {
  SurfaceModel model = make_surface_model(
      joined({tile(0, 0, 0, 20), tile(1.8, 0, 0.005, 23), tile(0, 1.8, -0.004, 22), tile(1.75, 1.85, 0.008, 19)}));
  const JoinedTiles done = join(model, 0.03);
  EXPECT_GT(done.removed_faces, 100U);
  EXPECT_GE(done.bridges, 6U);
  EXPECT_EQ(parts(model), 1);
  fill_all_holes(model);
  EXPECT_EQ(find_boundary_loops(model).size(), 1U);
  EXPECT_TRUE(self_intersections(model.soup.points, model.soup.triangles, static_cast<int>(model.soup.triangles.size()))
                  .empty());
  for (const int v : model.soup_vertex) {
    const Vec3& p = model.soup.points[static_cast<std::size_t>(v)];
    EXPECT_NEAR(p.z(), height(p.x(), p.y()), 0.012);
  }
}

/// Their gap runs round the ball: a bent slot, and no outline of a sheet.
TEST(JoinTiles, ClosesABallOfTwoTiles) {
  TriangleSoup upper = cut(make_icosphere(4), [](const Vec3& p) { return p.z() < -0.2 + 0.3 * p.x(); });
  TriangleSoup lower = cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.3 + 0.3 * p.x(); });
  for (Vec3& p : lower.points) p = 1.004 * Vec3(p.y(), -p.x(), p.z());
  SurfaceModel model = make_surface_model(joined({upper, lower}));
  ASSERT_EQ(parts(model), 2);
  EXPECT_EQ(join(model, 0.01).bridges, 1U);
  fill_all_holes(model);
  EXPECT_TRUE(find_boundary_loops(model).empty());
  for (const int v : model.soup_vertex) EXPECT_NEAR(model.soup.points[static_cast<std::size_t>(v)].norm(), 1, 0.006);
}

TEST(JoinTiles, DropsATileThatLiesOnAnotherAltogether) {
  TriangleSoup small = tile(0, 0, 0.004, 9);
  for (Vec3& p : small.points) p = Vec3(p.x() / 2, p.y() / 2, height(p.x() / 2, p.y() / 2) + 0.004);
  const TriangleSoup large = tile(0, 0, 0, 20);
  SurfaceModel model = make_surface_model(joined({small, large}));
  const JoinedTiles done = join(model, 0.01);
  EXPECT_EQ(done.removed_faces, small.triangles.size());
  EXPECT_EQ(done.removed_parts, 1U);
  EXPECT_EQ(done.bridges, 0U);
  EXPECT_EQ(model.soup.triangles.size(), large.triangles.size());
}

/// A blister of the smaller tile, too high for the length: it would be left over the other tile as a part of its own.
TEST(JoinTiles, DropsFragmentsThatAreCutOff) {
  const TriangleSoup large = tile(0, 0, 0, 30);
  TriangleSoup small = tile(1.2, 0, 0.003, 28);
  for (Vec3& p : small.points) p.z() += 0.02 * std::exp(-((p.x() - 0.6) * (p.x() - 0.6) + p.y() * p.y()) / 0.02);
  SurfaceModel model = make_surface_model(joined({large, small}));
  join(model, 0.01);
  EXPECT_EQ(parts(model), 1);
}

TEST(JoinTiles, LeavesWhatLiesApartOrLooksTheOtherWay) {
  SurfaceModel far = make_surface_model(joined({tile(0, 0, 0, 20), tile(1.8, 0, 0.05, 23)}));
  EXPECT_EQ(join(far, 0.03).removed_faces, 0U);
  TriangleSoup back = tile(0.2, 0, -0.01, 20);
  for (Triangle& t : back.triangles) std::swap(t[1], t[2]);
  SurfaceModel plate = make_surface_model(joined({tile(0, 0, 0, 20), back}));
  EXPECT_EQ(join(plate, 0.03).removed_faces, 0U);
  SurfaceModel beside = make_surface_model(joined({tile(0, 0, 0, 20), tile(2.2, 0, 0, 20)}));
  EXPECT_EQ(join(beside, 0.03).removed_faces, 0U);
}

/// Stitching joins these; faces along a crack are no overlap.
TEST(JoinTiles, LeavesPartsThatAbut) {
  for (const double gap : {0.0, 1e-6, 0.02})
    for (const double shift : {0.0, 0.03}) {
      SurfaceModel model = make_surface_model(joined({tile(0, 0, 0, 20), tile(2 + gap, shift, gap / 4, 20)}));
      EXPECT_EQ(join(model, 0.05).removed_faces, 0U) << gap << ' ' << shift;
    }
}

/// A tile with ripples that are higher than the length.
TriangleSoup rippled_tile() {
  TriangleSoup soup = tile(1.2, 0, 0.003, 40);
  for (Vec3& p : soup.points) p.z() += 0.03 * std::sin(60 * p.x()) * std::sin(50 * p.y());
  return soup;
}

TEST(JoinTiles, LeavesNoFaceThatCutsALargerTile) {
  SurfaceModel model = make_surface_model(joined({tile(0, 0, 0, 45), rippled_tile()}));
  EXPECT_GT(join(model, 0.01).removed_faces, 0U);
  EXPECT_TRUE(self_intersections(model.soup.points, model.soup.triangles, static_cast<int>(model.soup.triangles.size()))
                  .empty());
}

/// Triangles with one neighbour at most.
std::size_t ears(const TriangleSoup& soup) {
  std::map<std::pair<int, int>, int> faces;
  const auto edge = [](const Triangle& t, std::size_t c) -> std::pair<int, int> {
    return std::minmax({t[c], t[(c + 1) % 3]});
  };
  for (const Triangle& t : soup.triangles)
    for (std::size_t c = 0; c < 3; ++c) ++faces[edge(t, c)];
  return static_cast<std::size_t>(std::ranges::count_if(soup.triangles, [&](const Triangle& t) {
    return (faces[edge(t, 0)] == 1) + (faces[edge(t, 1)] == 1) + (faces[edge(t, 2)] == 1) >= 2;
  }));
}

TEST(JoinTiles, LeavesNoTeethAtTheCut) {
  const std::vector<TriangleSoup> tiles{tile(0, 0, 0, 45), rippled_tile()};
  SurfaceModel model = make_surface_model(joined(tiles));
  join(model, 0.01);
  EXPECT_LE(ears(model.soup), ears(tiles[0]) + ears(tiles[1]));
}

/// Triangles with a back: the edges of a strip to one would have three faces.
TEST(JoinTiles, LaysNoStripToAScrap) {
  TriangleSoup scraps;
  for (int k = -9; k <= 9; ++k) {
    const double y = 0.1 * k, z = height(0.78, y);
    const int first = static_cast<int>(scraps.points.size());
    for (const Vec3& p : {Vec3(0.77, y, z), Vec3(0.78, y - 0.01, z), Vec3(0.78, y + 0.01, z)})
      scraps.points.push_back(p);
    scraps.triangles.push_back({first, first + 1, first + 2});
    scraps.triangles.push_back({first, first + 2, first + 1});
  }
  SurfaceModel model = make_surface_model(joined({tile(0, 0, 0, 20), tile(1.8, 0, 0.005, 23), scraps}));
  EXPECT_EQ(join(model, 0.03).bridges, 2U);
  std::map<std::pair<int, int>, int> faces;
  for (const Triangle& t : model.soup.triangles)
    for (std::size_t c = 0; c < 3; ++c) {
      const int v = t[c], w = t[(c + 1) % 3];
      EXPECT_LE(++faces[std::minmax({v, w})], 2);
    }
}

}  // namespace
}  // namespace loopmend
