// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/tiny_hole.h"

#include "core/random.h"
#include "pipeline/fill_holes.h"
#include "samples/analytic_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace loopmend {
namespace {

/// Without the triangles of these numbers.
SurfaceModel model_without(TriangleSoup soup, const std::set<int>& gone) {
  Triangles left;
  for (int f = 0; f < static_cast<int>(soup.triangles.size()); ++f)
    if (!gone.contains(f)) left.push_back(soup.triangles[f]);
  soup.triangles = std::move(left);
  return make_surface_model(std::move(soup));
}

/// All triangles at a vertex.
std::set<int> star(const TriangleSoup& soup, int vertex) {
  std::set<int> at;
  for (int f = 0; f < static_cast<int>(soup.triangles.size()); ++f)
    for (int v : soup.triangles[f])
      if (v == vertex) at.insert(f);
  return at;
}

std::optional<GroupResult> closed(const SurfaceModel& model, const GroupOptions& options = {}) {
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  EXPECT_EQ(loops.size(), 1u);
  return close_tiny_hole(ScanIndex(model), loops.front(), options, 2);
}

/// Every 40th triangle that touches none taken before.
std::set<int> scattered(const TriangleSoup& soup) {
  std::set<int> gone, used;
  for (int f = 0; f < static_cast<int>(soup.triangles.size()); f += 40) {
    const Triangle& t = soup.triangles[f];
    if (used.contains(t[0]) || used.contains(t[1]) || used.contains(t[2])) continue;
    used.insert(t.begin(), t.end());
    gone.insert(f);
  }
  return gone;
}

TEST(TinyHole, AMissingTriangleIsPutBack) {
  const TriangleSoup whole = make_icosphere(3);
  const auto found = closed(model_without(whole, {100}));
  ASSERT_TRUE(found);
  const PatchResult& result = *found->patches.front();
  EXPECT_EQ(result.status, PatchStatus::filled);
  EXPECT_EQ(result.patch.free_count, 0);
  EXPECT_EQ(result.patch.patch_triangles, 1);
  EXPECT_EQ(result.made_by, "few triangles");
  EXPECT_EQ(worst(result.verdicts), Grade::good);
  EXPECT_EQ(found->holes.front().patch.get(), &result);
}

TEST(TinyHole, AMissingVertexOfASphereIsFoundToFourthOrder) {
  double before = 0;
  for (int level : {3, 4, 5}) {
    const TriangleSoup whole = make_icosphere(level);
    const auto found = closed(model_without(whole, star(whole, 50)));
    ASSERT_TRUE(found) << level;
    const Patch& patch = found->patches.front()->patch;
    ASSERT_EQ(patch.free_count, 1);
    EXPECT_EQ(patch.patch_triangles, 6);
    const double off = std::abs(patch.to_mesh(patch.positions[0]).norm() - 1);
    if (level > 3) {
      EXPECT_LT(off, before / 12) << level;  // 16 in the limit
    }
    before = off;
  }
}

TEST(TinyHole, WhereTwoTrianglesAreMissingTwoAreMade) {
  const TriangleSoup whole = make_icosphere(3);
  int beside = -1;
  for (int f = 1; f < static_cast<int>(whole.triangles.size()) && beside < 0; ++f) {
    int common = 0;
    for (int v : whole.triangles[f]) common += star(whole, v).contains(0);
    if (common == 2) beside = f;
  }
  const auto found = closed(model_without(whole, {0, beside}));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->patches.front()->patch.free_count, 0);
  EXPECT_EQ(found->patches.front()->patch.patch_triangles, 2);
}

TEST(TinyHole, AQuadricHasNoBusinessAtTheEndOfATube) {
  const SurfaceModel tube = make_surface_model(make_cylinder(2, 8));
  const ScanIndex scan(tube);
  const std::vector<BoundaryLoop> loops = find_boundary_loops(tube);
  ASSERT_EQ(loops.size(), 2u);
  for (const BoundaryLoop& loop : loops) EXPECT_FALSE(close_tiny_hole(scan, loop, {}, 2));
}

TEST(TinyHole, NorWhereASharpEdgeRunsThroughTheHole) {
  const TriangleSoup roof = make_graph([](double x, double) { return -std::abs(x); }, 1, 10);
  int ridge = -1;
  for (int v = 0; v < static_cast<int>(roof.points.size()); ++v)
    if (roof.points[v].norm() < 1e-9) ridge = v;
  ASSERT_GE(ridge, 0);
  const SurfaceModel model = model_without(roof, star(roof, ridge));
  const ScanIndex scan(model);
  for (const BoundaryLoop& loop : find_boundary_loops(model))
    if (loop.edges() <= 8) {
      EXPECT_FALSE(close_tiny_hole(scan, loop, {}, 2));
    }
}

