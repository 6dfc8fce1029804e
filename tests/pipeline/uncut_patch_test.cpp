// SPDX-License-Identifier: GPL-3.0-or-later
// A hole whose ordinary patches run through something that stands in it.
#include "filling/loop_patch.h"
#include "filling/triangulate_loop.h"
#include "mesh/self_intersections.h"
#include "pipeline/fill_holes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace loopmend {
namespace {

constexpr double height = 0.5;

/// A ring whose inner edge is a saddle, z = height cos 2φ, and in the middle a small tetrahedron, closed, from
/// −0.4 to 1.6 of the height, up or down: it stands in the way of the ridge or of the valley.
SurfaceModel saddle_with_post(int n, double sign) {
  TriangleSoup soup;
  for (double radius : {1.0, 2.0})
    for (int k = 0; k < n; ++k) {
      const double angle = 2 * std::numbers::pi * k / n;
      soup.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                               radius == 1 ? height * std::cos(2 * angle) : 0);
    }
  for (int k = 0; k < n; ++k) {
    const int next = (k + 1) % n;
    soup.triangles.push_back({k, n + k, n + next});
    soup.triangles.push_back({k, n + next, next});
  }
  const int first = 2 * n;
  const double foot = -0.4 * sign * height;
  soup.points.insert(soup.points.end(), {Vec3(0.05, 0, foot), Vec3(-0.03, 0.04, foot), Vec3(-0.03, -0.04, foot),
                                         Vec3(0.001, 0.002, 1.6 * sign * height)});
  for (const Triangle& t : {Triangle{0, 2, 1}, Triangle{0, 1, 3}, Triangle{1, 2, 3}, Triangle{2, 0, 3}})
    soup.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  return make_surface_model(std::move(soup));
}

BoundaryLoop inner_loop(const SurfaceModel& model) {
  std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  return *std::min_element(loops.begin(), loops.end(),
                           [](const BoundaryLoop& a, const BoundaryLoop& b) { return a.perimeter < b.perimeter; });
}

int cuts_of(const SurfaceModel& model) {
  const TriangleSoup& soup = model.soup;
  return static_cast<int>(
      self_intersections(soup.points, soup.triangles, static_cast<int>(soup.triangles.size())).size());
}

TEST(UncutPatch, GoesAnotherWayWhereOrdinaryPatchesCut) {
  int in_the_way = 0;
  for (double sign : {1.0, -1.0}) {
    SurfaceModel model = saddle_with_post(4, sign);
    ASSERT_EQ(cuts_of(model), 0);
    const BoundaryLoop loop = inner_loop(model);
    SurfaceModel plain = model;
    append_patch(plain, patch_geometry(make_patch(plain, {loop}, {*fill_loop(plain, loop, {}, {}).patch})));
    const bool cut = cuts_of(plain) > 0;
    in_the_way += cut;
    const HoleResult result = fill_holes(model, {loop}, {}, nullptr, {}).at(0);
    ASSERT_TRUE(is_filled(result.status)) << result.message;
    EXPECT_EQ(cuts_of(model), 0);
    const std::vector<std::string>& attempts = result.outcome().attempts;
    EXPECT_EQ(std::count(attempts.begin(), attempts.end(), "from triangles that cut nothing"), cut ? 1 : 0);
  }
  EXPECT_GE(in_the_way, 1);
}

TEST(UncutPatch, IsRefinedAndCutsNothing) {
  for (double sign : {1.0, -1.0}) {
    SurfaceModel model = saddle_with_post(24, sign);
    const ScanIndex scan(model);
    const BoundaryLoop loop = inner_loop(model);
    const LoopPatchOutcome outcome = fill_loop_uncut(model, scan.index, loop, {}, {});
    ASSERT_TRUE(outcome.patch);
    EXPECT_GT(outcome.patch->points.size(), 24U);
    EXPECT_EQ(outcome.quality.intersections, 0);
    append_patch(model, patch_geometry(make_patch(model, {loop}, {*outcome.patch})));
    EXPECT_EQ(cuts_of(model), 0);
    EXPECT_EQ(find_boundary_loops(model).size(), 1U);
  }
}

TEST(UncutPatch, IsNotMadeWhereSomethingRunsThroughTheBoundary) {
  SurfaceModel model = saddle_with_post(4, 1);
  const BoundaryLoop loop = inner_loop(model);
  Points points = model.soup.points;
  Triangles neighborhood = model.soup.triangles;
  std::vector<int> places;
  for (int v : loop.vertices) places.push_back(model.soup_vertex[v]);
  EXPECT_EQ(triangulate_loop_uncut(points, neighborhood, places, {}, {}).size(), 2U);
  // A triangle about the middle of an edge of the loop.
  const Vec3 middle = (points[places[0]] + points[places[1]]) / 2;
  const Vec3 along = (points[places[1]] - points[places[0]]).normalized();
  const Vec3 side = along.cross(Vec3(0, 0, 1)).normalized(), up = side.cross(along);
  const int first = static_cast<int>(points.size());
  for (const Vec3& d : {Vec3(side + up), Vec3(-side + up), Vec3(-up)}) points.push_back(middle + 0.2 * d);
  neighborhood.push_back({first, first + 1, first + 2});
  EXPECT_TRUE(triangulate_loop_uncut(points, neighborhood, places, {}, {}).empty());
}

}  // namespace
}  // namespace loopmend
