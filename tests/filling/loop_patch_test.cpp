// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/loop_patch.h"

#include "core/error.h"
#include "mesh/quality.h"
#include "remeshing/constrained_remesher.h"
#include "support/patches.h"
#include "surfaces/roughen.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace loopmend {
namespace {

/// Every edge of the initial patch has two triangles, but for the loop's own, which have one, in the loop's direction.
void expect_disc(const LoopPatch& initial_patch, int boundary) {
  std::map<std::pair<int, int>, int> count;
  std::set<int> used;
  for (const Triangle& t : initial_patch.triangles)
    for (int k = 0; k < 3; ++k) {
      ++count[{t[k], t[(k + 1) % 3]}];
      used.insert(t[k]);
    }
  int open = 0;
  for (const auto& [edge, times] : count) {
    EXPECT_EQ(times, 1);
    if (count.count({edge.second, edge.first})) continue;
    ++open;
    EXPECT_EQ(edge.second, (edge.first + 1) % boundary);
  }
  EXPECT_EQ(open, boundary);
  EXPECT_EQ(used.size(), initial_patch.points.size());
  const int edges = (static_cast<int>(count.size()) + open) / 2;
  EXPECT_EQ(static_cast<int>(initial_patch.points.size()) - edges + static_cast<int>(initial_patch.triangles.size()),
            1);
}

/// Closes the model by the initial patch and checks that the result is a closed oriented surface, the input first.
void expect_closes(const SurfaceModel& model, const BoundaryLoop& loop, const LoopPatch& initial_patch) {
  expect_disc(initial_patch, loop.edges());
  for (int i = 0; i < loop.edges(); ++i)
    EXPECT_EQ(initial_patch.points[i], model.mesh.point(TriMesh::VertexHandle(loop.vertices[i])));
  SurfaceModel filled = model;
  append_patch(filled, patch_geometry(make_patch(model, {loop}, {initial_patch})));
  EXPECT_EQ(find_boundary_loops(filled).size() + 1, find_boundary_loops(model).size());
}

TEST(LoopPatch, ClosesAHoleInASphereAtTheDensityOfTheNeighborhood) {
  for (const SurfaceModel& model : {test::open_sphere(4, 0.9), test::rough_open_sphere(4, 0.7)}) {
    const BoundaryLoop loop = find_boundary_loops(model).at(0);
    const LoopPatchOutcome outcome = fill_loop(model, loop, {}, {});
    ASSERT_TRUE(outcome.patch);
    expect_closes(model, loop, *outcome.patch);
    EXPECT_EQ(outcome.quality.folds, 0);
    EXPECT_EQ(outcome.quality.intersections, 0);
    EXPECT_GT(outcome.quality.min_angle_deg, 15);
    EXPECT_EQ(outcome.message.english(), "");
    const double edge = mean_edge_length(outcome.patch->points, outcome.patch->triangles,
                                         static_cast<int>(outcome.patch->triangles.size()));
    EXPECT_NEAR(edge, loop.perimeter / loop.edges(), 0.25 * edge);
  }
}

TEST(LoopPatch, DensityScalesTheEdgeLength) {
  const SurfaceModel model = test::open_sphere(4, 0.8);
  const BoundaryLoop loop = find_boundary_loops(model).at(0);
  std::map<double, double> vertices;
  for (double density : {0.5, 1.0, 2.0})
    vertices[density] = static_cast<double>(fill_loop(model, loop, {density}, {}).patch->points.size()) - loop.edges();
  // The locked boundary keeps its own density, which blurs the factor four.
  EXPECT_GT(vertices[2] / vertices[1], 2.5);
  EXPECT_LT(vertices[2] / vertices[1], 5);
  EXPECT_GT(vertices[1] / vertices[0.5], 1.5);
  EXPECT_THROW(fill_loop(model, loop, {0}, {}), InvalidArgument);
  EXPECT_THROW(fill_loop(model, loop, {11}, {}), InvalidArgument);
}

TEST(LoopPatch, ConcaveAndSlitShapedLoops) {
  const TriangleSoup sphere = roughen(make_icosphere(5), 0.15, 0.2, 4, test::onto_sphere);
  const auto star = [](const Vec3& p) {
    const double angle = std::atan2(p.y(), p.x());
    return p.z() > 0 && p.head<2>().norm() < 0.35 + 0.15 * std::cos(5 * angle);
  };
  const auto slit = [](const Vec3& p) { return p.z() > 0 && std::abs(p.y()) < 0.06 && std::abs(p.x()) < 0.7; };
  for (const auto& shape : {std::function<bool(const Vec3&)>(star), std::function<bool(const Vec3&)>(slit)}) {
    const SurfaceModel model = make_surface_model(trim_boundaries(cut(sphere, shape)));
    const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
    ASSERT_EQ(loops.size(), 1u);
    const LoopPatchOutcome outcome = fill_loop(model, loops[0], {}, {});
    ASSERT_TRUE(outcome.patch);
    expect_closes(model, loops[0], *outcome.patch);
    EXPECT_EQ(outcome.quality.folds, 0);
    EXPECT_EQ(outcome.quality.intersections, 0);
  }
}

TEST(LoopPatch, WhereRemeshingWouldCutTheNeighborhoodThePatchGetsItsVerticesAllTheSame) {
  // A sheet with a narrow ridge along y that leans over like an ear, and a ball cut out of both.
  TriangleSoup sheet =
      make_graph([](double x, double y) { return 1.5 * std::exp(-x * x / 0.0064) * std::exp(-2 * y * y); }, 2, 100);
  for (Vec3& p : sheet.points) p.x() += p.z();
  const SurfaceModel model = make_surface_model(
      trim_boundaries(cut(sheet, [](const Vec3& p) { return (p - Vec3(0.2, 0.6, 0.5)).norm() < 0.9; })));
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  const auto hole = std::find_if(loops.begin(), loops.end(), [](const auto& l) { return l.edges() == 142; });
  ASSERT_NE(hole, loops.end());
  const LoopPatchOutcome outcome = fill_loop(model, *hole, {}, {});
  ASSERT_TRUE(outcome.patch);
  expect_closes(model, *hole, *outcome.patch);
  EXPECT_EQ(outcome.quality.intersections, 0);
  EXPECT_GT(outcome.patch->points.size(), 3 * 142u);
}

TEST(LoopPatch, ALoopOfTwoThousandEdges) {
  // A long thin tube end: 2 000 edges around, cubic search would need hours.
  const SurfaceModel model =
      make_surface_model(make_revolution([](double z) { return 1 + 0.1 * z; }, 0, 0.03, 2000, 8));
  const BoundaryLoop loop = find_boundary_loops(model).at(0);
  ASSERT_EQ(loop.edges(), 2000);
  const LoopPatchOutcome outcome = fill_loop(model, loop, {0.1}, {});
  ASSERT_TRUE(outcome.patch) << outcome.message;
  expect_disc(*outcome.patch, 2000);
}

TEST(LoopPatch, ALoopOfThreeEdges) {
  TriangleSoup soup = make_icosphere(2);
  soup.triangles.erase(soup.triangles.begin() + 10);
  const SurfaceModel triangle = make_surface_model(soup);
  const BoundaryLoop three = find_boundary_loops(triangle).at(0);
  ASSERT_EQ(three.edges(), 3);
  const LoopPatchOutcome outcome = fill_loop(triangle, three, {}, {});
  ASSERT_TRUE(outcome.patch);
  expect_closes(triangle, three, *outcome.patch);
}

TEST(LoopPatch, SaysWhyItLeavesALoop) {
  const SurfaceModel model = test::open_sphere(3, 0.8);
  BoundaryLoop loop = find_boundary_loops(model).at(0);
  for (LoopKind kind : {LoopKind::crack, LoopKind::cut}) {
    loop.kind = kind;
    const LoopPatchOutcome outcome = fill_loop(model, loop, {}, {});
    EXPECT_FALSE(outcome.patch);
    EXPECT_GT(outcome.message.english().size(), 20u);
  }
  const SurfaceModel lone = make_surface_model({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {}});
  const LoopPatchOutcome outcome = fill_loop(lone, find_boundary_loops(lone).at(0), {}, {});
  EXPECT_FALSE(outcome.patch);
  EXPECT_NE(outcome.message.english().find("single triangle"), std::string::npos);
}

TEST(LoopPatch, RefusesAPatchOfMillionsOfVertices) {
  const SurfaceModel model = make_surface_model(make_revolution([](double) { return 1.0; }, 0, 0.03, 2000, 8));
  const LoopPatchOutcome outcome = fill_loop(model, find_boundary_loops(model).at(0), {10}, {});
  EXPECT_FALSE(outcome.patch);
  EXPECT_NE(outcome.message.english().find("million"), std::string::npos) << outcome.message;
}

TEST(LoopPatch, CancelledLeavesNothing) {
  const SurfaceModel model = test::open_sphere(4, 0.5);
  const CancelToken cancel;
  cancel.cancel();
  EXPECT_FALSE(fill_loop(model, find_boundary_loops(model).at(0), {}, cancel).patch);
}

TEST(ConstrainedRemesher, SplitsCollapsesAndFlipsKeepTheBoundaryAndTheDisc) {
  // A coarse fan over a regular 24-gon, refined to the boundary's edge length.
  Points points;
  Triangles triangles;
  constexpr int boundary = 24;
  for (int i = 0; i < boundary; ++i)
    points.push_back(Vec3(std::cos(2 * M_PI * i / boundary), std::sin(2 * M_PI * i / boundary), 0));
  points.push_back(Vec3(0.3, 0.1, 0));
  for (int i = 0; i < boundary; ++i) triangles.push_back({i, (i + 1) % boundary, boundary});
  const double edge = (points[1] - points[0]).norm();
  ConstrainedRemesher mesh(points, triangles, boundary, {}, [=](const Vec3&) { return edge; });
  for (int round = 0; round < 5; ++round) {
    mesh.split_long_edges();
    mesh.flip_to_delaunay();
    mesh.collapse_short_edges();
    mesh.flip_to_delaunay();
    for (int k = 0; k < 3; ++k) mesh.smooth_tangentially();
  }
  const LoopPatch result{mesh.points(), mesh.triangles()};
  expect_disc(result, boundary);
  for (int i = 0; i < boundary; ++i) EXPECT_EQ(result.points[i], points[i]);
  EXPECT_EQ(count_folds(result.points, result.triangles, static_cast<int>(result.triangles.size())), 0);
  EXPECT_GT(min_angle_deg(result.points, result.triangles, static_cast<int>(result.triangles.size())), 25);
  std::map<int, int> valence;
  for (const Triangle& t : result.triangles)
    for (int v : t) ++valence[v];
  int inner = 0, regular = 0;
  for (const auto& [v, count] : valence)
    if (v >= boundary) {
      ++inner;
      regular += count >= 5 && count <= 7;
    }
  EXPECT_GT(inner, 20);
  EXPECT_GT(regular, 0.9 * inner);
}

}  // namespace
}  // namespace loopmend
