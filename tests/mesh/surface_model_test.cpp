// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface_model.h"

#include "core/error.h"
#include "core/random.h"
#include "mesh/boundary_loops.h"
#include "mesh/patch.h"
#include "mesh/quality.h"
#include "mesh/self_intersections.h"
#include "samples/analytic_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

namespace loopmend {
namespace {

TriangleSoup tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}, {}};
}

/// A flat grid of cells × cells squares without the squares listed.
TriangleSoup grid_without(int cells, const std::vector<std::pair<int, int>>& missing) {
  TriangleSoup soup;
  for (int y = 0; y <= cells; ++y)
    for (int x = 0; x <= cells; ++x) soup.points.push_back(Vec3(x, y, 0));
  for (int y = 0; y < cells; ++y)
    for (int x = 0; x < cells; ++x) {
      if (std::find(missing.begin(), missing.end(), std::pair(x, y)) != missing.end()) continue;
      const int a = y * (cells + 1) + x, b = a + 1, c = b + cells + 1, d = a + cells + 1;
      soup.triangles.push_back({a, b, c});
      soup.triangles.push_back({a, c, d});
    }
  return soup;
}

TEST(SurfaceModel, CleanMeshIsTakenAsItIs) {
  const TriangleSoup soup = make_icosphere(2);
  const SurfaceModel model = make_surface_model(soup);
  EXPECT_EQ(model.mesh.n_vertices(), 162u);
  EXPECT_EQ(model.mesh.n_faces(), 320u);
  EXPECT_EQ(model.soup.triangles, soup.triangles);
  EXPECT_EQ(model.repairs.reoriented_faces + model.repairs.non_manifold_vertices + model.repairs.unreferenced_vertices,
            0u);
  EXPECT_TRUE(find_boundary_loops(model).empty());
}

TEST(SurfaceModel, UnreferencedPointsStayInTheSoupAndOutOfTheView) {
  TriangleSoup soup = tetrahedron();
  soup.points.insert(soup.points.begin(), Vec3(9, 9, 9));
  for (Triangle& t : soup.triangles)
    for (int& v : t) ++v;
  const SurfaceModel model = make_surface_model(soup);
  EXPECT_EQ(model.soup.points.size(), 5u);
  EXPECT_EQ(model.mesh.n_vertices(), 4u);
  EXPECT_EQ(model.repairs.unreferenced_vertices, 1u);
  EXPECT_EQ(model.soup_vertex[0], 1);
}

TEST(SurfaceModel, AFaceThatDisagreesIsTurnedInPlace) {
  TriangleSoup soup = make_icosphere(1);
  std::swap(soup.triangles[0][1], soup.triangles[0][2]);  // the first, from which the walk starts
  const SurfaceModel model = make_surface_model(soup);
  EXPECT_EQ(model.repairs.reoriented_faces, 1u);
  EXPECT_TRUE(find_boundary_loops(model).empty());
}

TEST(SurfaceModel, AOneSidedStripIsCutAcrossOnce) {
  TriangleSoup soup;
  constexpr int n = 12;
  for (int i = 0; i < n; ++i) {
    const double turn = 2 * std::numbers::pi * i / n, tilt = turn / 2;
    for (const double side : {-0.3, 0.3}) {
      const double r = 1 + side * std::cos(tilt);
      soup.points.emplace_back(r * std::cos(turn), r * std::sin(turn), side * std::sin(tilt));
    }
    const int a = 2 * i, b = a + 1, c = i + 1 < n ? a + 2 : 1, d = i + 1 < n ? a + 3 : 0;
    soup.triangles.push_back({a, c, b});
    soup.triangles.push_back({c, d, b});
  }
  const SurfaceModel model = make_surface_model(soup);
  EXPECT_EQ(model.repairs.non_manifold_vertices, 2u);
  EXPECT_EQ(model.mesh.n_vertices(), 2u * n + 2);
  EXPECT_EQ(model.mesh.n_edges(), 4u * n + 1);
  EXPECT_EQ(find_boundary_loops(model).size(), 1u);
}

