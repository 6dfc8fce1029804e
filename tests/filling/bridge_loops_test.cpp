// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/bridge_loops.h"

#include "core/error.h"
#include "filling/bridge_topology.h"
#include "mesh/quality.h"
#include "mesh/self_intersections.h"
#include "support/patches.h"
#include "support/tubes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

namespace loopmend {
namespace {

using test::tube_towards;

/// Vertices − edges + triangles of the patch's own part.
int euler_number(const Patch& patch) {
  std::map<std::pair<int, int>, int> edges;
  std::map<int, int> vertices;
  for (int f = 0; f < patch.patch_triangles; ++f)
    for (int k = 0; k < 3; ++k) {
      ++edges[std::minmax(patch.triangles[f][k], patch.triangles[f][(k + 1) % 3])];
      ++vertices[patch.triangles[f][k]];
    }
  for (const auto& [edge, faces] : edges) EXPECT_LE(faces, 2);
  return static_cast<int>(vertices.size()) - static_cast<int>(edges.size()) + patch.patch_triangles;
}

void expect_valid_bridge(const std::vector<TubeShape>& tubes) {
  const SurfaceModel model = test::tubes_model(tubes);
  const BridgeOutcome outcome = bridge_loops(model, test::inner_boundaries(model, tubes), {}, {});
  ASSERT_TRUE(outcome.bridge) << outcome.message;
  EXPECT_EQ(outcome.message.english(), "");
  for (const Patch* patch : {&outcome.bridge->membrane, &outcome.bridge->start}) {
    EXPECT_EQ(euler_number(*patch), 2 - static_cast<int>(tubes.size()));
    EXPECT_EQ(count_folds(patch->positions, patch->triangles, patch->patch_triangles), 0);
    EXPECT_TRUE(self_intersections(patch->positions, patch->triangles, patch->patch_triangles).empty());
    SurfaceModel pasted = model;
    append_patch(pasted, patch_geometry(*patch));
    EXPECT_EQ(find_boundary_loops(pasted).size(), tubes.size());  // the outer ends are left
  }
  EXPECT_GT(outcome.bridge->quality.min_angle_deg, 15);
}

TEST(BridgeLoops, TwoCoaxialTubesEqualAndUnequal) {
  expect_valid_bridge({tube_towards({0, 0, 1}, 1, 1), tube_towards({0, 0, -1}, 1, 1)});
  expect_valid_bridge({tube_towards({0, 0, 1}, 3, 1), tube_towards({0, 0, -1}, 3, 0.5, 16)});
}

TEST(BridgeLoops, ElbowsAndAUTurn) {
  expect_valid_bridge({tube_towards({1, 0, 0}, 2), tube_towards({0, 1, 0}, 2)});
  expect_valid_bridge({tube_towards({1, 0, 0}, 2), tube_towards({0.5, 0.8, 0.2}, 2, 0.5)});
  expect_valid_bridge({{{1.5, 0, 0}, {0, 0, 1}, 0.8, 2, 24}, {{-1.5, 0, 0}, {0, 0, 1}, 0.8, 2, 24}});
}

TEST(BridgeLoops, ThreeFourAndSixTubesAtRightAndOddAngles) {
  expect_valid_bridge({tube_towards({1, 0, 0}), tube_towards({-1, 0, 0}), tube_towards({0, 0, 1})});
  expect_valid_bridge(
      {tube_towards({1, 0, 0}), tube_towards({-0.6, 1, 0}, 1.7, 0.5), tube_towards({-0.3, -0.5, 1}, 2, 1)});
  expect_valid_bridge({tube_towards({1, 0.1, 0}, 1.8), tube_towards({-1, 0.3, 0.2}, 1.5, 0.5),
                       tube_towards({0.3, 1, 0.2}, 1.6, 0.6), tube_towards({0.1, -1, 0.8}, 1.7, 0.7)});
  expect_valid_bridge(six_tubes(24));
}

TEST(BridgeLoops, FindsTheTubeThatIsInsideOut) {
  const std::vector<TubeShape> tubes{tube_towards({1, 0, 0}), tube_towards({0, 1, 0}), tube_towards({0, 0, 1})};
  std::vector<TriangleSoup> parts;
  for (const TubeShape& tube : tubes) parts.push_back(make_tube(tube));
  for (Triangle& t : parts[1].triangles) std::swap(t[1], t[2]);
  const SurfaceModel model = make_surface_model(joined(parts));
  EXPECT_EQ(find_opposed_loops(model, test::inner_boundaries(model, tubes)), std::vector<int>{1});
}

TEST(BridgeLoops, RefusesOneLoopALoopTwiceAndACrack) {
  const SurfaceModel model = test::tubes_model({tube_towards({1, 0, 0})});
  std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  EXPECT_THROW(bridge_loops(model, {loops[0]}, {}, {}), InvalidArgument);
  EXPECT_THROW(bridge_loops(model, {loops[0], loops[0]}, {}, {}), InvalidArgument);
  loops[1].kind = LoopKind::crack;
  EXPECT_THROW(bridge_loops(model, loops, {}, {}), InvalidArgument);
}

TEST(BridgeTopology, RoundingGivesALoopAroundTheCentreNoSense) {
  BridgeEnd circle{{}, Vec3::UnitZ(), Vec3::Zero(), {}};
  for (int k = 0; k < 12; ++k) circle.points.emplace_back(std::cos(k * M_PI / 6), std::sin(k * M_PI / 6), 0);
  EXPECT_EQ(turning_sense(circle, {0, 0, 1e-8}), 0);
  EXPECT_EQ(turning_sense(circle, {0, 0, -1e-8}), 0);
  EXPECT_EQ(turning_sense(circle, {0, 0, 0.5}), 1);
  EXPECT_EQ(turning_sense(circle, {0, 0, -0.5}), -1);
}

TEST(BridgeTopology, AStripHasOneTriangleForEachEdge) {
  Points a, b;
  for (int i = 0; i < 12; ++i) a.emplace_back(std::cos(i * M_PI / 6), std::sin(i * M_PI / 6), 0);
  for (int i = 0; i < 7; ++i) b.emplace_back(2 * std::cos(i * 2 * M_PI / 7), -2 * std::sin(i * 2 * M_PI / 7), 0);
  const Triangles strip = bridge_by_strip(a, b);
  ASSERT_EQ(strip.size(), 19u);
  double area = 0;
  Points all = a;
  all.insert(all.end(), b.begin(), b.end());
  for (const Triangle& t : strip) area += 0.5 * std::abs((all[t[1]] - all[t[0]]).cross(all[t[2]] - all[t[0]]).z());
  // Outer heptagon minus inner dodecagon: neither overlap nor gap.
  EXPECT_NEAR(area, 0.5 * 7 * 4 * std::sin(2 * M_PI / 7) - 0.5 * 12 * std::sin(M_PI / 6), 1e-12);
}

}  // namespace
}  // namespace loopmend