TEST(TinyHole, ALoneTriangleIsNoHole) {
  TriangleSoup lone;
  lone.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  lone.triangles = {{0, 1, 2}};
  EXPECT_FALSE(closed(make_surface_model(lone)));
}

TEST(TinyHole, WhoAsksForAFlowGetsIt) {
  const TriangleSoup whole = make_icosphere(4);
  const SurfaceModel model = model_without(whole, star(whole, 50));
  GroupOptions options;
  options.evolution->boundary = BoundaryTrust::exact;
  EXPECT_FALSE(closed(model, options));
  options = {};
  options.initial.density = 2;
  EXPECT_FALSE(closed(model, options));
  options = {};
  options.evolution.reset();
  EXPECT_FALSE(closed(model, options));
  EXPECT_FALSE(closed(make_surface_model(cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.8; }))));
}

TEST(TinyHole, HundredsInASphereLeaveItClosedWithTheSameBitsForAnyNumberOfThreads) {
  const TriangleSoup whole = make_icosphere(5);
  const std::set<int> gone = scattered(whole);
  ASSERT_GT(gone.size(), 300u);
  SurfaceModel one = model_without(whole, gone), two = model_without(whole, gone);
  FillOptions options;
  options.threads = 1;
  const std::vector<HoleResult> results = fill_all_holes(one, options);
  options.threads = 2;
  fill_all_holes(two, options);
  ASSERT_EQ(results.size(), gone.size());
  EXPECT_EQ(one.soup.points, whole.points);
  EXPECT_EQ(one.soup.triangles.size(), whole.triangles.size());
  EXPECT_TRUE(find_boundary_loops(one).empty());
  EXPECT_EQ(one.soup.triangles, two.soup.triangles);
  // What a patch keeps of the surface around it does not grow with the surface, nor with the number of holes.
  for (const HoleResult& result : results) EXPECT_LE(result.outcome().patch.vertex_count(), 12);
}

TEST(TinyHole, AGroupFromItsInitialPatchGivesTheSame) {
  const TriangleSoup whole = make_icosphere(4);
  const SurfaceModel model = model_without(whole, star(whole, 50));
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  const ScanIndex scan(model);
  const auto direct = close_tiny_hole(scan, loops.front(), {}, 2);
  const GroupResult solved = solve_group(scan, make_initial_patch(model, loops, {}, {}), {}, {}, {});
  ASSERT_TRUE(direct);
  ASSERT_EQ(solved.patches.size(), 1u);
  const PatchGeometry a = patch_geometry(direct->patches.front()->patch),
                      b = patch_geometry(solved.patches.front()->patch);
  EXPECT_EQ(a.boundary, b.boundary);
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.triangles, b.triangles);
}

/// They are solved as one group, and none has a vertex that a flow could move: nothing is estimated around them.
TEST(TinyHole, TrianglesThatTouchAreClosedWithoutALookAtTheNeighborhood) {
  for (double noise : {0.0, 0.005}) {
    TriangleSoup whole = make_icosphere(4);
    Random random(3);
    for (Vec3& p : whole.points) p *= 1 + noise * random.bell();
    const Triangle first = whole.triangles[100];
    int second = -1;
    for (int f : star(whole, first[0])) {
      const Triangle& t = whole.triangles[f];
      if (std::ranges::count(t, first[1]) + std::ranges::count(t, first[2]) == 0) second = f;
    }
    ASSERT_GE(second, 0);
    SurfaceModel model = model_without(whole, {100, second});
    const std::vector<HoleResult> holes = fill_all_holes(model);
    ASSERT_EQ(holes.size(), 2u);
    for (const HoleResult& hole : holes) {
      EXPECT_EQ(hole.status, PatchStatus::filled) << hole.message;
      EXPECT_EQ(hole.free_vertices, 0);
      EXPECT_TRUE(hole.outcome().neighborhood.empty());
    }
    EXPECT_TRUE(find_boundary_loops(model).empty());
    EXPECT_EQ(model.mesh.n_faces(), whole.triangles.size());
  }
}

}  // namespace
}  // namespace loopmend
