// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighborhood/trim_boundary.h"

#include "core/error.h"
#include "mesh/self_intersections.h"
#include "pipeline/fill_holes.h"
#include "pipeline/solve_group.h"
#include "samples/analytic_surfaces.h"
#include "support/ragged_boundaries.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace loopmend {
namespace {

/// A flat grid of 9 by 9 cells with the middle 3 by 3 cells missing, and its triangle at cell (x, y), half 0 or 1.
constexpr int cells = 9;

int grid_vertex(int x, int y) { return y * (cells + 1) + x; }

TriangleSoup holed_grid() {
  TriangleSoup soup;
  for (int y = 0; y <= cells; ++y)
    for (int x = 0; x <= cells; ++x) soup.points.emplace_back(x, y, 0);
  for (int y = 0; y < cells; ++y)
    for (int x = 0; x < cells; ++x) {
      if (x >= 3 && x < 6 && y >= 3 && y < 6) continue;
      soup.triangles.push_back({grid_vertex(x, y), grid_vertex(x + 1, y), grid_vertex(x + 1, y + 1)});
      soup.triangles.push_back({grid_vertex(x, y), grid_vertex(x + 1, y + 1), grid_vertex(x, y + 1)});
    }
  return soup;
}

int add(TriangleSoup& soup, Triangle t) {
  soup.triangles.push_back(t);
  return static_cast<int>(soup.triangles.size()) - 1;
}

std::vector<BoundaryLoop> holes_of(const SurfaceModel& model) {
  std::vector<BoundaryLoop> holes;
  for (const BoundaryLoop& loop : find_boundary_loops(model))
    if (loop.kind == LoopKind::hole) holes.push_back(loop);
  return holes;
}

TEST(TrimBoundary, AGoodBoundaryHasNoBadFaces) {
  const SurfaceModel model = make_surface_model(holed_grid());
  ASSERT_EQ(holes_of(model).size(), 1U);
  EXPECT_TRUE(bad_boundary_faces(model, holes_of(model)).empty());
  EXPECT_TRUE(trim_boundary(model, holes_of(model), 3).removed.empty());
}

TEST(TrimBoundary, RemovesWhatDanglesFaceByFaceAndRoundByRound) {
  TriangleSoup soup = holed_grid();
  const std::size_t good = soup.triangles.size();
  // Two triangles into the hole, the second standing on the first.
  soup.points.emplace_back(3.5, 3.8, 0);
  const int tip = static_cast<int>(soup.points.size()) - 1;
  soup.points.emplace_back(3.9, 4.3, 0);
  const int first = add(soup, {grid_vertex(3, 3), grid_vertex(4, 3), tip});
  const int second = add(soup, {tip, grid_vertex(4, 3), tip + 1});
  const SurfaceModel model = make_surface_model(soup);

  const auto bad = bad_boundary_faces(model, holes_of(model));
  ASSERT_EQ(bad.size(), 1U);
  EXPECT_EQ(bad[0].face, second);
  EXPECT_EQ(bad[0].fault, BoundaryFault::dangling);

  const TrimmedModel once = trim_boundary(model, holes_of(model), 1);
  ASSERT_EQ(once.removed.size(), 1U);
  EXPECT_EQ(once.removed[0].face, second);
  const TrimmedModel all = trim_boundary(model, holes_of(model), 5);
  ASSERT_EQ(all.removed.size(), 2U);
  EXPECT_EQ(all.removed[1].face, first);
  EXPECT_EQ(all.removed[1].ring, 2);
  EXPECT_EQ(all.model.soup.triangles,
            Triangles(soup.triangles.begin(), soup.triangles.begin() + static_cast<long>(good)));
  EXPECT_EQ(all.model.soup.points, soup.points);
  ASSERT_EQ(all.loops.size(), 1U);
  EXPECT_EQ(all.loops[0].edges(), 12);
}

/// The only faults of this soup, by face.
std::map<int, BoundaryFault> faults_of(const TriangleSoup& soup) {
  const SurfaceModel model = make_surface_model(soup);
  EXPECT_EQ(model.repairs.reoriented_faces, 0U);
  std::map<int, BoundaryFault> faults;
  for (const BadBoundaryFace& bad : bad_boundary_faces(model, holes_of(model))) faults[bad.face] = bad.fault;
  return faults;
}

int face_of(const TriangleSoup& soup, Triangle t) {
  return static_cast<int>(std::find(soup.triangles.begin(), soup.triangles.end(), t) - soup.triangles.begin());
}

TEST(TrimBoundary, FindsASliver) {
  TriangleSoup soup = holed_grid();
  const int corner = add(soup, {grid_vertex(3, 4), grid_vertex(3, 3), grid_vertex(4, 3)});
  EXPECT_TRUE(faults_of(soup).empty());
  soup.points[grid_vertex(3, 3)] = Vec3(3.48, 3.48, 0);
  EXPECT_EQ(faults_of(soup), (std::map<int, BoundaryFault>{{corner, BoundaryFault::sliver}}));
}

TEST(TrimBoundary, FindsAFlippedTriangle) {
  TriangleSoup soup = holed_grid();
  const int corner = add(soup, {grid_vertex(3, 4), grid_vertex(3, 3), grid_vertex(4, 3)});
  soup.points[grid_vertex(3, 3)] = Vec3(3.8, 3.8, 0);  // beyond the line between the other two
  EXPECT_EQ(faults_of(soup), (std::map<int, BoundaryFault>{{corner, BoundaryFault::flipped}}));
}

TEST(TrimBoundary, FindsASpike) {
  TriangleSoup soup = holed_grid();
  soup.points[grid_vertex(4, 3)].z() = 4;
  std::map<int, BoundaryFault> fan;
  for (const Triangle& t : {Triangle{grid_vertex(3, 2), grid_vertex(4, 2), grid_vertex(4, 3)},
                            Triangle{grid_vertex(3, 2), grid_vertex(4, 3), grid_vertex(3, 3)},
                            Triangle{grid_vertex(4, 2), grid_vertex(5, 3), grid_vertex(4, 3)}})
    fan[face_of(soup, t)] = BoundaryFault::spike;
  EXPECT_EQ(faults_of(soup), fan);
}

/// A bent bar of square section, open at both ends: four rectangles in each of so many steps.
TriangleSoup open_arch(int steps, double thickness) {
  TriangleSoup soup;
  for (int j = 0; j <= steps; ++j) {
    const double angle = 3 * j / static_cast<double>(steps), inner = 1, outer = 1 + thickness;
    for (const auto& [r, y] : {std::pair{inner, 0.0}, {outer, 0.0}, {outer, thickness}, {inner, thickness}})
      soup.points.emplace_back(r * std::cos(angle), y, r * std::sin(angle));
  }
  for (int j = 0; j < steps; ++j)
    for (int k = 0; k < 4; ++k) {
      const int a = 4 * j + k, b = 4 * j + (k + 1) % 4;
      soup.triangles.push_back({a, b, b + 4});
      soup.triangles.push_back({a, b + 4, a + 4});
    }
  return soup;
}

TEST(TrimBoundary, SeesNoSpikesAtTheEndOfACoarseBar) {
  const TriangleSoup soup = open_arch(20, 1);
  EXPECT_TRUE(faults_of(soup).empty());
  const SurfaceModel model = make_surface_model(soup);
  EXPECT_TRUE(trim_boundary(model, holes_of(model), 3).removed.empty());
}

/// Each triangle of a tube of long needles is bad.
TEST(TrimBoundary, SparesAPartThatWouldGoWhole) {
  const SurfaceModel model = make_surface_model(make_revolution([](double) { return 1; }, 0, 20, 64, 1));
  ASSERT_EQ(bad_boundary_faces(model, holes_of(model)).size(), 128U);
  const TrimmedModel trimmed = trim_boundary(model, holes_of(model), 3);
  EXPECT_TRUE(trimmed.removed.empty());
  EXPECT_EQ(trimmed.spared, 1U);
}

/// The grid with one wide triangle of a good part of its area, which stands on one edge of the hole.
TEST(TrimBoundary, SparesAPartThatWouldLoseMuchOfItsArea) {
  TriangleSoup soup = holed_grid();
  soup.points.emplace_back(4.5, 3.5, 60);
  add(soup, {grid_vertex(4, 3), grid_vertex(5, 3), static_cast<int>(soup.points.size()) - 1});
  const SurfaceModel model = make_surface_model(soup);
  EXPECT_FALSE(bad_boundary_faces(model, holes_of(model)).empty());
  EXPECT_EQ(trim_boundary(model, holes_of(model), 3).spared, 1U);
}

TEST(TrimBoundary, MendsARaggedBoundaryFaceByFace) {
  const test::RaggedBoundary boundary = test::ragged_boundary();
  ASSERT_GE(boundary.bad.size(), 12U);
  const SurfaceModel clean = make_surface_model(boundary.clean), ragged = make_surface_model(boundary.ragged);
  EXPECT_EQ(ragged.repairs.reoriented_faces, 0U);
  EXPECT_EQ(ragged.repairs.non_manifold_edges, 0U);
  EXPECT_TRUE(bad_boundary_faces(clean, holes_of(clean)).empty());

  std::map<int, std::pair<BoundaryFault, int>> expected, removed;
  for (const BadBoundaryFace& bad : boundary.bad) expected[bad.face] = {bad.fault, bad.ring};
  const TrimmedModel trimmed = trim_boundary(ragged, holes_of(ragged), 3);
  for (const BadBoundaryFace& bad : trimmed.removed) removed[bad.face] = {bad.fault, bad.ring};
  EXPECT_EQ(removed, expected);
  EXPECT_EQ(trimmed.model.soup.triangles, boundary.clean.triangles);

  // One round takes what can be reached from the boundary, and no more.
  const TrimmedModel once = trim_boundary(ragged, holes_of(ragged), 1);
  EXPECT_EQ(once.removed.size(), static_cast<std::size_t>(std::count_if(boundary.bad.begin(), boundary.bad.end(),
                                                                        [](auto& b) { return b.ring == 1; })));
}

/// The grid with a plate that stands on an edge of the hole and turns down, so that its outer edge runs through the grid.
/// @returns the soup; its last triangle is the one that crosses.
TriangleSoup pierced_grid() {
  TriangleSoup soup = holed_grid();
  const int tip = static_cast<int>(soup.points.size());
  soup.points.emplace_back(4.5, 3.2, 0.8);
  soup.points.emplace_back(4.4, 1.4, -0.8);
  add(soup, {grid_vertex(4, 3), grid_vertex(5, 3), tip});
  add(soup, {grid_vertex(4, 3), tip, tip + 1});
  return soup;
}

TEST(TrimBoundary, TakesOnlyWhatRunsThroughTheSurface) {
  const TriangleSoup soup = pierced_grid();
  const SurfaceModel model = make_surface_model(soup);
  const std::vector<BoundaryLoop> holes = holes_of(model);
  ASSERT_EQ(holes.size(), 1U);
  EXPECT_FALSE(why_no_patch_exists(ScanIndex(model), holes.front()).empty());
  const TrimmedModel trimmed = trim_pierced(model, holes);
  ASSERT_EQ(trimmed.removed.size(), 1U);
  EXPECT_EQ(trimmed.removed[0].face, static_cast<int>(soup.triangles.size()) - 1);
  EXPECT_EQ(trimmed.removed[0].fault, BoundaryFault::crossing);
  EXPECT_EQ(trimmed.model.soup.points, soup.points);
  EXPECT_EQ(trimmed.model.soup.triangles, Triangles(soup.triangles.begin(), soup.triangles.end() - 1));
  ASSERT_EQ(trimmed.loops.size(), 1U);
  EXPECT_TRUE(why_no_patch_exists(ScanIndex(trimmed.model), trimmed.loops.front()).empty());
  // A ragged boundary that crosses nothing stays as it is; so does one that is not among the loops.
  const SurfaceModel ragged = make_surface_model(test::ragged_boundary().ragged);
  EXPECT_TRUE(trim_pierced(ragged, holes_of(ragged)).removed.empty());
  EXPECT_TRUE(trim_pierced(model, {}).removed.empty());
}

/// A wall through a sheet and its hole, too long for ten rounds.
TEST(TrimBoundary, LeavesABoundaryThatCrossesWhateverIsRemoved) {
  TriangleSoup soup = pierced_grid();
  const int pierced = static_cast<int>(soup.triangles.size()) - 1;
  const int first = static_cast<int>(soup.points.size());
  constexpr int rows = 40, columns = 12;
  const auto at = [=](int row, int column) { return first + row * (columns + 1) + column; };
  for (int row = 0; row <= rows; ++row)
    for (int column = 0; column <= columns; ++column) soup.points.emplace_back(20 + 0.5 * row, 0.5 * column, 0);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      if (column >= 4 && column < 8 && row >= 16 && row < 24) continue;
      add(soup, {at(row, column), at(row + 1, column), at(row + 1, column + 1)});
      add(soup, {at(row, column), at(row + 1, column + 1), at(row, column + 1)});
    }
  const int wall = static_cast<int>(soup.points.size());
  for (const Vec3& p : {Vec3(21, 3.1, -3), Vec3(39, 3.1, -3), Vec3(39, 3.1, 3), Vec3(21, 3.1, 3)})
    soup.points.push_back(p);
  add(soup, {wall, wall + 1, wall + 2});
  add(soup, {wall, wall + 2, wall + 3});
  const SurfaceModel model = make_surface_model(soup);
  const TrimmedModel trimmed = trim_pierced(model, holes_of(model));
  ASSERT_EQ(trimmed.removed.size(), 1U);
  EXPECT_EQ(trimmed.removed[0].face, pierced);
}

