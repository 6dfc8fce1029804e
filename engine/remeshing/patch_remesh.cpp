// SPDX-License-Identifier: GPL-3.0-or-later
#include "remeshing/patch_remesh.h"

#include "mesh/directed_edges.h"
#include "mesh/quality.h"
#include "remeshing/double_edges.h"
#include "remeshing/size_field.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace loopmend {

namespace {

/// Fixed vertices of the patch's own triangles: those on the loops, and those that stand alone among free ones.
int boundary_size(const Patch& patch) {
  int boundary = 0;
  while (patch.free_count + boundary < patch.vertex_count() && patch.ring[patch.free_count + boundary] == 1) ++boundary;
  return boundary;
}

/// The locked vertices of a remesher: those of the boundary. Where holes touch, the patch's own triangles at a boundary vertex lie in
/// several fans; each but the first gets a copy of the vertex, so that the remesher has an ordinary mesh.
class LockedVertices {
 public:
  LockedVertices(const Patch& patch, int boundary)
      : own_(patch.triangles.begin(), patch.triangles.begin() + patch.patch_triangles) {
    boundary_vertex_.resize(boundary);
    std::iota(boundary_vertex_.begin(), boundary_vertex_.end(), 0);
    std::vector<std::vector<int>> faces(boundary);
    for (int f = 0; f < patch.patch_triangles; ++f)
      for (int v : own_[f])
        if (const int i = v - patch.free_count; i >= 0 && i < boundary) faces[i].push_back(f);
    for (int i = 0; i < boundary; ++i) add_copies(patch.free_count + i, i, std::move(faces[i]));
    for (Triangle& t : own_)
      for (int& v : t) v = v < patch.free_count ? v + count() : v - patch.free_count;
    for (auto& [corner, copy] : copies_) own_[corner.first][corner.second] = copy;
  }

  int count() const { return static_cast<int>(boundary_vertex_.size()); }
  /// #count: in the order of the patch's fixed vertices.
  const std::vector<int>& boundary_vertex() const { return boundary_vertex_; }
  /// The patch's own, over locked vertices and then free ones.
  const Triangles& own_triangles() const { return own_; }

 private:
  /// @param faces  at vertex v of the patch, whose first copy is locked vertex i.
  void add_copies(int v, int i, std::vector<int> faces) {
    for (bool first = true; !faces.empty(); first = false) {
      std::vector<int> fan{faces.front()};
      faces.erase(faces.begin());
      for (std::size_t k = 0; k < fan.size(); ++k)
        std::erase_if(faces, [&](int g) {
          const bool beside = share_edge_at(v, own_[fan[k]], own_[g]);
          if (beside) fan.push_back(g);
          return beside;
        });
      if (first) continue;
      for (int f : fan)
        for (int k = 0; k < 3; ++k)
          if (own_[f][k] == v) copies_.push_back({{f, k}, count()});
      boundary_vertex_.push_back(i);
    }
  }

  static bool share_edge_at(int v, const Triangle& t, const Triangle& u) {
    return std::any_of(t.begin(), t.end(),
                       [&](int w) { return w != v && std::find(u.begin(), u.end(), w) != u.end(); });
  }

  Triangles own_;
  std::vector<int> boundary_vertex_;
  std::vector<std::pair<std::pair<int, int>, int>> copies_;  ///< (triangle, corner) → locked vertex
};

/// Mean length of the edges at each boundary vertex: of those in the neighborhood, or of all where there are none.
std::vector<double> boundary_edge_lengths(const Patch& patch, int boundary) {
  std::vector<double> outside(boundary, 0), inside(boundary, 0), outside_count(boundary, 0), inside_count(boundary, 0);
  for (std::size_t f = 0; f < patch.triangles.size(); ++f) {
    const bool own = static_cast<int>(f) < patch.patch_triangles;
    for (int k = 0; k < 3; ++k) {
      const int a = patch.triangles[f][k], b = patch.triangles[f][(k + 1) % 3];
      const double length = (patch.positions[a] - patch.positions[b]).norm();
      for (int v : {a, b}) {
        const int i = v - patch.free_count;
        if (i < 0 || i >= boundary) continue;
        (own ? inside : outside)[i] += length;
        (own ? inside_count : outside_count)[i] += 1;
      }
    }
  }
  for (int i = 0; i < boundary; ++i)
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
  const int n = patch.free_count, boundary = boundary_size(patch);
  const LockedVertices locked(patch, boundary);
  const Triangles& triangles = locked.own_triangles();
  Points points;
  for (int i : locked.boundary_vertex()) points.push_back(patch.positions[n + i]);
  points.insert(points.end(), patch.positions.begin(), patch.positions.begin() + n);
  // Edges along the boundary as they run in the patch, by boundary vertices: where no triangle of the patch is on their other side.
  const DirectedEdges edges(triangles, patch.patch_triangles);
  std::map<std::pair<int, int>, std::pair<int, int>> open_edges;
  for (const auto& edge : edges.all())
    if (edge.first < locked.count() && edge.second < locked.count() && edges.is_open(edge))
      open_edges[{locked.boundary_vertex()[edge.first], locked.boundary_vertex()[edge.second]}] = edge;
  BoundaryNormals normals;
  for (std::size_t f = patch.patch_triangles; f < patch.triangles.size(); ++f) {
    const Triangle& t = patch.triangles[f];
    for (int k = 0; k < 3; ++k)
      if (const auto edge = open_edges.find({t[(k + 1) % 3] - n, t[k] - n}); edge != open_edges.end())
        normals[edge->second] = unit_normal(patch.positions[t[0]], patch.positions[t[1]], patch.positions[t[2]]);
  }
  const auto field = std::make_shared<SizeField>(Points(points.begin(), points.begin() + boundary),
                                                 boundary_edge_lengths(patch, boundary), patch.grading);
  return ConstrainedRemesher(points, triangles, locked.count(), normals,
                             [field](const Vec3& p) { return field->at(p); });
}

Patch with_interior(const Patch& patch, const ConstrainedRemesher& mesh) {
  Points points = mesh.points();
  Triangles own = mesh.triangles();
  const int locked = mesh.locked();
  const std::vector<int> boundary_vertex = LockedVertices(patch, boundary_size(patch)).boundary_vertex();
  split_double_edges(locked, points, own);
  Patch result = patch;
  result.free_count = static_cast<int>(points.size()) - locked;
  const int shift = result.free_count - patch.free_count;
  result.positions.assign(points.begin() + locked, points.end());
  result.positions.insert(result.positions.end(), patch.positions.begin() + patch.free_count, patch.positions.end());
  result.ring.assign(result.free_count, 0);
  result.ring.insert(result.ring.end(), patch.ring.begin() + patch.free_count, patch.ring.end());
  result.view_vertex.assign(result.free_count, -1);
  result.view_vertex.insert(result.view_vertex.end(), patch.view_vertex.begin() + patch.free_count,
                            patch.view_vertex.end());
  result.triangles.clear();
  for (Triangle t : own) {
    for (int& v : t) v = v < locked ? boundary_vertex[v] + result.free_count : v - locked;
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
