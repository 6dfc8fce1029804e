// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/hand_bridge.h"

#include "core/error.h"
#include "pipeline/fill_holes.h"
#include "samples/analytic_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace loopmend {
namespace {

SurfaceModel sphere_without_cap() {
  return make_surface_model(cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.6; }));
}

TEST(HandBridge, PartsAHoleIntoTwoThatCloseToASphere) {
  const SurfaceModel model = sphere_without_cap();
  const BoundaryLoop hole = find_boundary_loops(model).at(0);
  const int half = hole.edges() / 2;
  const int a = model.soup_vertex[hole.vertices[0]], b = model.soup_vertex[hole.vertices[half]];
  const TriangleSoup soup = with_bridge(model, a, b);
  for (std::size_t v = 0; v < model.soup.points.size(); ++v) EXPECT_EQ(soup.points[v], model.soup.points[v]);
  SurfaceModel bridged = make_surface_model(soup);
  const std::vector<BoundaryLoop> loops = find_boundary_loops(bridged);
  ASSERT_EQ(loops.size(), 2u);
  for (const BoundaryLoop& loop : loops) EXPECT_EQ(loop.kind, LoopKind::hole);
  for (std::size_t v = model.soup.points.size(); v < soup.points.size(); ++v)
    EXPECT_NEAR(soup.points[v].norm(), 1, 0.02);
  for (const HoleResult& result : fill_all_holes(bridged)) EXPECT_TRUE(is_filled(result.status)) << result.message;
  EXPECT_TRUE(find_boundary_loops(bridged).empty());
}

/// Also strips that turn on their way, from an end of an oblong hole to its side: on the cubic alone they would lie 0.031 off, with
/// a ridge along them.
TEST(HandBridge, StripsAcrossABallLieOnIt) {
  const SurfaceModel model =
      make_surface_model(cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.7 && std::abs(p.y()) < 0.25; }));
  const BoundaryLoop hole = find_boundary_loops(model).at(0);
  const std::size_t n = hole.vertices.size();
  const BridgeMaker maker(model);
  for (std::size_t from = 0; from < n; from += n / 8)
    for (const std::size_t part : {2, 3, 4}) {
      const std::size_t to = (from + n / part) % n;
      const BridgeStrip strip =
          maker.strip(model.soup_vertex[hole.vertices[from]], model.soup_vertex[hole.vertices[to]]);
      for (const Vec3& p : strip.points) EXPECT_NEAR(p.norm(), 1, 0.013);
    }
}

/// A boundary with teeth of two edges: five of six sides of the strips across it have good patches.
TEST(HandBridge, TeethOfTheBoundaryDoNotTwistTheStrip) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> tooth(-0.12, 0.12);
  const SurfaceModel model =
      make_surface_model(cut(make_icosphere(4), [&](const Vec3& p) { return p.z() > 0.6 + tooth(random); }));
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  const auto hole = std::ranges::max_element(loops, {}, &BoundaryLoop::edges);
  const std::size_t n = hole->vertices.size();
  int parts = 0, sound = 0;
  for (std::size_t k = 0; k < n / 2; k += 4) {
    const int a = model.soup_vertex[hole->vertices[k]], b = model.soup_vertex[hole->vertices[k + n / 2]];
    SurfaceModel bridged = make_surface_model(with_bridge(model, a, b));
    for (const HoleResult& result : fill_all_holes(bridged)) {
      if (result.loop.edges() < static_cast<int>(n) / 3) continue;  // what the teeth left beside the hole
      ++parts;
      sound += is_filled(result.status) && result.verdict().grade == Grade::good;
    }
  }
  EXPECT_GE(parts, 12);
  EXPECT_GE(6 * sound, 5 * parts);
}

TEST(HandBridge, MakesOneLoopOfTwo) {
  const SurfaceModel model =
      make_surface_model(cut(make_cylinder(4, 32), [](const Vec3& p) { return std::abs(p.z()) > 1.5; }));
  const std::vector<BoundaryLoop> ends = find_boundary_loops(model);
  ASSERT_EQ(ends.size(), 2u);
  const TriangleSoup soup =
      with_bridge(model, model.soup_vertex[ends[0].vertices[0]], model.soup_vertex[ends[1].vertices[0]]);
  EXPECT_EQ(find_boundary_loops(make_surface_model(soup)).size(), 1u);
}

TEST(HandBridge, RefusesNeighborsAndWhatIsNotOnABoundary) {
  const SurfaceModel model = sphere_without_cap();
  const BoundaryLoop hole = find_boundary_loops(model).at(0);
  const int a = model.soup_vertex[hole.vertices[0]], b = model.soup_vertex[hole.vertices[1]];
  EXPECT_THROW(with_bridge(model, a, b), InvalidArgument);
  EXPECT_THROW(with_bridge(model, a, a), InvalidArgument);
  int inside = 0;
  while (std::any_of(hole.vertices.begin(), hole.vertices.end(), [&](int v) { return model.soup_vertex[v] == inside; }))
    ++inside;
  EXPECT_THROW(with_bridge(model, a, inside), InvalidArgument);
}

}  // namespace
}  // namespace loopmend