TEST(TrimBoundary, TakesTheFragmentsThatItCutsOff) {
  TriangleSoup soup = pierced_grid();
  // Two triangles beyond the one that crosses, and a fragment of two that nothing is cut from.
  const int last = static_cast<int>(soup.points.size()) - 1;
  soup.points.emplace_back(4.6, 1.2, -1.2);
  soup.points.emplace_back(4.2, 1.0, -1.4);
  const int first = add(soup, {last - 1, last, last + 1});
  add(soup, {last, last + 2, last + 1});
  const int apart = static_cast<int>(soup.points.size());
  for (const Vec3& p : {Vec3(20, 0, 0), Vec3(21, 0, 0), Vec3(20, 1, 0), Vec3(21, 1, 0)}) soup.points.push_back(p);
  add(soup, {apart, apart + 1, apart + 2});
  add(soup, {apart + 2, apart + 1, apart + 3});
  const SurfaceModel model = make_surface_model(soup);
  const TrimmedModel trimmed = trim_pierced(model, holes_of(model));
  std::map<int, BoundaryFault> removed;
  for (const BadBoundaryFace& bad : trimmed.removed) removed[bad.face] = bad.fault;
  EXPECT_EQ(removed, (std::map<int, BoundaryFault>{{first - 1, BoundaryFault::crossing},
                                                   {first, BoundaryFault::crossing},
                                                   {first + 1, BoundaryFault::fragment}}));
}

