// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/rim_groups.h"

#include "pipeline/hand_bridge.h"
#include "samples/analytic_surfaces.h"
#include "samples/paper_inputs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace loopmend {
namespace {

TriangleSoup beside(const TriangleSoup& a, TriangleSoup b, const Vec3& moved) {
  for (Vec3& p : b.points) p += moved;
  return joined({a, b});
}

TriangleSoup sheet(int cells) {
  return make_graph([](double, double) { return 0; }, 1, cells);
}

std::vector<RimGroup> groups_of(const SurfaceModel& model) {
  return find_rim_groups(model, find_boundary_loops(model), {});
}

/// A rod with one round end, which begins at its other end.
TriangleSoup rod(double sense) {
  TriangleSoup soup = make_revolution(
      [](double z) { return z < 3 ? 1 : std::sqrt(std::max(1 - (z - 3) * (z - 3), 1e-4)); }, 0, 3.99, 32, 20);
  for (Vec3& p : soup.points) p.z() *= sense;
  if (sense < 0)
    for (Triangle& t : soup.triangles) std::swap(t[1], t[2]);
  return soup;
}

TEST(RimGroups, EndsOfRodsThatLookAtEachOther) {
  for (const double gap : {0.2, 1.0, 3.0}) {
    const SurfaceModel model = make_surface_model(beside(rod(1), rod(-1), {0, 0.05, -gap}));
    const std::vector<RimGroup> groups = groups_of(model);
    ASSERT_EQ(groups.size(), 1U) << gap;
    EXPECT_EQ(groups[0].kind, RimGroup::Kind::tube);
    const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
    for (const int loop : groups[0].loops)
      EXPECT_GT(loops[static_cast<std::size_t>(loop)].diameter, 1.9);  // not the tips
  }
}

TEST(RimGroups, EndsThatLookAwayOrPastEachOtherAreNoPair) {
  EXPECT_TRUE(groups_of(make_surface_model(make_cylinder(1, 32))).empty());
  EXPECT_TRUE(groups_of(make_surface_model(beside(rod(1), rod(-1), {2.5, 0, -0.5}))).empty());
  EXPECT_TRUE(groups_of(make_surface_model(beside(rod(1), rod(-1), {0, 0, -9}))).empty());
}

/// The strips that are named make a hole of the gap, as wide as it is.
TEST(RimGroups, AGapBetweenSheetsAndTheStripsThatMakeAHoleOfIt) {
  for (const double width : {0.02, 0.1, 0.3})
    for (const int cells : {20, 27}) {
      const SurfaceModel model = make_surface_model(beside(sheet(20), sheet(cells), {2 + width, 0.03, 0}));
      const std::vector<RimGroup> groups = groups_of(model);
      ASSERT_EQ(groups.size(), 1U);
      ASSERT_EQ(groups[0].kind, RimGroup::Kind::gap);
      EXPECT_NEAR(groups[0].width, width, 1e-9);
      SurfaceModel bridged = model;
      for (const auto& [a, b] : groups[0].bridges) bridged = make_surface_model(with_bridge(bridged, a, b));
      const std::vector<BoundaryLoop> loops = find_boundary_loops(bridged);
      ASSERT_EQ(loops.size(), 2U);
      EXPECT_EQ(loops[1].kind, LoopKind::hole);
      EXPECT_NEAR(loops[1].area, width * 2, 0.25 * width * 2);
      for (const Vec3& p : bridged.soup.points) EXPECT_NEAR(p.z(), 0, 1e-12);
    }
}

TEST(RimGroups, SheetsFarApartOrAcrossACornerHaveNoGap) {
  EXPECT_TRUE(groups_of(make_surface_model(beside(sheet(20), sheet(20), {3.2, 0, 0}))).empty());
  EXPECT_TRUE(groups_of(make_surface_model(beside(sheet(20), sheet(20), {2.1, 2.1, 0}))).empty());
}

}  // namespace
}  // namespace loopmend
