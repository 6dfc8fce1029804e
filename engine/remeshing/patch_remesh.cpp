// SPDX-License-Identifier: GPL-3.0-or-later
#include "remeshing/patch_remesh.h"

#include "mesh/directed_edges.h"
#include "mesh/quality.h"
#include "remeshing/size_field.h"

namespace loopmend {

namespace {

/// Fixed vertices of the patch's own triangles: those on the loops, and those that stand alone among free ones.
int rim_size(const Patch& patch) {
  int rim = 0;
  while (patch.free_count + rim < patch.vertex_count() && patch.ring[patch.free_count + rim] == 1) ++rim;
  return rim;
}

/// Mean length of the edges at each rim vertex: of those in the surroundings, or of all where there are none.
std::vector<double> rim_edge_lengths(const Patch& patch, int rim) {
  std::vector<double> outside(rim, 0), inside(rim, 0), outside_count(rim, 0), inside_count(rim, 0);
  for (std::size_t f = 0; f < patch.triangles.size(); ++f) {
    const bool own = static_cast<int>(f) < patch.patch_triangles;
    for (int k = 0; k < 3; ++k) {
      const int a = patch.triangles[f][k], b = patch.triangles[f][(k + 1) % 3];
      const double length = (patch.positions[a] - patch.positions[b]).norm();
      for (int v : {a, b}) {
        const int i = v - patch.free_count;
        if (i < 0 || i >= rim) continue;
        (own ? inside : outside)[i] += length;
        (own ? inside_count : outside_count)[i] += 1;
      }
    }
  }
  for (int i = 0; i < rim; ++i)
    outside[i] = outside_count[i] > 0 ? outside[i] / outside_count[i] : inside[i] / std::max(1.0, inside_count[i]);
  return outside;
}

}  // namespace

bool remesh_once(ConstrainedRemesher& mesh) {
  int changes = mesh.split_long_edges();
  mesh.flip_to_delaunay();
  changes += mesh.collapse_short_edges();
  mesh.flip_to_delaunay();
  for (int sweep = 0; sweep < 3; ++sweep) mesh.smooth_tangentially();
  return changes > mesh.free_count() / 200;
}

ConstrainedRemesher open_for_remeshing(const Patch& patch) {
  const int n = patch.free_count, rim = rim_size(patch);
  const auto renumber = [&](int v) { return v < n ? v + rim : v - n; };
  Points points(patch.positions.begin() + n, patch.positions.begin() + n + rim);
  points.insert(points.end(), patch.positions.begin(), patch.positions.begin() + n);
  Triangles triangles;
  for (int f = 0; f < patch.patch_triangles; ++f) {
    Triangle t = patch.triangles[f];
    for (int& v : t) v = renumber(v);
    triangles.push_back(t);
  }
  const DirectedEdges edges(triangles, patch.patch_triangles);
  RimNormals normals;
  for (std::size_t f = patch.patch_triangles; f < patch.triangles.size(); ++f) {
    const Triangle& t = patch.triangles[f];
    for (int k = 0; k < 3; ++k) {
      const std::pair<int, int> edge{renumber(t[(k + 1) % 3]), renumber(t[k])};
      if (edge.first < rim && edge.second < rim && edges.is_open(edge))
        normals[edge] = unit_normal(patch.positions[t[0]], patch.positions[t[1]], patch.positions[t[2]]);
    }
  }
  const auto field = std::make_shared<SizeField>(Points(points.begin(), points.begin() + rim),
                                                 rim_edge_lengths(patch, rim), patch.grading);
  return ConstrainedRemesher(points, triangles, rim, normals, [field](const Vec3& p) { return field->at(p); });
}

Patch with_interior(const Patch& patch, const ConstrainedRemesher& mesh) {
  const Points points = mesh.points();
  const int rim = mesh.locked();
  Patch result = patch;
  result.free_count = static_cast<int>(points.size()) - rim;
  const int shift = result.free_count - patch.free_count;
  result.positions.assign(points.begin() + rim, points.end());
  result.positions.insert(result.positions.end(), patch.positions.begin() + patch.free_count, patch.positions.end());
  result.ring.assign(result.free_count, 0);
  result.ring.insert(result.ring.end(), patch.ring.begin() + patch.free_count, patch.ring.end());
  result.view_vertex.assign(result.free_count, -1);
  result.view_vertex.insert(result.view_vertex.end(), patch.view_vertex.begin() + patch.free_count,
                            patch.view_vertex.end());
  result.triangles.clear();
  for (Triangle t : mesh.triangles()) {
    for (int& v : t) v = v < rim ? v + result.free_count : v - rim;
    result.triangles.push_back(t);
  }
  result.patch_triangles = static_cast<int>(result.triangles.size());
  for (std::size_t f = patch.patch_triangles; f < patch.triangles.size(); ++f) {
    Triangle t = patch.triangles[f];
    for (int& v : t) v += shift;
    result.triangles.push_back(t);
  }
  for (auto& loop : result.loops)
    for (int& v : loop) v += shift;
  return result;
}

}  // namespace loopmend
