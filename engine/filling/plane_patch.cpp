// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/plane_patch.h"

#include "mesh/triangulate_polygon.h"

#include <numeric>

namespace loopmend {

std::optional<LoopPatch> plane_patch(const Points& outline, const Vec3& normal, const InitialPatchOptions& options,
                                     const CancelToken& cancel) {
  const int n = static_cast<int>(outline.size());
  std::vector<int> polygon(outline.size());
  std::iota(polygon.begin(), polygon.end(), 0);
  if (triangulate_seen_flat(outline, polygon).empty()) return std::nullopt;
  // A neighborhood to fill from: a wall behind the outline, as high as its edges are long.
  Points points = outline;
  double perimeter = 0;
  for (int k = 0; k < n; ++k) perimeter += (outline[(k + 1) % n] - outline[k]).norm();
  for (const Vec3& p : outline) points.emplace_back(p - perimeter / n * normal);
  Triangles triangles;
  for (int k = 0; k < n; ++k) {
    const int next = (k + 1) % n;
    triangles.push_back({k, n + k, n + next});
    triangles.push_back({k, n + next, next});
  }
  const SurfaceModel wall = make_surface_model({std::move(points), std::move(triangles)});
  for (const BoundaryLoop& loop : find_boundary_loops(wall)) {
    if (wall.soup_vertex[loop.vertices.front()] >= n) continue;
    LoopPatchOutcome filled = fill_loop(wall, loop, options, cancel);
    if (!filled.patch) return std::nullopt;
    std::vector<int> place(filled.patch->points.size());
    std::iota(place.begin(), place.end(), 0);
    for (int k = 0; k < n; ++k) place[k] = wall.soup_vertex[loop.vertices[k]];
    LoopPatch patch{std::move(filled.patch->points), std::move(filled.patch->triangles)};
    std::ranges::copy(outline, patch.points.begin());
    for (Triangle& triangle : patch.triangles)
      for (int& v : triangle) v = place[v];
    return patch;
  }
  return std::nullopt;
}

}  // namespace loopmend
