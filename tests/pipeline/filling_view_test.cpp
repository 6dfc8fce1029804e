// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/filling_view.h"

#include "core/error.h"
#include "mesh/pieces.h"
#include "pipeline/fill_holes.h"
#include "samples/analytic_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace loopmend {
namespace {

/// A fine ball with holes around these points.
TriangleSoup ball_with_holes(int level, double radius, const Points& centers) {
  return trim_boundaries(cut(make_icosphere(level), [&](const Vec3& p) {
    return std::any_of(centers.begin(), centers.end(), [&](const Vec3& c) { return (p - c).norm() < radius; });
  }));
}

TriangleSoup moved(TriangleSoup soup, const Vec3& by) {
  for (Vec3& p : soup.points) p += by;
  return soup;
}

/// Two quads of the sheet are gone that touch at a vertex.
TriangleSoup sheet_with_touching_holes() {
  TriangleSoup sheet = make_graph([](double x, double y) { return 0.1 * x * y; }, 1, 16);
  const auto is_gone = [&](const Triangle& t) {
    const Vec3 p = (sheet.points[t[0]] + sheet.points[t[1]] + sheet.points[t[2]]) / 3;
    return (p.x() > 0 && p.x() < 0.125 && p.y() > 0 && p.y() < 0.125) ||
           (p.x() < 0 && p.x() > -0.125 && p.y() < 0 && p.y() > -0.125);
  };
  std::erase_if(sheet.triangles, is_gone);
  return sheet;
}

struct Case {
  std::string name;
  TriangleSoup soup;
};

/// Surfaces with everything that makes a view differ from its soup.
std::vector<Case> cases() {
  std::vector<Case> all;
  all.push_back({"holes", ball_with_holes(5, 0.2, {{0, 0, 1}, {0.5, 0, 0.86}, {0, -1, 0}})});
  all.push_back({"tube", make_cylinder(2, 60)});
  all.push_back({"touching holes", sheet_with_touching_holes()});
  all.push_back({"closed", make_icosphere(3)});
  TriangleSoup island = ball_with_holes(5, 0.6, {{0, 0, 1}});
  append(island, moved(cut(make_icosphere(5), [](const Vec3& p) { return p.z() < 0.97; }), Vec3(0, 0, 0.01)));
  all.push_back({"island", island});
  TriangleSoup fins = ball_with_holes(4, 0.3, {{0, 0, 1}});
  const Triangle t = fins.triangles[100];
  fins.points.push_back(2 * fins.points[t[0]]);
  const int top = static_cast<int>(fins.points.size()) - 1;
  fins.triangles.push_back({t[0], t[1], top});  // a third face at an edge
  fins.points.push_back(Vec3(9, 9, 9));         // no face's
  const Triangle u = fins.triangles[700];
  for (double x : {0.0, 0.1, 0.2}) fins.points.push_back(1.2 * fins.points[u[0]] + Vec3(x, x * x, 0));
  fins.triangles.push_back({u[0], top + 2, top + 3});  // a fan of its own at a vertex
  fins.triangles.push_back({u[0], top + 3, top + 4});
  fins.triangles.push_back({u[1], u[1], u[2]});                                                     // no surface
  fins.triangles.push_back({fins.triangles[50][1], fins.triangles[50][0], fins.triangles[50][2]});  // there already
  for (int f : {300, 301, 302}) std::swap(fins.triangles[f][0], fins.triangles[f][1]);  // the wrong way round
  all.push_back({"fins", fins});
  TriangleSoup pair = ball_with_holes(4, 0.3, {{0, 1, 0}});
  append(pair, {{{3, 0, 0}, {4, 0, 0}, {3, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}});  // two triangles back to back
  all.push_back({"pair", pair});
  return all;
}

void expect_same_loops(const SurfaceModel& whole, const SurfaceModel& view, const std::string& name) {
  const std::vector<BoundaryLoop> expected = find_boundary_loops(whole), found = find_boundary_loops(view);
  ASSERT_EQ(found.size(), expected.size()) << name;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const BoundaryLoop &a = expected[k], &b = found[k];
    ASSERT_EQ(a.vertices.size(), b.vertices.size()) << name << ", loop " << k;
    for (std::size_t i = 0; i < a.vertices.size(); ++i)
      EXPECT_EQ(whole.soup_vertex[a.vertices[i]], view.soup_vertex[b.vertices[i]]) << name << ", loop " << k;
    EXPECT_EQ(a.kind, b.kind) << name << ", loop " << k;
    EXPECT_EQ(a.coincident, b.coincident) << name << ", loop " << k;
    for (const auto member :
         {&BoundaryLoop::perimeter, &BoundaryLoop::diameter, &BoundaryLoop::planarity, &BoundaryLoop::area,
          &BoundaryLoop::turning, &BoundaryLoop::extent, &BoundaryLoop::depth, &BoundaryLoop::onward})
      EXPECT_EQ(a.*member, b.*member) << name << ", loop " << k;
  }
  const auto islands = find_islands(whole, expected), same = find_islands(view, found);
  ASSERT_EQ(islands.size(), same.size()) << name;
  for (std::size_t k = 0; k < islands.size(); ++k) {
    EXPECT_EQ(islands[k].hole, same[k].hole) << name;
    EXPECT_EQ(islands[k].islands, same[k].islands) << name;
  }
}

void expect_same_repairs(const SurfaceModel& a, const SurfaceModel& b, const std::string& name) {
  EXPECT_EQ(a.repairs.degenerate_faces, b.repairs.degenerate_faces) << name;
  EXPECT_EQ(a.repairs.duplicate_faces, b.repairs.duplicate_faces) << name;
  EXPECT_EQ(a.repairs.non_manifold_edges, b.repairs.non_manifold_edges) << name;
  EXPECT_EQ(a.repairs.non_manifold_vertices, b.repairs.non_manifold_vertices) << name;
  EXPECT_EQ(a.repairs.reoriented_faces, b.repairs.reoriented_faces) << name;
  EXPECT_EQ(a.repairs.unreferenced_vertices, b.repairs.unreferenced_vertices) << name;
  EXPECT_EQ(a.turned_faces, b.turned_faces) << name;
  EXPECT_EQ(a.soup.triangles, b.soup.triangles) << name;
}

TEST(ViewAroundLoops, HasTheLoopsOfTheWholeView) {
  for (const Case& one : cases()) {
    const SurfaceModel whole = make_surface_model(one.soup);
    for (const int rings : {0, 1, 6}) {
      const SurfaceModel view = make_view_around_loops(one.soup, {rings, {}});
      expect_same_repairs(whole, view, one.name);
      expect_same_loops(whole, view, one.name + ", rings " + std::to_string(rings));
    }
    EXPECT_EQ(as_read(whole).triangles, one.soup.triangles) << one.name;
  }
}

TEST(ViewAroundLoops, LeavesOutWhatIsFarFromThem) {
  const TriangleSoup ball = ball_with_holes(6, 0.1, {{0, 0, 1}});
  const SurfaceModel near = make_view_around_loops(ball, {}), wider = make_view_around_loops(ball, {6, {}});
  EXPECT_LT(near.mesh.n_faces(), ball.triangles.size() / 100);
  EXPECT_GT(wider.mesh.n_faces(), near.mesh.n_faces());
  EXPECT_LT(wider.mesh.n_faces(), ball.triangles.size() / 10);
  EXPECT_EQ(make_view_around_loops(make_icosphere(3), {}).mesh.n_faces(), 0U);
}

TEST(FillingView, GivesTheSameBitsAsTheWholeView) {
  for (const Case& one : cases()) {
    SurfaceModel whole = make_surface_model(one.soup), view = make_filling_view(one.soup);
    const auto holes_of = [](const SurfaceModel& model) {
      std::vector<BoundaryLoop> holes = find_boundary_loops(model);
      std::erase_if(holes, [](const BoundaryLoop& loop) { return loop.kind != LoopKind::hole; });
      return holes;
    };
    widen_filling_view(view, find_boundary_loops(view), holes_of(view));
    const FillOptions options;
    const auto expected = fill_holes(whole, holes_of(whole), options, nullptr, CancelToken());
    const auto results = fill_holes(view, holes_of(view), options, nullptr, CancelToken());
    ASSERT_EQ(results.size(), expected.size()) << one.name;
    for (std::size_t k = 0; k < results.size(); ++k) {
      EXPECT_EQ(results[k].status, expected[k].status) << one.name;
      EXPECT_EQ(results[k].message, expected[k].message) << one.name;
    }
    EXPECT_EQ(view.soup.points, whole.soup.points) << one.name;
    EXPECT_EQ(view.soup.triangles, whole.soup.triangles) << one.name;
  }
}

/// A finely divided tube: its end asks for more than six rings.
TEST(FillingView, AFlatCutNeedsAWiderView) {
  TriangleSoup tube = make_revolution([](double) { return 1.0; }, 0, 3, 200, 100);
  SurfaceModel view = make_filling_view(tube);
  const std::vector<BoundaryLoop> loops = find_boundary_loops(view);
  ASSERT_EQ(loops.size(), 2U);
  const std::size_t faces = view.mesh.n_faces();
  EXPECT_FALSE(holds_neighborhood(view, loops));
  SurfaceModel unfilled = view;
  EXPECT_THROW(fill_holes(unfilled, loops, {}, nullptr, CancelToken()), InvalidArgument);
  EXPECT_TRUE(widen_filling_view(view, loops, {loops[0]}));
  EXPECT_GT(view.mesh.n_faces(), faces);
  EXPECT_LT(view.mesh.n_faces(), tube.triangles.size());
  const std::vector<BoundaryLoop> again = find_boundary_loops(view);
  EXPECT_TRUE(holds_neighborhood(view, {again[0]}));
  EXPECT_FALSE(widen_filling_view(view, again, {again[0]}));
}

}  // namespace
}  // namespace loopmend
