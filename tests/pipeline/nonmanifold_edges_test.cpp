// SPDX-License-Identifier: GPL-3.0-or-later
// No patch makes an edge of more than two faces, wherever on the scan the edge is that it would repeat.
#include "mesh/chord_faces.h"
#include "pipeline/blend.h"
#include "pipeline/fill_holes.h"
#include "pipeline/paste.h"
#include "pipeline/validate.h"
#include "samples/analytic_surfaces.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <random>

namespace loopmend {
namespace {

using Position = std::array<double, 3>;

Position position(const TriangleSoup& soup, int v) {
  return {soup.points[v].x(), soup.points[v].y(), soup.points[v].z()};
}

/// Faces at each edge; ends in the same position are one.
std::map<std::pair<Position, Position>, int> faces_at_edges(const TriangleSoup& soup) {
  std::map<std::pair<Position, Position>, int> faces;
  for (const Triangle& t : soup.triangles)
    for (int k = 0; k < 3; ++k) ++faces[std::minmax(position(soup, t[k]), position(soup, t[(k + 1) % 3]))];
  return faces;
}

/// Edges of more than two faces.
int crowded_edges(const TriangleSoup& soup) {
  const auto faces = faces_at_edges(soup);
  return static_cast<int>(std::count_if(faces.begin(), faces.end(), [](const auto& edge) { return edge.second > 2; }));
}

/// Edges between two of the new triangles that have more than two faces, where there were two at most. Along a slit whose sides
/// have points of their own there are four faces when both its sides are closed: these are no such edges.
int crowded_chords(const TriangleSoup& before, const TriangleSoup& after) {
  auto faces_before = faces_at_edges(before), faces = faces_at_edges(after);
  std::map<std::pair<int, int>, int> new_faces;
  for (std::size_t f = before.triangles.size(); f < after.triangles.size(); ++f)
    for (int k = 0; k < 3; ++k) ++new_faces[std::minmax(after.triangles[f][k], after.triangles[f][(k + 1) % 3])];
  int crowded = 0;
  for (const auto& [edge, count] : new_faces) {
    const std::pair<Position, Position> at = std::minmax(position(after, edge.first), position(after, edge.second));
    crowded += count > 1 && faces.at(at) > 2 && faces_before[at] <= 2;
  }
  return crowded;
}

FillOptions without_flow() {
  FillOptions options;
  options.evolution.reset();
  return options;
}

constexpr int a = 0, b = 1, c = 2, d = 3;

/// The loop a, b, c, d of four edges, its corners at 0 and at half the height by turns, over two faces that have the edge a–c.
TriangleSoup under_a_loop_of_four() {
  TriangleSoup soup;
  soup.points = {{1, 0, 0}, {0, 1, 0.5}, {-1, 0, 0}, {0, -1, 0.5}};
  soup.triangles = {{a, b, c}, {a, c, d}};
  return soup;
}

enum class SecondEdge { of_the_same_points, of_points_in_the_same_positions };

/// The same with two faces above that have the edge b–d.
TriangleSoup between_both_diagonals(SecondEdge edge) {
  TriangleSoup soup = under_a_loop_of_four();
  soup.points.insert(soup.points.end(), {{1, 0, 2}, {-1, 0, 2}});
  int from = b, to = d;
  if (edge == SecondEdge::of_points_in_the_same_positions) {
    from = static_cast<int>(soup.points.size());
    to = from + 1;
    soup.points.push_back(soup.points[b]);
    soup.points.push_back(soup.points[d]);
  }
  soup.triangles.push_back({from, to, 4});
  soup.triangles.push_back({to, from, 5});
  return soup;
}

BoundaryLoop loop_of_four_at(const SurfaceModel& model, int point) {
  for (const BoundaryLoop& loop : find_boundary_loops(model))
    for (int v : loop.vertices)
      if (loop.edges() == 4 && model.soup_vertex[v] == point) return loop;
  throw std::logic_error("no such loop");
}

/// As a patch: the loop's vertices by turns, and triangles over its places.
Patch patch_over(const SurfaceModel& model, const BoundaryLoop& loop, const Triangles& triangles) {
  LoopPatch patch;
  for (int v : loop.vertices) patch.points.push_back(model.mesh.point(TriMesh::VertexHandle(v)));
  patch.triangles = triangles;
  return make_patch(model, {loop}, {patch});
}

/// Where in the loop the soup point is.
int place_of(const SurfaceModel& model, const BoundaryLoop& loop, int point) {
  for (int i = 0; i < loop.edges(); ++i)
    if (model.soup_vertex[loop.vertices[i]] == point) return i;
  return -1;
}

TEST(NonmanifoldEdges, ALoopOfFourTakesTheDiagonalThatIsFree) {
  SurfaceModel model = make_surface_model(under_a_loop_of_four());
  const BoundaryLoop loop = loop_of_four_at(model, a);
  const int at_a = place_of(model, loop, a);
  EXPECT_EQ(loop.joined, (std::vector<std::pair<int, int>>{{at_a % 2, at_a % 2 + 2}}));
  const auto results = fill_holes(model, {loop}, without_flow(), nullptr, {});
  EXPECT_TRUE(is_filled(results[0].status)) << results[0].message;
  EXPECT_EQ(crowded_edges(model.soup), 0);
  EXPECT_TRUE(find_boundary_loops(model).empty());
}

TEST(NonmanifoldEdges, BetweenBothDiagonalsALoopOfFourGetsAVertex) {
  for (SecondEdge edge : {SecondEdge::of_the_same_points, SecondEdge::of_points_in_the_same_positions}) {
    SurfaceModel model = make_surface_model(between_both_diagonals(edge));
    const BoundaryLoop loop = loop_of_four_at(model, a);
    EXPECT_EQ(loop.joined.size(), 2u);
    const LoopPatchOutcome outcome = fill_loop(model, loop, {}, {});
    ASSERT_TRUE(outcome.patch) << outcome.message;
    EXPECT_GT(outcome.patch->points.size(), 4u);
    EXPECT_EQ(outcome.quality.intersections, 0);
    const auto results = fill_holes(model, {loop}, without_flow(), nullptr, {});
    EXPECT_TRUE(is_filled(results[0].status)) << results[0].message;
    EXPECT_EQ(crowded_edges(model.soup), 0);
    EXPECT_EQ(find_boundary_loops(model).size(), 1u);  // that of the faces above
  }
}

TEST(NonmanifoldEdges, AreCountedOfAPatchAgainstTheWholeScan) {
  for (SecondEdge edge : {SecondEdge::of_the_same_points, SecondEdge::of_points_in_the_same_positions}) {
    const SurfaceModel model = make_surface_model(between_both_diagonals(edge));
    const ScanIndex scan(model);
    const BoundaryLoop loop = loop_of_four_at(model, a);
    for (const Triangles& halves : {Triangles{{0, 1, 2}, {0, 2, 3}}, Triangles{{1, 2, 3}, {1, 3, 0}}}) {
      const Patch patch = patch_over(model, loop, halves);
      EXPECT_EQ(new_nonmanifold_edges(scan, patch), 1);
      const Validity validity = validate(scan, patch);
      EXPECT_EQ(validity.nonmanifold_edges, 1);
      EXPECT_FALSE(validity.is_clean());
    }
  }
  const SurfaceModel model = make_surface_model(under_a_loop_of_four());
  const ScanIndex scan(model);
  const BoundaryLoop loop = loop_of_four_at(model, a);
  const int at_a = place_of(model, loop, a);
  const auto with_chord_from = [&](int i) {
    return patch_over(model, loop, {{i, (i + 1) % 4, (i + 2) % 4}, {i, (i + 2) % 4, (i + 3) % 4}});
  };
  EXPECT_EQ(new_nonmanifold_edges(scan, with_chord_from(at_a)), 1);
  EXPECT_EQ(new_nonmanifold_edges(scan, with_chord_from((at_a + 1) % 4)), 0);
}

TEST(NonmanifoldEdges, ThePatchThatWouldMakeOneIsNotPastedAndOthersAre) {
  SurfaceModel model = make_surface_model(between_both_diagonals(SecondEdge::of_the_same_points));
  const BoundaryLoop loop = loop_of_four_at(model, a), above = loop_of_four_at(model, 4);
  const Patch bad = patch_over(model, loop, {{0, 1, 2}, {0, 2, 3}});
  const int at_b = place_of(model, above, b);
  const auto side = [&](int k) { return (at_b + k) % 4; };
  const Patch good = patch_over(model, above, {{side(1), side(2), side(3)}, {side(1), side(3), side(0)}});
  const std::vector<PastedPatch> outcomes = paste_patches(model, {&bad, &good});
  EXPECT_EQ(outcomes[0].fault.english(), "1 edge of its patch would have more than two faces: left open");
  EXPECT_TRUE(outcomes[1].fault.empty());
  EXPECT_EQ(crowded_edges(model.soup), 0);
  EXPECT_EQ(model.soup.triangles.size(), 6u);
}

/// Of two patches with the same chord over different points in its positions, the second is left out.
TEST(NonmanifoldEdges, TwoPatchesDoNotShareAChord) {
  TriangleSoup soup = under_a_loop_of_four();
  const TriangleSoup below = soup;
  for (const Vec3& p : below.points) soup.points.emplace_back(p.x(), p.y(), p.z() == 0 ? 4 : 0.5);
  for (const Triangle& t : below.triangles) soup.triangles.push_back({t[0] + 4, t[2] + 4, t[1] + 4});
  SurfaceModel model = make_surface_model(soup);
  std::vector<Patch> patches;
  for (int first : {a, 4}) {
    const BoundaryLoop loop = loop_of_four_at(model, first);
    const int i = (place_of(model, loop, first) + 1) % 4;
    patches.push_back(patch_over(model, loop, {{i, (i + 1) % 4, (i + 2) % 4}, {i, (i + 2) % 4, (i + 3) % 4}}));
  }
  const std::vector<PastedPatch> outcomes = paste_patches(model, {&patches[0], &patches[1]});
  EXPECT_NE(outcomes[0].fault.empty(), outcomes[1].fault.empty());
  EXPECT_EQ(crowded_edges(model.soup), 0);
}

TEST(NonmanifoldEdges, ALoopOfThreeEdgesNeedsNoChord) {
  TriangleSoup soup;  // a tetrahedron without a face, whose edges are all there
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  soup.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}};
  SurfaceModel model = make_surface_model(soup);
  const auto results = fill_holes(model, find_boundary_loops(model), without_flow(), nullptr, {});
  ASSERT_EQ(results.size(), 1u);
  EXPECT_TRUE(is_filled(results[0].status)) << results[0].message;
  EXPECT_EQ(crowded_edges(model.soup), 0);
}

