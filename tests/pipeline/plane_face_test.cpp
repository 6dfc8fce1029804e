// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/plane_face.h"

#include "pipeline/candidates.h"
#include "pipeline/fill_holes.h"
#include "pipeline/initial_patch.h"
#include "samples/analytic_surfaces.h"
#include "support/sharp_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace loopmend {
namespace {

PatchResult solved(const ScanIndex& scan, const Patch& initial, const std::vector<BoundaryLoop>& loops) {
  return solve_patch({scan, initial, loops}, {}, nullptr, {});
}

/// A cube with edges rounded to a radius of 0.15.
TriangleSoup rounded_cube() {
  constexpr double radius = 0.15;
  TriangleSoup soup = test::make_cube(24);
  for (Vec3& p : soup.points) {
    const Vec3 kernel = p.cwiseMax(radius).cwiseMin(1 - radius);
    if (p != kernel) p = kernel + radius * (p - kernel).normalized();
  }
  return soup;
}

using Cell = std::array<int, 3>;

/// The surface of unit cubes, each face of cells x cells squares.
TriangleSoup surface_of(const std::set<Cell>& cubes, int cells) {
  test::GridSurface surface;
  for (const Cell& cube : cubes)
    for (int axis = 0; axis < 3; ++axis)
      for (const int end : {0, 1}) {
        Cell beside = cube;
        beside[axis] += end == 1 ? 1 : -1;
        if (cubes.contains(beside)) continue;
        surface.add(cells, cells, [&](double x, double y) {
          Vec3 p(cube[0], cube[1], cube[2]);
          p[axis] += end;
          p[(axis + 1) % 3] += end == 1 ? x : y;
          p[(axis + 2) % 3] += end == 1 ? y : x;
          return p;
        });
      }
  return std::move(surface.soup);
}

/// Without its faces in the plane where this coordinate has this value.
void expect_plane_face(TriangleSoup part, int axis, double value) {
  std::erase_if(part.triangles, [&](const Triangle& t) {
    return std::ranges::all_of(t, [&](int v) { return std::abs(part.points[v][axis] - value) < 1e-9; });
  });
  SurfaceModel model = make_surface_model(part);
  const std::vector<HoleResult> holes = fill_all_holes(model);
  ASSERT_EQ(holes.size(), 1u);
  EXPECT_TRUE(is_filled(holes[0].status)) << holes[0].message;
  EXPECT_EQ(holes[0].verdict().grade, Grade::good) << holes[0].verdict().message();
  for (int v = holes[0].first_point; v < holes[0].first_point + holes[0].free_vertices; ++v)
    EXPECT_NEAR(model.soup.points[v][axis], value, 1e-9) << holes[0].patch->made_by;
}

TEST(PlaneFace, FacesBetweenConvexAndConcaveEdgesComeBackPlane) {
  const std::set<Cell> stairs{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}},
      slot{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 1}, {2, 0, 1}};
  for (const int cells : {1, 2, 6}) {
    SCOPED_TRACE(cells);
    expect_plane_face(surface_of(stairs, cells), 0, 1);  // the riser
    expect_plane_face(surface_of(stairs, cells), 2, 1);  // the tread
    expect_plane_face(surface_of(slot, cells), 2, 1);    // between two walls
  }
}

/// The wall is square to the plane all along, and turns by a quarter farther out.
TEST(PlaneFace, AFaceOfACoarsePrismComesBackPlane) {
  const std::set<Cell> tee{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 1}};
  for (const int cells : {1, 2}) expect_plane_face(surface_of(tee, cells), 2, 0);
}

TEST(PlaneFace, AFaceThatEndsAtARoundingAllAroundComesBackPlane) { expect_plane_face(rounded_cube(), 2, 1); }

/// Fits over several rings see the rounding; the faces beside the loop do not.
TEST(PlaneFace, AHoleBesideARoundedEdgeComesBackPlane) {
  for (double margin : {0.04, 0.1}) {
    const SurfaceModel cube = make_surface_model(
        cut(rounded_cube(), [&](const Vec3& p) { return (p - Vec3(0.5, 0.5, 1)).norm() < 0.35 - margin; }));
    const std::vector<BoundaryLoop> loops = find_boundary_loops(cube);
    ASSERT_EQ(loops.size(), 1u);
    const Patch initial = *make_initial_patch(cube, loops, {}, {}).patch;
    const PatchResult result = solved(ScanIndex(cube), initial, loops);
    EXPECT_EQ(result.attempts, std::vector<std::string>{"plane face"}) << margin;
    EXPECT_EQ(result.reason.code, "plane_face");
    EXPECT_EQ(worst(result.verdicts), Grade::good);
    for (int i = 0; i < result.patch.free_count; ++i)
      EXPECT_NEAR(result.patch.to_mesh(result.patch.positions[i]).z(), 1, 1e-9);
    EvolutionOptions exact;
    exact.boundary = BoundaryTrust::exact;  // a person's choice stands
    EXPECT_EQ(solve_patch({ScanIndex(cube), initial, loops}, exact, nullptr, {}).made_by, "flow");
  }
}

/// A plane circle round the pole of a ball lies in a plane, its faces do not; in a plane sheet the flow itself is plane.
TEST(PlaneFace, IsNoneWhereTheFacesBesideTheLoopLeaveItsPlane) {
  const SurfaceModel ball =
      make_surface_model(make_revolution([](double z) { return std::sqrt(1 - z * z); }, -0.9, std::cos(0.1), 60, 120));
  const std::vector<BoundaryLoop> loops = find_boundary_loops(ball);
  const BoundaryLoop pole = loops[0].center.z() > loops[1].center.z() ? loops[0] : loops[1];
  const PatchResult result = solved(ScanIndex(ball), *make_initial_patch(ball, {pole}, {}, {}).patch, {pole});
  EXPECT_EQ(std::ranges::count(result.attempts, "plane face"), 0);
}

}  // namespace
}  // namespace loopmend
