// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/repair_surface.h"

#include "mesh/boundary_loops.h"
#include "mesh/surface_model.h"
#include "samples/analytic_surfaces.h"

#include <gtest/gtest.h>

namespace loopmend {
namespace {

ModelRepairs left_to_repair(const TriangleSoup& soup) { return make_surface_model(soup).repairs; }

TEST(RepairSurface, LeavesASoundMeshAsItIs) {
  const TriangleSoup soup = cut(make_icosphere(3), [](const Vec3& p) { return p.z() > 0.8; });
  const RepairedSurface repaired = repair_surface(soup);
  EXPECT_FALSE(repaired.counts.any());
  EXPECT_EQ(repaired.soup.points, soup.points);
  EXPECT_EQ(repaired.soup.triangles, soup.triangles);
}

TEST(RepairSurface, SeparatesAFinAndCountsWhatIsDegenerateOrTwice) {
  TriangleSoup soup = make_icosphere(3);
  const std::size_t sound = soup.triangles.size(), points = soup.points.size();
  const Triangle first = soup.triangles.front();
  soup.points.emplace_back(0, 0, 5);
  soup.triangles.push_back({first[0], first[1], static_cast<int>(points)});  // a fin
  soup.triangles.push_back({first[1], first[2], first[0]});
  soup.triangles.push_back({first[1], first[1], first[0]});
  const RepairedSurface repaired = repair_surface(soup);
  EXPECT_EQ(repaired.counts.degenerate_faces, 1u);
  EXPECT_EQ(repaired.counts.duplicate_faces, 1u);
  EXPECT_EQ(repaired.counts.separated_edges, 1u);
  EXPECT_EQ(repaired.counts.separated_vertices, 2u);
  EXPECT_EQ(repaired.soup.triangles.size(), sound + 1);
  EXPECT_EQ(repaired.soup.points.size(), points + 3);
  for (std::size_t v = 0; v <= points; ++v) EXPECT_EQ(repaired.soup.points[v], soup.points[v]);
  const ModelRepairs left = left_to_repair(repaired.soup);
  EXPECT_EQ(left.non_manifold_edges + left.non_manifold_vertices + left.duplicate_faces + left.degenerate_faces, 0u);
  EXPECT_FALSE(repair_surface(repaired.soup).counts.any());  // once is enough
}

TEST(RepairSurface, TurnsFacesAndRemovesCrumbs) {
  TriangleSoup soup = make_icosphere(3);
  std::swap(soup.triangles[7][1], soup.triangles[7][2]);
  const int first = static_cast<int>(soup.points.size());
  for (const Vec3& p : {Vec3(2, 0, 0), Vec3(2.01, 0, 0), Vec3(2, 0.01, 0)}) soup.points.push_back(p);
  soup.triangles.push_back({first, first + 1, first + 2});
  const RepairedSurface repaired = repair_surface(soup);
  EXPECT_EQ(repaired.counts.turned_faces, 1u);
  EXPECT_EQ(repaired.counts.removed_pieces, 1u);
  EXPECT_EQ(repaired.counts.removed_faces, 1u);
  EXPECT_EQ(repaired.soup.triangles.size(), 1280u);
  EXPECT_TRUE(find_boundary_loops(make_surface_model(repaired.soup)).empty());
}

}  // namespace
}  // namespace loopmend
