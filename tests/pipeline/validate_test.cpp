// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/validate.h"

#include "samples/analytic_surfaces.h"
#include "support/patches.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace loopmend {
namespace {

BoundaryLoop longest_loop(const SurfaceModel& model) {
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  return *std::max_element(loops.begin(), loops.end(),
                           [](const BoundaryLoop& a, const BoundaryLoop& b) { return a.edges() < b.edges(); });
}

TEST(PiercedEdges, AreThoseThatRunThroughOtherTriangles) {
  TriangleSoup soup = cut(make_icosphere(3), [](const Vec3& p) { return p.z() > 0.7; });
  const SurfaceModel open = make_surface_model(soup);
  const BoundaryLoop boundary = longest_loop(open);
  EXPECT_EQ(pierced_edges(ScanIndex(open), boundary), 0);

  // A small triangle of its own, square to one edge of the boundary, about its middle.
  const Vec3 p = open.soup.points[boundary.vertices[0]], q = open.soup.points[boundary.vertices[1]],
             along = (q - p).normalized();
  const Vec3 u = along.unitOrthogonal(), v = along.cross(u), middle = (p + q) / 2;
  const int first = static_cast<int>(soup.points.size());
  const double size = 0.2 * (q - p).norm();
  soup.points.insert(soup.points.end(), {middle + size * u, middle + size * (v - u), middle - size * (v + u)});
  soup.triangles.push_back({first, first + 1, first + 2});
  const SurfaceModel pierced = make_surface_model(soup);
  EXPECT_EQ(pierced_edges(ScanIndex(pierced), longest_loop(pierced)), 1);
}

}  // namespace
}  // namespace loopmend
