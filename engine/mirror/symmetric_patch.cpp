// SPDX-License-Identifier: GPL-3.0-or-later
#include "mirror/symmetric_patch.h"

#include "core/threads.h"
#include "mesh/surface_tree.h"
#include "mirror/carry_misfit.h"

#include <algorithm>
#include <limits>

namespace loopmend {

namespace {

double squared_distance(const Vec3& p, const Points& closed_line) {
  double least = std::numeric_limits<double>::max();
  for (std::size_t k = 0; k < closed_line.size(); ++k) {
    const Vec3 &a = closed_line[k], edge = closed_line[(k + 1) % closed_line.size()] - a;
    const double length = edge.squaredNorm(), along = length > 0 ? std::clamp((p - a).dot(edge) / length, 0.0, 1.0) : 0;
    least = std::min(least, (a + along * edge - p).squaredNorm());
  }
  return least;
}

Points points_at(const Points& points, const std::vector<int>& vertices, int shift) {
  Points found;
  for (int v : vertices) found.push_back(points[v + shift]);
  return found;
}

}  // namespace

bool lies_across(const Patch& patch, const MirrorPlane& plane) {
  double lowest = 0, highest = 0;
  for (int v : patch.loops[0]) {
    const double height = plane.normal.dot(patch.to_mesh(patch.positions[v]) - plane.point);
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
  }
  return lowest < 0 && highest > 0;
}

std::optional<Patch> symmetric_patch(const SurfaceModel& model, const TriangleIndex& index, const Patch& patch,
                                     const MirrorPlane& plane, const CancelToken& cancel) {
  MirrorImage image = mirror_image(model, index, patch, collar_of(patch), plane, MirrorOf::closed_surface, cancel);
  if (image.triangles.empty() || !carry_misfit(patch, cancel, image)) return std::nullopt;
  const int first = static_cast<int>(image.points.size()) - patch.vertex_count();
  const Points loop = points_at(patch.positions, patch.loops[0], 0);
  const Points loop_image = points_at(image.points, patch.loops[0], first);
  const SurfaceTree tree(image.points, image.triangles);
  Patch symmetric = patch;
  parallel_for(0, patch.free_count, 64, [&](int v) {
    if (cancel.cancelled()) return;
    const Vec3& p = patch.positions[v];
    const SurfacePoint found = tree.closest(p);
    const double own = squared_distance(p, loop);
    const double other = found.triangle < image.surface_triangles ? 0 : squared_distance(found.place, loop_image);
    if (own + other > 0) symmetric.positions[v] += own / (own + other) * (found.place - p);
  });
  if (cancel.cancelled()) return std::nullopt;
  return symmetric;
}

}  // namespace loopmend