TEST(TrimBoundary, ABoundaryThatWasTrimmedIsFilledLikeOneThatWasNeverBad) {
  const test::RaggedBoundary boundary = test::ragged_boundary();
  SurfaceModel clean = make_surface_model(boundary.clean);
  const SurfaceModel ragged = make_surface_model(boundary.ragged);
  SurfaceModel trimmed = trim_boundary(ragged, holes_of(ragged), 3).model;
  for (SurfaceModel* model : {&clean, &trimmed})
    for (const HoleResult& result : fill_holes(*model, holes_of(*model), {}, nullptr, {}))
      EXPECT_TRUE(is_at_end(result.status)) << result.message;
  const auto points_from = [](const SurfaceModel& model, std::size_t first) {
    return Points(model.soup.points.begin() + static_cast<long>(first), model.soup.points.end());
  };
  EXPECT_EQ(points_from(trimmed, boundary.ragged.points.size()), points_from(clean, boundary.clean.points.size()));
  EXPECT_TRUE(find_boundary_loops(trimmed).empty());
  EXPECT_TRUE(
      self_intersections(trimmed.soup.points, trimmed.soup.triangles, static_cast<int>(trimmed.soup.triangles.size()))
          .empty());
}

TEST(TrimBoundary, RefusesWhatMakesNoSense) {
  const SurfaceModel model = make_surface_model(holed_grid());
  EXPECT_THROW(trim_boundary(model, holes_of(model), -1), InvalidArgument);
  EXPECT_THROW(trim_boundary(model, holes_of(model), 101), InvalidArgument);
}

}  // namespace
}  // namespace loopmend
