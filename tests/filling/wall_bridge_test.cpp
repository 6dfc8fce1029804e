// SPDX-License-Identifier: GPL-3.0-or-later
// Plates of which only the two sides are there.
#include "filling/wall_bridge.h"

#include "filling/bridge_loops.h"
#include "filling/find_rings.h"
#include "pipeline/blend.h"
#include "repair/watertight.h"
#include "samples/analytic_surfaces.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <cmath>

namespace loopmend {
namespace {

enum class Faces { up, down };

/// The rectangle 15 × 10 at this height.
TriangleSoup side(int cells, double height, Faces faces) {
  TriangleSoup soup = make_graph([](double, double) { return 0; }, 1, cells);
  for (Vec3& p : soup.points) p = Vec3(7.5 * p.x(), 5 * p.y(), height);
  if (faces == Faces::down)
    for (Triangle& t : soup.triangles) std::swap(t[1], t[2]);
  return soup;
}

TriangleSoup both(const TriangleSoup& a, const TriangleSoup& b) {
  TriangleSoup soup = a;
  const int first = static_cast<int>(a.points.size());
  soup.points.insert(soup.points.end(), b.points.begin(), b.points.end());
  for (const Triangle& t : b.triangles) soup.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  const Eigen::Matrix3d turned = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  for (Vec3& p : soup.points) p = turned * p;
  return soup;
}

BlendResult blend_outlines(SurfaceModel& model) {
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  EXPECT_EQ(loops.size(), 2U);
  return blend_loops(model, loops, {}, {});
}

TEST(WallBridge, SidesOfAPlateGetAStraightWall) {
  for (const double thickness : {0.1, 0.5, 2.0}) {
    SurfaceModel model = make_surface_model(both(side(30, 0, Faces::down), side(24, thickness, Faces::up)));
    const BlendResult result = blend_outlines(model);
    ASSERT_EQ(result.outcome.status, PatchStatus::filled) << result.outcome.message;
    EXPECT_NE(worst(result.outcome.verdicts), Grade::bad);
    const Watertightness plate = watertightness(model.soup);
    EXPECT_TRUE(plate.printable()) << thickness;
    EXPECT_NEAR(plate.volume, 150 * thickness, 1e-9);
  }
}

/// Two layers of a dish, 0.1 apart along its normals.
TEST(WallBridge, TheSidesMayBeCurved) {
  TriangleSoup low = cut(make_icosphere(4), [](const Vec3&p) { return p.z() < 0.87; }), high = low;
  for (Vec3& p : low.points) p *= 10;
  for (Triangle& t : low.triangles) std::swap(t[1], t[2]);
  for (Vec3& p : high.points) p *= 10.4;
  SurfaceModel model = make_surface_model(both(low, high));
  const BlendResult result = blend_outlines(model);
  ASSERT_EQ(result.outcome.status, PatchStatus::filled) << result.outcome.message;
  EXPECT_TRUE(watertightness(model.soup).printable());
}

TEST(WallBridge, ASideThatIsInsideOutIsTurned) {
  const TriangleSoup second = side(24, 1, Faces::down);
  SurfaceModel model = make_surface_model(both(side(30, 0, Faces::down), second));
  const BlendResult result = blend_outlines(model);
  EXPECT_EQ(result.turned_faces, second.triangles.size());
  EXPECT_TRUE(watertightness(model.soup).encloses());
}

/// A plate with a round bore.
TEST(WallBridge, TheBoreOfAPlateGetsAStraightWall) {
  const auto drilled = [](double height, Faces faces) {
    TriangleSoup soup = side(40, height, faces);
    return cut(soup, [](const Vec3& p) { return p.head<2>().norm() < 2; });
  };
  SurfaceModel model = make_surface_model(both(drilled(0, Faces::down), drilled(1, Faces::up)));
  const auto pairs = find_rings(model, find_boundary_loops(model), {});
  EXPECT_EQ(pairs.size(), 2U);
  double area = 0;
  for (const std::vector<int>& pair : pairs) {
    const std::vector<BoundaryLoop> all = find_boundary_loops(model);
    const BoundaryLoop& rim = all[static_cast<std::size_t>(pair[0])];
    area += (rim.kind == LoopKind::outer_rim ? 1 : -1) * rim.area;
  }
  while (!find_boundary_loops(model).empty()) {
    std::vector<BoundaryLoop> loops = find_boundary_loops(model);
    loops.erase(loops.begin(), loops.end() - 2);
    ASSERT_EQ(blend_loops(model, loops, {}, {}).outcome.status, PatchStatus::filled);
  }
  EXPECT_TRUE(watertightness(model.soup).printable());
  EXPECT_NEAR(watertightness(model.soup).volume, area, 1e-6);
}

TEST(WallBridge, SheetsBesideEachOtherAreNoPlate) {
  const TriangleSoup one = side(10, 0, Faces::up);
  TriangleSoup beside = one, ahead = one;
  for (Vec3& p : beside.points) p.x() += 16;
  for (Vec3& p : ahead.points) p += Vec3(9, 0, 1);
  for (const TriangleSoup& other : {beside, ahead}) {
    const SurfaceModel model = make_surface_model(both(one, other));
    EXPECT_FALSE(ring_between(model, find_boundary_loops(model), 1, {}));
  }
}

}  // namespace
}  // namespace loopmend
