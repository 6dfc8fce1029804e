// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/pieces.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace loopmend {

namespace {

constexpr double farthest = 0.5;  ///< of an island from its hole's plane, in the hole's diameters

/// A hole as seen square to its best plane.
class Outline {
 public:
  Outline(const TriMesh& mesh, const BoundaryLoop& loop) : center_(loop.center), reach_(farthest * loop.diameter) {
    Vec3 normal = Vec3::Zero();
    const std::size_t n = loop.vertices.size();
    const auto at = [&](std::size_t i) {
      return Vec3(mesh.point(TriMesh::VertexHandle(loop.vertices[i % n])) - center_);
    };
    for (std::size_t i = 0; i < n; ++i) normal += at(i).cross(at(i + 1));
    normal_ = normal.normalized();
    right_ = normal_.unitOrthogonal();
    up_ = normal_.cross(right_);
    for (std::size_t i = 0; i < n; ++i) points_.emplace_back(right_.dot(at(i)), up_.dot(at(i)));
  }

  bool holds(const Vec3& point) const {
    const Vec3 p = point - center_;
    if (std::abs(normal_.dot(p)) > reach_) return false;
    const Eigen::Vector2d q(right_.dot(p), up_.dot(p));
    bool inside = false;
    for (std::size_t i = 0, j = points_.size() - 1; i < points_.size(); j = i++) {
      const Eigen::Vector2d &a = points_[i], &b = points_[j];
      if ((a.y() > q.y()) != (b.y() > q.y()) && q.x() < (b.x() - a.x()) * (q.y() - a.y()) / (b.y() - a.y()) + a.x())
        inside = !inside;
    }
    return inside;
  }

 private:
  Vec3 center_, normal_, right_, up_;
  double reach_;
  std::vector<Eigen::Vector2d> points_;
};

}  // namespace

std::vector<int> lowest_connected_vertices(const TriMesh& mesh) {
  std::vector<int> lower(mesh.n_vertices());  // in the same piece, or the vertex itself
  std::iota(lower.begin(), lower.end(), 0);
  const auto lowest = [&](int v) {
    while (lower[v] != v) v = lower[v] = lower[lower[v]];
    return v;
  };
  for (const auto edge : mesh.edges()) {
    const auto h = mesh.halfedge_handle(edge, 0);
    const int a = lowest(mesh.from_vertex_handle(h).idx()), b = lowest(mesh.to_vertex_handle(h).idx());
    lower[std::max(a, b)] = std::min(a, b);
  }
  for (int& v : lower) v = lower[v];  // those before are lowest already
  return lower;
}

std::vector<int> pieces_of(const TriMesh& mesh) {
  const std::vector<int> lowest_vertex = lowest_connected_vertices(mesh);
  std::vector<int> lowest_face(mesh.n_vertices(), -1), piece(mesh.n_faces());
  for (const auto face : mesh.faces()) {
    int& name = lowest_face[lowest_vertex[mesh.to_vertex_handle(mesh.halfedge_handle(face)).idx()]];
    if (name < 0) name = face.idx();
    piece[face.idx()] = name;
  }
  return piece;
}

std::vector<int> parts_of_points(const SurfaceModel& model, int& count) {
  std::vector<int> lower(model.soup.points.size(), -1);  // in the same part, or the point itself
  const auto lowest = [&](int v) {
    while (lower[v] != v) v = lower[v] = lower[lower[v]];
    return v;
  };
  for_each_soup_triangle(model, [&](int f) {
    const Triangle& t = model.soup.triangles[f];
    for (int v : t)
      if (lower[v] < 0) lower[v] = v;
    for (int k : {1, 2}) {
      const int a = lowest(t[0]), b = lowest(t[k]);
      lower[std::max(a, b)] = std::min(a, b);
    }
  });
  count = 0;
  for (int v = 0; v < static_cast<int>(lower.size()); ++v)  // the lower ones have their numbers already
    if (lower[v] >= 0) lower[v] = lower[v] == v ? count++ : lower[lower[v]];
  return lower;
}

int piece_beside(const TriMesh& mesh, const std::vector<int>& piece, const BoundaryLoop& loop) {
  const auto h = mesh.find_halfedge(TriMesh::VertexHandle(loop.vertices[1]), TriMesh::VertexHandle(loop.vertices[0]));
  return piece[mesh.face_handle(h).idx()];
}

Pieces::Pieces(const SurfaceModel& model) : model_(model) {
  if (model.beyond) {
    of_point_ = model.beyond->piece_of_point;
    boxes_ = model.beyond->boxes;
    return;
  }
  const TriMesh& mesh = model.mesh;
  own_of_point_ = lowest_connected_vertices(mesh);
  for (std::size_t v = 0; v < own_of_point_.size(); ++v) {
    int& piece = own_of_point_[v];
    if (mesh.is_isolated(TriMesh::VertexHandle(static_cast<int>(v)))) {
      piece = -1;
      continue;
    }
    if (piece == static_cast<int>(v)) {
      piece = static_cast<int>(own_boxes_.size());
      own_boxes_.emplace_back();
    } else {
      piece = own_of_point_[piece];  // lower, numbered already
    }
    own_boxes_[piece].extend(point(v));
  }
  of_point_ = own_of_point_;
  boxes_ = own_boxes_;
}

int Pieces::beside(const BoundaryLoop& loop) const {
  const auto v = static_cast<std::size_t>(loop.vertices.front());
  return model_.beyond ? model_.beyond->piece_of_vertex[v] : of_point_[v];
}

const Vec3& Pieces::point(std::size_t v) const {
  if (!model_.beyond) return model_.mesh.point(TriMesh::VertexHandle(static_cast<int>(v)));
  const std::size_t own = model_.beyond->piece_of_point.size() - model_.beyond->copy_of.size();
  return model_.soup.points[v < own ? v : static_cast<std::size_t>(model_.beyond->copy_of[v - own])];
}

std::vector<HoleWithIslands> find_islands(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops) {
  const TriMesh& mesh = model.mesh;
  const Pieces pieces(model);
  std::map<int, std::vector<int>> found;
  std::map<int, Outline> outlines;  // of holes that were looked at
  for (int island = 0; island < static_cast<int>(loops.size()); ++island) {
    if (loops[island].kind != LoopKind::outer_rim) continue;
    int around = -1;
    for (int hole = 0; hole < static_cast<int>(loops.size()); ++hole) {
      const BoundaryLoop& loop = loops[hole];
      if (loop.kind != LoopKind::hole || loop.diameter <= loops[island].diameter) continue;
      if (around >= 0 && loop.diameter >= loops[around].diameter) continue;
      if ((loop.center - loops[island].center).norm() > loop.diameter) continue;
      if (pieces.beside(loop) == pieces.beside(loops[island])) continue;
      const Outline& outline = outlines.try_emplace(hole, mesh, loop).first->second;
      const std::vector<int>& boundary = loops[island].vertices;
      if (std::all_of(boundary.begin(), boundary.end(),
                      [&](int v) { return outline.holds(mesh.point(TriMesh::VertexHandle(v))); }))
        around = hole;
    }
    if (around >= 0) found[around].push_back(island);
  }
  std::vector<HoleWithIslands> result;
  for (auto& [hole, islands] : found) result.push_back({hole, std::move(islands)});
  return result;
}

}  // namespace loopmend
