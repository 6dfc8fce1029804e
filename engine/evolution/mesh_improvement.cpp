// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolution/mesh_improvement.h"

#include "remeshing/patch_remesh.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace loopmend {

Patch tangentially_relaxed(const EvolutionState& state) {
  const Patch& old = state.patch;
  Patch patch = old;
  for (int i = 0; i < old.free_count; ++i) {
    if (!state.ops.valid[i]) continue;
    const Vec3& p = old.positions[i];
    Vec3 centroid = Vec3::Zero();
    double total = 0, shortest = std::numeric_limits<double>::max();
    for (int f : state.topology->faces(i)) {
      const Triangle& t = old.triangles[f];
      const Vec3 &a = old.positions[t[0]], &b = old.positions[t[1]], &c = old.positions[t[2]];
      const double area = (b - a).cross(c - a).norm();
      centroid += area * (a + b + c) / 3;
      total += area;
    }
    for (int j : state.topology->neighbors(i)) shortest = std::min(shortest, (old.positions[j] - p).norm());
    if (!(total > 0)) continue;
    const Vec3& n = state.ops.normal[i];
    Vec3 slide = 0.5 * (centroid / total - p);
    slide -= n.dot(slide) * n;
    const double length = slide.norm();
    if (length > 0.25 * shortest) slide *= 0.25 * shortest / length;
    patch.positions[i] = p + slide + 0.5 * slide.dot(state.ops.second_form[i] * slide) * n;
  }
  return patch;
}

Patch with_delaunay_flips(const Patch& patch) {
  ConstrainedRemesher mesh = open_for_remeshing(patch);
  mesh.flip_to_delaunay();
  return with_interior(patch, mesh);
}

Patch remeshed(const Patch& patch) {
  ConstrainedRemesher mesh = open_for_remeshing(patch);
  for (int round = 0; round < 2; ++round) {
    mesh.untangle();
    mesh.split_long_edges();
    mesh.flip_to_delaunay();
    mesh.collapse_short_edges();
    mesh.flip_to_delaunay();
    mesh.smooth_tangentially();
  }
  Patch result = with_interior(patch, mesh);
  return result.free_count > 0 ? result : patch;  // a flow needs a vertex that it can move
}

}  // namespace loopmend