TEST(SurfaceModel, DegenerateAndDuplicateFacesAreCountedAndKeptInTheSoup) {
  TriangleSoup soup = tetrahedron();
  soup.triangles.push_back({1, 1, 2});
  soup.triangles.push_back({1, 3, 0});
  const SurfaceModel model = make_surface_model(soup);
  EXPECT_EQ(model.repairs.degenerate_faces, 1u);
  EXPECT_EQ(model.repairs.duplicate_faces, 1u);
  EXPECT_EQ(model.soup.triangles.size(), 6u);
  EXPECT_EQ(model.mesh.n_faces(), 4u);
}

/// Of each loop, by falling perimeter: its kind, and its vertices as points of the soup in ascending order.
std::vector<std::pair<LoopKind, std::vector<int>>> loops_of(const SurfaceModel& model) {
  std::vector<std::pair<LoopKind, std::vector<int>>> result;
  for (const BoundaryLoop& loop : find_boundary_loops(model)) {
    std::vector<int>& vertices = result.emplace_back(loop.kind, std::vector<int>()).second;
    for (int v : loop.vertices) vertices.push_back(model.soup_vertex[v]);
    std::sort(vertices.begin(), vertices.end());
  }
  return result;
}

TEST(SurfaceModel, ThreeFacesAtAnEdgeCutTheViewAndTheCutIsNoHole) {
  // An octahedron without one face, which is a hole, and with a fin on an edge of the opposite one.
  TriangleSoup soup{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}, {-2, -2, 0}},
                    {{2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}, {1, 3, 6}},
                    {}};
  const SurfaceModel model = make_surface_model(soup);
  EXPECT_EQ(model.repairs.non_manifold_edges, 1u);
  EXPECT_EQ(model.mesh.n_faces(), 8u);
  const auto loops = loops_of(model);
  ASSERT_EQ(loops.size(), 2u);
  EXPECT_EQ(loops[0], std::pair(LoopKind::cut, std::vector<int>{1, 3, 6}));  // the fin, cut off
  EXPECT_EQ(loops[1], std::pair(LoopKind::hole, std::vector<int>{0, 2, 4}));
}

TEST(SurfaceModel, IndexOutOfRangeThrows) {
  TriangleSoup soup = tetrahedron();
  soup.triangles.push_back({0, 1, 4});
  EXPECT_THROW(make_surface_model(soup), InvalidArgument);
  soup.triangles.assign(3, {1, 1, 1});
  EXPECT_THROW(make_surface_model(soup), InvalidArgument);
}

TEST(BoundaryLoops, HoleAndOuterRimOfASheet) {
  const std::vector<BoundaryLoop> loops = find_boundary_loops(make_surface_model(grid_without(6, {{2, 2}, {3, 2}})));
  ASSERT_EQ(loops.size(), 2u);
  EXPECT_EQ(loops[0].kind, LoopKind::outer_rim);
  EXPECT_EQ(loops[0].edges(), 24);
  EXPECT_NEAR(loops[0].turning, 1, 1e-12);
  EXPECT_EQ(loops[1].kind, LoopKind::hole);
  EXPECT_EQ(loops[1].edges(), 6);
  EXPECT_NEAR(loops[1].perimeter, 6, 1e-12);
  EXPECT_NEAR(loops[1].diameter, std::sqrt(5), 1e-12);
  EXPECT_NEAR(loops[1].area, 2, 1e-12);
  EXPECT_NEAR(loops[1].planarity, 0, 1e-12);
  EXPECT_NEAR(loops[1].turning, -1, 1e-12);
  EXPECT_EQ(loops[1].number, 2);
}

TEST(BoundaryLoops, EndsOfATubeAreHoles) {
  const std::vector<BoundaryLoop> loops = find_boundary_loops(make_surface_model(make_cylinder(4, 24)));
  ASSERT_EQ(loops.size(), 2u);
  for (const BoundaryLoop& loop : loops) {
    EXPECT_EQ(loop.kind, LoopKind::hole);
    EXPECT_NEAR(loop.turning, 0, 0.02);
  }
}

TEST(BoundaryLoops, TwoHolesThatMeetAtAVertexAreTwoLoops) {
  const auto loops = loops_of(make_surface_model(grid_without(6, {{2, 2}, {3, 3}})));
  ASSERT_EQ(loops.size(), 3u);
  EXPECT_EQ(loops[0].first, LoopKind::outer_rim);
  EXPECT_EQ(loops[0].second.size(), 24u);
  // Both pass the vertex (3, 3), which is the 24th.
  EXPECT_EQ(loops[1], std::pair(LoopKind::hole, std::vector<int>{16, 17, 23, 24}));
  EXPECT_EQ(loops[2], std::pair(LoopKind::hole, std::vector<int>{24, 25, 31, 32}));
  // One that they do not share makes them two holes.
  const auto apart = loops_of(make_surface_model(grid_without(6, {{2, 2}, {4, 3}})));
  ASSERT_EQ(apart.size(), 3u);
  EXPECT_EQ(apart[1].first, LoopKind::hole);
  EXPECT_EQ(apart[2].first, LoopKind::hole);
}