/// Closed where it can be, whatever triangles are missing: chains and fans of touching holes, loops that have two vertices in
/// common, and faces that hang by a vertex.
void expect_fills_without_crowding(const TriangleSoup& open, const std::string& name) {
  SurfaceModel model = make_surface_model(open);
  int holes = 0, filled = 0;
  std::vector<BoundaryLoop> loops;
  for (BoundaryLoop& loop : find_boundary_loops(model))
    if (loop.kind == LoopKind::hole) loops.push_back(std::move(loop));
  for (const HoleResult& result : fill_holes(model, loops, without_flow(), nullptr, {})) {
    ++holes;
    filled += is_filled(result.status);
    if (is_filled(result.status)) continue;  // of an island that was not joined it may say so
    EXPECT_EQ(result.message.english().find("more than two faces"), std::string::npos)
        << name << ": " << result.message;
    EXPECT_EQ(result.message.english().find("chord"), std::string::npos) << name << ": " << result.message;
  }
  EXPECT_EQ(crowded_chords(open, model.soup), 0) << name;
  EXPECT_GT(holes, 0) << name;
  EXPECT_GT(filled, 0) << name;
}

/// Each third of the points is there twice, as at the seams of textures; which faces name the second is left to chance.
TriangleSoup with_points_doubled(TriangleSoup soup, std::mt19937& random) {
  const int n = static_cast<int>(soup.points.size());
  for (int v = 0; v < n; ++v) {
    if (random() % 3 != 0) continue;
    const int copy = static_cast<int>(soup.points.size());
    soup.points.push_back(Vec3(soup.points[v]));
    for (Triangle& t : soup.triangles)
      for (int& corner : t)
        if (corner == v && random() % 2 == 0) corner = copy;
  }
  return soup;
}

