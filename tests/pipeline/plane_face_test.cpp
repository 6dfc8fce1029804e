// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/plane_face.h"

#include "core/random.h"
#include "filling/two_faces.h"
#include "pipeline/candidates.h"
#include "pipeline/fill_holes.h"
#include "pipeline/initial_patch.h"
#include "samples/analytic_surfaces.h"
#include "support/sharp_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
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

/// Rows of a wall between a polygon and the same polygon, scaled, at another height; both ends are open.
TriangleSoup frustum(int corners, double top, double height) {
  test::GridSurface wall;
  const auto corner = [&](int k) {
    const double angle = 2 * std::numbers::pi * k / corners;
    return Vec3(std::cos(angle), std::sin(angle), 0);
  };
  for (int k = 0; k < corners; ++k)
    wall.add(6, 6, [&](double x, double y) {
      const Vec3 low = (1 - x) * corner(k) + x * corner(k + 1);
      return Vec3((1 - y + y * top) * low + y * height * Vec3::UnitZ());
    });
  return std::move(wall.soup);
}

/// Its walls on one side lean; a peak or a dome would be another answer, but the loop would not be plane then.
TEST(PlaneFace, APolygonWithLeaningWallsIsClosedFlatAndIsNoOutline) {
  for (const int corners : {3, 4, 6})
    for (const double height : {0.35, 1.5}) {
      SurfaceModel model = make_surface_model(frustum(corners, 0.5, height));
      const std::vector<HoleResult> holes = fill_all_holes(model);
      ASSERT_EQ(holes.size(), 2u) << corners << ' ' << height;
      for (const HoleResult& hole : holes) {
        EXPECT_TRUE(is_filled(hole.status)) << hole.message;
        const double z = hole.loop.center.z();
        for (int v = hole.first_point; v < hole.first_point + hole.free_vertices; ++v)
          EXPECT_NEAR(model.soup.points[v].z(), z, 1e-9) << hole.patch->made_by;
      }
    }
}

TEST(PlaneFace, NoiseOfAPartKeepsAStepsTread) {
  TriangleSoup stairs = surface_of({{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}, 10);
  std::erase_if(stairs.triangles, [&](const Triangle& t) {
    return std::ranges::all_of(t, [&](int v) { return std::abs(stairs.points[v].z() - 1) < 1e-9; });
  });
  Random random(3);
  for (Vec3& p : stairs.points) p += 5e-4 * Vec3(random.bell(), random.bell(), random.bell());
  SurfaceModel model = make_surface_model(stairs);
  const std::vector<HoleResult> holes = fill_all_holes(model);
  ASSERT_EQ(holes.size(), 1u);
  EXPECT_EQ(holes[0].patch->made_by, "plane face");
  EXPECT_EQ(holes[0].verdict().grade, Grade::good) << holes[0].verdict().message();
  for (int v = holes[0].first_point; v < holes[0].first_point + holes[0].free_vertices; ++v)
    EXPECT_NEAR(model.soup.points[v].z(), 1, 2e-3);
}

/// The edge between them runs from corner to corner of the loop, convex or concave.
TEST(TwoPlaneFaces, NeighborsThatAreMissingComeBackWithTheirEdge) {
  const std::set<Cell> cube{{0, 0, 0}}, stairs{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
  for (const std::set<Cell>& cells : {cube, stairs})
    for (const int fine : {2, 8}) {
      TriangleSoup part = surface_of(cells, fine);
      const auto lies_on = [&](const Vec3& p) { return std::min(std::abs(p.x() - 1), std::abs(p.z() - 1)) < 1e-9; };
      std::erase_if(part.triangles, [&](const Triangle& t) {
        return std::ranges::all_of(t, [&](int v) { return std::abs(part.points[v].x() - 1) < 1e-9; }) ||
               std::ranges::all_of(t, [&](int v) { return std::abs(part.points[v].z() - 1) < 1e-9; });
      });
      SurfaceModel model = make_surface_model(part);
      const std::vector<HoleResult> holes = fill_all_holes(model);
      ASSERT_EQ(holes.size(), 1u);
      EXPECT_EQ(holes[0].patch->made_by, "two plane faces") << holes[0].message;
      EXPECT_EQ(holes[0].verdict().grade, Grade::good) << holes[0].verdict().message();
      int on_edge = 0;
      for (int v = holes[0].first_point; v < holes[0].first_point + holes[0].free_vertices; ++v) {
        const Vec3& p = model.soup.points[v];
        EXPECT_TRUE(lies_on(p)) << p.transpose();
        on_edge += std::max(std::abs(p.x() - 1), std::abs(p.z() - 1)) < 1e-9;
      }
      EXPECT_GE(on_edge, fine - 1);
    }
}

/// Two straight sides always lie in a plane, whichever diagonal parts them.
TEST(TwoPlaneFaces, AreNotFoundInASkewQuadrilateral) {
  const std::array<Vec3, 4> top{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0.6), Vec3(0, 1, 0)};
  for (const int along : {1, 4}) {
    test::GridSurface walls;
    for (std::size_t k = 0; k < 4; ++k)
      walls.add(along, 3, [&](double x, double y) {
        return Vec3((1 - x) * top[k] + x * top[(k + 1) % 4] + (y - 1) * Vec3::UnitZ());
      });
    const SurfaceModel model = make_surface_model(walls.soup);
    for (const BoundaryLoop& loop : find_boundary_loops(model))
      EXPECT_FALSE(two_plane_faces(model, loop, {}, {})) << along;
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