TEST(BoundaryLoops, TwoHolesThatMeetAreTwoLoopsWhereTheSurfaceTurnsOverToo) {
  const int shared = 3 * 7 + 3;
  TriangleSoup soup = grid_without(6, {{2, 2}, {3, 3}});
  for (const Vec3& place : {Vec3(4.3, 1.7, 0.3), Vec3(3.8, 2.2, 0.9), Vec3(1.7, 4.3, -0.2)}) {
    soup.points[shared] = place;  // the two fans at it face different sides, or overlap
    const SurfaceModel model = make_surface_model(soup);
    EXPECT_EQ(model.mesh.n_vertices(), 49u);
    EXPECT_EQ(model.repairs.non_manifold_vertices, 1u);
    const auto loops = loops_of(model);
    ASSERT_EQ(loops.size(), 3u);
    EXPECT_EQ(std::set({loops[1].second, loops[2].second}),
              (std::set<std::vector<int>>{{16, 17, 23, 24}, {24, 25, 31, 32}}));
    EXPECT_EQ(loops_of(make_view_around_loops(soup, {1, {}})), loops);
  }
}

TEST(BoundaryLoops, ChainsOfHolesThatMeetAreTheirHolesWhereverTheVerticesLie) {
  // Four holes in a chain, three vertices between them, and one of six edges; every vertex between is out of place.
  TriangleSoup soup = grid_without(8, {{1, 1}, {2, 2}, {3, 3}, {3, 4}, {4, 5}});
  for (int k : {2, 3}) soup.points[k * 9 + k] = Vec3(k + 1.3, k - 1.3, 0.4);
  soup.points[5 * 9 + 4] = Vec3(5.3, 3.7, 0.4);
  const auto loops = loops_of(make_surface_model(soup));
  ASSERT_EQ(loops.size(), 5u);
  std::multiset<std::size_t> edges;
  for (const auto& [kind, vertices] : loops) edges.insert(vertices.size());
  EXPECT_EQ(edges, (std::multiset<std::size_t>{4, 4, 4, 6, 32}));
}

TEST(BoundaryLoops, AHoleThatMeetsTheOuterRimAtAVertexIsALoopOfItsOwn) {
  const auto loops = loops_of(make_surface_model(grid_without(6, {{1, 0}, {2, 1}, {2, 2}})));
  ASSERT_EQ(loops.size(), 2u);
  EXPECT_EQ(loops[0].first, LoopKind::outer_rim);
  EXPECT_EQ(loops[0].second.size(), 26u);
  EXPECT_EQ(loops[1].first, LoopKind::hole);
  EXPECT_EQ(loops[1].second.size(), 6u);
}

TEST(BoundaryLoops, ALoopRoundAnIslandThatTouchesItPassesTheirVertexTwice) {
  // A ring of eight squares is missing, but for one corner of the ninth in its middle.
  std::vector<std::pair<int, int>> ring{{1, 1}, {2, 1}, {3, 1}, {1, 2}, {3, 2}, {1, 3}, {2, 3}, {3, 3}};
  TriangleSoup soup = grid_without(6, ring);
  // The middle square's corner (2, 2) becomes the hole's corner (1, 1).
  const int island = 2 * 7 + 2, corner = 1 * 7 + 1;
  for (Triangle& t : soup.triangles)
    for (int& v : t)
      if (v == island) v = corner;
  const std::vector<BoundaryLoop> loops = find_boundary_loops(make_surface_model(soup));
  ASSERT_EQ(loops.size(), 2u);
  EXPECT_EQ(loops[1].kind, LoopKind::hole);
  EXPECT_EQ(loops[1].edges(), 12 + 4);
  // Whatever the numbers of the vertices: the island's first, too.
  std::reverse(soup.triangles.begin(), soup.triangles.end());
  EXPECT_EQ(find_boundary_loops(make_surface_model(soup)).at(1).kind, LoopKind::hole);
  const auto& vertices = loops[1].vertices;
  EXPECT_EQ(std::set<int>(vertices.begin(), vertices.end()).size(), 15u);
}