TEST(NonmanifoldEdges, WhateverTrianglesAreMissingNoneIsMade) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    std::mt19937 random(seed);
    TriangleSoup soup = make_icosphere(seed % 2 == 0 ? 1 : 2);
    const unsigned missing = 10 + seed % 5 * 10;  // percent
    std::erase_if(soup.triangles, [&](const Triangle&) { return random() % 100 < missing; });
    expect_fills_without_crowding(soup, "seed " + std::to_string(seed));
    expect_fills_without_crowding(with_points_doubled(soup, random), "doubled, seed " + std::to_string(seed));
  }
}

/// Two strips of an annulus that an edge of the scan joins already.
TEST(NonmanifoldEdges, ABridgeDoesNotRepeatAnEdgeBetweenItsLoops) {
  TriangleSoup soup = make_icosphere(2);
  std::erase_if(soup.triangles, [&](const Triangle& t) {
    const double z = (soup.points[t[0]] + soup.points[t[1]] + soup.points[t[2]]).z() / 3;
    return z > 0.9 || (z < 0.62 && z > 0.3);
  });
  SurfaceModel model = make_surface_model(soup);
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  for (std::size_t k = 0; k < loops.size(); ++k)
    for (std::size_t l = 0; l < k; ++l) {
      SurfaceModel joined = model;
      try {
        blend_loops(joined, {loops[l], loops[k]}, {{}, std::nullopt}, {});
      } catch (const std::exception&) {  // loops that face different sides
        continue;
      }
      EXPECT_EQ(crowded_edges(joined.soup), 0) << loops[l].number << " and " << loops[k].number;
    }
}

}  // namespace
}  // namespace loopmend
