// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/straight_base.h"

#include "filling/plane_patch.h"
#include "mesh/loop_facing.h"
#include "mesh/triangulate_polygon.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace loopmend {

namespace {

constexpr double edges_below = 0.5, diameters_below = 0.02;
/// Base points follow each other at these distances, in boundary edges: the least at which the outline does not cross itself.
constexpr std::array spacings{0.75, 1.5};
constexpr int fewest_base_points = 8;
constexpr int beside = 4;  ///< vertices to either side from which the outline has its direction

/// The loop's vertices, base points below them, and the wall between.
struct Wall {
  Points points;
  int base = 0;  ///< first base point
  Triangles triangles;
};

/// Where the loop's vertices lie on the unrolled wall: how far along the outline from the first one, and how far above the base.
struct Unrolled {
  std::vector<double> along;  ///< one more than vertices: back at the first
  std::vector<double> height;
};

/// @param below  the vertices' projections onto the base's plane
Unrolled unroll(const Points& loop, const Points& below, const Vec3& down) {
  const std::size_t n = loop.size();
  Unrolled result{{0}, {}};
  for (std::size_t k = 0; k < n; ++k) {
    const Vec3 direction = (below[(k + beside) % n] - below[(k + n - beside) % n]).normalized();
    result.along.push_back(result.along.back() + (below[(k + 1) % n] - below[k]).dot(direction));
    result.height.push_back((below[k] - loop[k]).dot(down));
  }
  return result;
}

/// @param loop  from one of its lowest vertices on. @returns no triangles where wall or base would overlap itself.
Wall wall_to(const Points& loop, const Vec3& down, double height, double spacing) {
  const int n = static_cast<int>(loop.size());
  Wall wall{loop, n, {}};
  Points below;
  for (const Vec3& p : loop) below.emplace_back(p + (height - p.dot(down)) * down);
  const Unrolled unrolled = unroll(loop, below, down);
  const double length = unrolled.along.back();
  std::vector<double> base_along;
  for (int k = 0; k < n; ++k) {
    const double along = unrolled.along[k];
    if (!base_along.empty() && (along < base_along.back() + spacing || along > length - spacing)) continue;
    base_along.push_back(along);
    wall.points.push_back(below[k]);
  }
  const int count = static_cast<int>(base_along.size());
  if (count < fewest_base_points) return wall;
  // The wall as one polygon, cut open below the first vertex: the loop, then the base backwards.
  Points flat;
  std::vector<int> point_of;
  for (int k = 0; k <= n; ++k) {
    flat.emplace_back(unrolled.along[k], unrolled.height[k % n], 0);
    point_of.push_back(k % n);
  }
  for (int b = count; b >= 0; --b) {
    flat.emplace_back(b == count ? length : base_along[b], 0, 0);
    point_of.push_back(wall.base + b % count);
  }
  std::vector<int> polygon(flat.size());
  std::iota(polygon.begin(), polygon.end(), 0);
  for (const auto& t : triangulate_seen_flat(flat, polygon))
    wall.triangles.push_back({point_of[t[0]], point_of[t[1]], point_of[t[2]]});
  return wall;
}

/// The wall with a plane patch below; the wall's points stay the first.
std::optional<LoopPatch> with_plane(const Wall& wall, const Vec3& down, const InitialPatchOptions& options,
                                    const CancelToken& cancel) {
  const Points outline(wall.points.begin() + wall.base, wall.points.end());
  const std::optional<LoopPatch> plane = plane_patch(outline, down, options, cancel);
  if (!plane) return std::nullopt;
  LoopPatch patch{wall.points, wall.triangles};
  patch.points.insert(patch.points.end(), plane->points.begin() + static_cast<std::ptrdiff_t>(outline.size()),
                      plane->points.end());
  for (const auto& t : plane->triangles)
    patch.triangles.push_back({wall.base + t[0], wall.base + t[1], wall.base + t[2]});
  return patch;
}

/// Turns the first `count` points, a closed curve, so that the one at `first` becomes the first.
void start_at(int first, int count, LoopPatch& patch) {
  std::rotate(patch.points.begin(), patch.points.begin() + first, patch.points.begin() + count);
  for (auto& triangle : patch.triangles)
    for (int& v : triangle)
      if (v < count) v = (v - first + count) % count;
}

}  // namespace

std::optional<LoopPatch> straight_base(const SurfaceModel& model, const BoundaryLoop& loop,
                                       const InitialPatchOptions& options, const CancelToken& cancel) {
  const LoopFacing facing = loop_facing(model, loop);
  if (facing.axis.isZero()) return std::nullopt;
  const Vec3 down = facing.onward.dot(facing.axis) < 0 ? Vec3(-facing.axis) : facing.axis;
  Points points;
  for (const int v : loop.vertices) points.push_back(model.mesh.point(TriMesh::VertexHandle(v)));
  const auto lowest = std::ranges::max_element(points, {}, [&](const Vec3& p) { return p.dot(down); });
  const double edge = loop.perimeter / loop.edges();
  const double height = lowest->dot(down) + std::min(edges_below * edge, diameters_below * loop.diameter);
  const auto first = lowest - points.begin();
  std::ranges::rotate(points, lowest);
  for (const double spacing : spacings) {
    const Wall wall = wall_to(points, down, height, spacing * edge);
    if (wall.triangles.empty()) continue;
    std::optional<LoopPatch> patch = with_plane(wall, down, options, cancel);
    if (!patch) continue;
    start_at(static_cast<int>(points.size() - first) % loop.edges(), loop.edges(), *patch);
    return patch;
  }
  return std::nullopt;
}

}  // namespace loopmend