TEST(BoundaryLoops, SheetsThatTouchAtAVertexOneAboveTheOtherStayApart) {
  TriangleSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0.2, 0.2}, {0.2, 1, 0.2}, {-1, 0.2, 0.2}};
  soup.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 4, 5}, {0, 5, 6}};
  const SurfaceModel model = make_surface_model(soup);
  EXPECT_EQ(model.mesh.n_vertices(), 8u);
  EXPECT_EQ(model.repairs.non_manifold_vertices, 1u);
  EXPECT_EQ(find_boundary_loops(model).size(), 2u);
}

TEST(SurfaceModel, AtAnEdgeOfFourFacesTheFlattestPairsStayTogether) {
  // Two sheets that cross along the line from (1, 0, 0) to (2, 0, 0), which is an edge of both.
  TriangleSoup soup;
  for (int k = 0; k <= 3; ++k) soup.points.emplace_back(k, 0, 0);
  const auto add_sheet = [&](const Vec3& up) {
    const int first = static_cast<int>(soup.points.size());
    for (int k = 0; k <= 3; ++k) soup.points.push_back(Vec3(k, 0, 0) + up);
    for (int k = 0; k <= 3; ++k) soup.points.push_back(Vec3(k, 0, 0) - up);
    soup.triangles.push_back({1, 2, first + 1});
    soup.triangles.push_back({2, 1, first + 4 + 1});
  };
  add_sheet({0, 1, 0.1});
  add_sheet({0, 0.1, 1});
  const SurfaceModel model = make_surface_model(soup);
  EXPECT_EQ(model.repairs.non_manifold_edges, 1u);
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  ASSERT_EQ(loops.size(), 2u);
  for (const BoundaryLoop& loop : loops) EXPECT_EQ(loop.edges(), 4);
}

/// Shallow beside its length, and as long as the part: yet all of the part's surface lies behind it. Of a shell it does not.
TEST(BoundaryLoops, ALongSlotInALongClosedPartIsAHole) {
  TriangleSoup soup = make_icosphere(6);
  for (Vec3& p : soup.points) p.z() *= 15;
  const auto opened = [&](const std::function<bool(const Vec3&)>& gone) {
    const std::vector<BoundaryLoop> loops = find_boundary_loops(make_surface_model(trim_boundaries(cut(soup, gone))));
    EXPECT_EQ(loops.size(), 1U);
    EXPECT_GT(loops.front().extent, 0.84);
    return loops.front().kind;
  };
  for (double half_width : {0.05, 0.1, 0.3, 0.6, 0.8})
    EXPECT_EQ(
        opened([=](const Vec3& p) { return p.x() > 0 && std::abs(p.y()) < half_width && std::abs(p.z()) < 13.5; }),
        LoopKind::hole)
        << half_width;
  EXPECT_EQ(opened([](const Vec3& p) { return p.x() > -0.5; }), LoopKind::outer_rim);
}

/// The wall flares at the boundary, so that it turns like the outline of a sheet.
TEST(BoundaryLoops, ThePlaneEndOfABellIsAHole) {
  const auto kind_at = [](double height) {
    const auto flared = [](double z) { return 0.3 + 0.7 * z * z; };
    TriangleSoup soup = make_revolution(flared, 0, 1, 64, 30);
    for (Vec3& p : soup.points) p.z() *= height;
    const std::vector<BoundaryLoop> loops = find_boundary_loops(make_surface_model(soup));
    EXPECT_GT(loops.at(0).turning, 0.6);
    return loops.at(0).kind;
  };
  for (const double height : {1.0, 1.2}) EXPECT_EQ(kind_at(height), LoopKind::hole) << height;
  EXPECT_EQ(kind_at(0.4), LoopKind::outer_rim);
}

TEST(BoundaryLoops, TheOutlineOfAShallowPieceIsAnOuterRimAndThatOfABowlIsNot) {
  const auto cap = [](double height) {
    TriangleSoup soup = cut(make_icosphere(4), [=](const Vec3& p) { return p.z() < height; });
    for (Vec3& p : soup.points) p.x() *= 1.03;  // no sphere
    return find_boundary_loops(make_surface_model(soup)).at(0);
  };
  const BoundaryLoop mask = cap(0.5);
  EXPECT_LT(mask.turning, 0.6);  // not what tells it from a hole
  EXPECT_EQ(mask.kind, LoopKind::outer_rim);
  EXPECT_NEAR(mask.depth, 0.29, 0.03);
  EXPECT_NE(why_outer_rim(mask).english().find("loop diameters deep"), std::string::npos) << why_outer_rim(mask);
  EXPECT_EQ(cap(-0.1).kind, LoopKind::hole);
  EXPECT_EQ(cap(-0.5).kind, LoopKind::hole);
  EXPECT_TRUE(why_outer_rim(cap(-0.5)).empty());
}

/// The missing part of a sphere is known; but a cap of 40° may be a lens, and a measured sphere a dish.
TEST(BoundaryLoops, TheOpeningOfASphereIsAHole) {
  const auto kind_of_cap = [](double degrees, double noise) {
    const double height = std::cos(degrees * std::numbers::pi / 180);
    TriangleSoup soup = trim_boundaries(cut(make_icosphere(5), [=](const Vec3& p) { return p.z() < height; }));
    Random random(5);
    for (Vec3& p : soup.points)
      p = (300 * (1 + noise * random.bell()) * p + Vec3(1e4, 0, 0)).cast<float>().cast<double>();
    return find_boundary_loops(make_surface_model(soup)).at(0).kind;
  };
  for (const double degrees : {50, 60, 80, 100}) EXPECT_EQ(kind_of_cap(degrees, 0), LoopKind::hole) << degrees;
  EXPECT_EQ(kind_of_cap(40, 0), LoopKind::outer_rim);
  EXPECT_EQ(kind_of_cap(60, 1e-3), LoopKind::outer_rim);
}

/// Its outline is nearly plane, and the hill reaches far from there.
TEST(BoundaryLoops, TheOutlineOfATerrainWithAHillIsNoHole) {
  const TriangleSoup terrain =
      make_graph([](double x, double y) { return 1.6 * std::exp(-2 * (x * x + y * y)); }, 1, 30);
  const BoundaryLoop outline = find_boundary_loops(make_surface_model(terrain)).at(0);
  EXPECT_GT(outline.planarity, 0.01);
  EXPECT_LT(outline.planarity, 0.03);
  EXPECT_EQ(outline.kind, LoopKind::outer_rim);
}

/// A patch would give the boundary edges of a face that is there twice a third face.
TEST(BoundaryLoops, ATwofoldFaceAtTheBoundaryIsNoHole) {
  TriangleSoup ball = cut(make_icosphere(3), [](const Vec3& p) { return p.z() > 0.8; });
  const SurfaceModel once = make_surface_model(ball);
  const BoundaryLoop hole = find_boundary_loops(once).at(0);
  ASSERT_EQ(hole.kind, LoopKind::hole);
  const int a = once.soup_vertex[hole.vertices[0]], b = once.soup_vertex[hole.vertices[1]];
  const auto at_edge = std::ranges::find_if(ball.triangles, [&](const Triangle& t) {
    return std::ranges::count(t, a) == 1 && std::ranges::count(t, b) == 1;
  });
  const Triangle twofold = *at_edge;
  ball.triangles.push_back({twofold[0], twofold[2], twofold[1]});
  EXPECT_EQ(find_boundary_loops(make_surface_model(ball)).at(0).kind, LoopKind::cut);
}

/// Noise lets the boundary of a base turn as if it bounded a sheet.
TEST(BoundaryLoops, ANoisyBaseIsAHole) {
  int turning = 0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    TriangleSoup figure = make_revolution([](double z) { return z < 0 ? 1 : std::sqrt(1 - z * z); }, -2, 0.99, 96, 90);
    Random random(seed);
    for (Vec3& p : figure.points) p += 0.024 * Vec3(random.bell(), random.bell(), random.bell());
    const BoundaryLoop base = find_boundary_loops(make_surface_model(figure)).at(0);
    turning += base.turning > 0.6;
    EXPECT_EQ(base.kind, LoopKind::hole) << seed << ": " << base.turning << ' ' << base.planarity << ' ' << base.onward;
  }
  EXPECT_GT(turning, 0);
}

TEST(BoundaryLoops, ASmallLoopThatTurnsLikeASheetIsAHole) {
  // The tip of a needle on a ball is missing, where it flares.
  TriangleSoup soup = cut(make_icosphere(5), [](const Vec3& p) { return p.z() > 0.995; });
  for (Vec3& p : soup.points)
    if (const double d = Vec3(p - Vec3(0, 0, 1)).norm(); d < 0.13) p += Vec3(0, 0, 3 * (0.13 - d));
  const BoundaryLoop loop = find_boundary_loops(make_surface_model(soup)).at(0);
  EXPECT_LT(loop.extent, 0.2);
  EXPECT_EQ(loop.kind, LoopKind::hole);
}

TEST(BoundaryLoops, ASlitBetweenCoincidentVerticesIsACrack) {
  // A strip of two squares whose common side is there twice.
  TriangleSoup soup = grid_without(4, {});
  const int middle = 2 * 5 + 2;  // vertex (2, 2)
  const int copy = static_cast<int>(soup.points.size());
  soup.points.push_back(Vec3(soup.points[middle]));
  for (Triangle& t : soup.triangles) {
    double x = 0;
    for (int v : t) x += soup.points[v].x() / 3;
    for (int& v : t)
      if (v == middle && x > 2) v = copy;
  }
  const std::vector<BoundaryLoop> loops = find_boundary_loops(make_surface_model(soup));
  ASSERT_EQ(loops.size(), 2u);
  EXPECT_EQ(loops[1].edges(), 4);
  EXPECT_EQ(loops[1].coincident, 4);
  EXPECT_EQ(loops[1].kind, LoopKind::crack);
}

TEST(BoundaryLoops, AMissingTriangleThatAnotherSheetCoversIsACrack) {
  TriangleSoup soup = make_icosphere(2);
  const Triangle gone = soup.triangles[10];
  soup.triangles.erase(soup.triangles.begin() + 10);
  EXPECT_EQ(find_boundary_loops(make_surface_model(soup)).at(0).kind, LoopKind::hole);
  const int first = static_cast<int>(soup.points.size());
  for (int v : gone) soup.points.push_back(Vec3(soup.points[v]));
  soup.points.push_back(2 * Vec3(soup.points.back()));
  soup.triangles.push_back({first, first + 1, first + 2});
  soup.triangles.push_back(
      {first + 1, first, first + 3});  // a flap on one side, so that no more than two edges coincide
  soup.triangles.push_back({first + 2, first + 1, first + 3});
  const std::vector<BoundaryLoop> loops = find_boundary_loops(make_surface_model(soup));
  const auto three = std::find_if(loops.begin(), loops.end(), [](const BoundaryLoop& loop) {
    return loop.coincident < 3 && loop.kind == LoopKind::crack;
  });
  EXPECT_NE(three, loops.end());
}

TEST(Patch, CarriesSixFixedRingsInOrder) {
  const SurfaceModel model = make_surface_model(cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.9; }));
  const BoundaryLoop loop = find_boundary_loops(model).at(0);
  LoopPatch initial_patch;
  for (int v : loop.vertices) initial_patch.points.push_back(model.mesh.point(TriMesh::VertexHandle(v)));
  initial_patch.points.push_back(Vec3(0, 0, 1));
  for (int i = 0; i < loop.edges(); ++i) initial_patch.triangles.push_back({i, (i + 1) % loop.edges(), loop.edges()});
  const Patch patch = make_patch(model, {loop}, {initial_patch});
  EXPECT_EQ(patch.free_count, 1);
  EXPECT_EQ(patch.patch_triangles, loop.edges());
  EXPECT_TRUE(std::is_sorted(patch.ring.begin(), patch.ring.end()));
  EXPECT_EQ(patch.ring.back(), patch_rings);
  EXPECT_LT((patch.to_mesh(patch.positions[0]) - Vec3(0, 0, 1)).norm(), 1e-15);
  const PatchGeometry geometry = patch_geometry(patch);
  EXPECT_EQ(geometry.boundary.size(), loop.vertices.size());

  SurfaceModel filled = model;
  append_patch(filled, geometry);
  EXPECT_TRUE(find_boundary_loops(filled).empty());
  EXPECT_EQ(filled.soup.points.size(), model.soup.points.size() + 1);
  EXPECT_TRUE(std::equal(model.soup.points.begin(), model.soup.points.end(), filled.soup.points.begin()));
  EXPECT_TRUE(std::equal(model.soup.triangles.begin(), model.soup.triangles.end(), filled.soup.triangles.begin()));
}

TEST(Patch, OneThatDoesNotFitIsRefusedAndTheModelStays) {
  SurfaceModel model = make_surface_model(grid_without(6, {{2, 2}}));
  const std::size_t faces = model.soup.triangles.size();
  const std::vector<int> boundary = find_boundary_loops(model).at(1).vertices;
  EXPECT_THROW(append_patch(model, {boundary, {}, {{0, 2, 1}, {0, 3, 2}}}), InvalidArgument);  // wrong way round
  EXPECT_THROW(append_patch(model, {boundary, {}, {{0, 1, 7}}}), InvalidArgument);
  EXPECT_EQ(model.soup.triangles.size(), faces);
  append_patch(model, {boundary, {}, {{0, 1, 2}, {0, 2, 3}}});
  EXPECT_EQ(model.soup.triangles.size(), faces + 2);
}

TEST(SelfIntersections, AreFoundAndNeighboursAreNot) {
  const TriangleSoup sphere = make_icosphere(2);
  const int all = static_cast<int>(sphere.triangles.size());
  EXPECT_TRUE(self_intersections(sphere.points, sphere.triangles, all).empty());
  TriangleSoup pierced = sphere;
  const int base = static_cast<int>(pierced.points.size());
  pierced.points.insert(pierced.points.end(), {{0.01, 0.02, 0.5}, {0.03, 0.01, 1.5}, {0.3, 0.01, 1.5}});
  pierced.triangles.push_back({base, base + 1, base + 2});
  EXPECT_FALSE(
      self_intersections(pierced.points, pierced.triangles, static_cast<int>(pierced.triangles.size())).empty());
  EXPECT_TRUE(self_intersections(pierced.points, pierced.triangles, 0).empty());
}

TEST(SelfIntersections, AFoldOntoTheNeighbourCountsACrackDoesNot) {
  const Points points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.3, 0}, {0, 0, 0}, {1, 0, 0}, {0.5, -1, 0}};
  EXPECT_EQ(self_intersections(points, {{0, 1, 2}, {1, 0, 3}}, 2).size(), 1u);  // lies on the first
  EXPECT_EQ(self_intersections(points, {{0, 1, 2}, {5, 4, 6}}, 2).size(), 0u);  // meets along a coincident edge
}

TEST(TriangleIndex, FindsWhatTheBoxMeets) {
  const TriangleSoup sphere = make_icosphere(3);
  const TriangleIndex index(sphere.points, sphere.triangles);
  EXPECT_EQ(index.near_box({-2, -2, -2}, {2, 2, 2}).size(), sphere.triangles.size());
  EXPECT_TRUE(index.near_box({3, 3, 3}, {4, 4, 4}).empty());
  const Eigen::AlignedBox3d box(Vec3(0.9, -0.1, -0.1), Vec3(1.1, 0.1, 0.1));
  std::vector<int> met, found = index.near_box(box.min(), box.max());
  for (std::size_t f = 0; f < sphere.triangles.size(); ++f) {
    Eigen::AlignedBox3d own;
    for (int v : sphere.triangles[f]) own.extend(sphere.points[v]);
    if (own.intersects(box)) met.push_back(static_cast<int>(f));
  }
  std::sort(found.begin(), found.end());
  ASSERT_GT(met.size(), 3u);
  EXPECT_EQ(found, met);
}

TEST(Quality, AnglesFoldsAndLengths) {
  const double h = std::sqrt(3.0) / 2;
  const Points points{{0, 0, 0}, {1, 0, 0}, {0.5, h, 0}, {0.5, -h, 0}, {0.5, 0.1, 0.01}};
  EXPECT_NEAR(min_angle_deg(points, {{0, 1, 2}}, 1), 60, 1e-10);
  EXPECT_NEAR(mean_edge_length(points, {{0, 1, 2}}, 1), 1, 1e-12);
  EXPECT_EQ(count_folds(points, {{0, 1, 2}, {1, 0, 3}}, 2), 0);
  EXPECT_EQ(count_folds(points, {{0, 1, 2}, {1, 0, 4}}, 2), 1);
  EXPECT_EQ(count_folds(points, {{0, 1, 2}, {1, 0, 4}}, 0), 0);
}

}  // namespace
}  // namespace loopmend
