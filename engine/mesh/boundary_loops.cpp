// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary_loops.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <unordered_map>

namespace loopmend {

namespace {

/// A rim whose geodesic curvature is above this share of 2π bounds a sheet. A ball of which less than a fifth is left
/// (opening angle over 127°) is a sheet too; the end of a tube (0) and a hole (−1) are not.
constexpr double outer_rim_turning = 0.6;

Points loop_points(const SurfaceModel& model, const BoundaryLoop& loop) {
  Points points;
  for (int v : loop.vertices) points.push_back(model.mesh.point(TriMesh::VertexHandle(v)));
  return points;
}

double total_turning(const TriMesh& mesh, const std::vector<int>& vertices) {
  double turning = 0;
  for (int v : vertices) {
    double interior = 0;
    const Vec3 p = mesh.point(TriMesh::VertexHandle(v));
    for (const auto face : mesh.vf_range(TriMesh::VertexHandle(v))) {
      Vec3 edges[2];
      int k = 0;
      for (const auto corner : mesh.fv_range(face))
        if (corner.idx() != v) edges[k++] = mesh.point(corner) - p;
      interior += std::atan2(edges[0].cross(edges[1]).norm(), edges[0].dot(edges[1]));
    }
    turning += std::numbers::pi - interior;
  }
  return turning / (2 * std::numbers::pi);
}

void measure(const SurfaceModel& model, BoundaryLoop& loop) {
  const Points points = loop_points(model, loop);
  const std::size_t n = points.size();
  double diameter2 = 0;
  for (std::size_t i = 0; i < n; ++i) {
    loop.center += points[i] / static_cast<double>(n);
    loop.perimeter += (points[(i + 1) % n] - points[i]).norm();
    for (std::size_t j = 0; j < i; ++j) diameter2 = std::max(diameter2, (points[i] - points[j]).squaredNorm());
  }
  loop.diameter = std::sqrt(diameter2);
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  Vec3 area_vector = Vec3::Zero();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 d = points[i] - loop.center;
    covariance += d * d.transpose() / static_cast<double>(n);
    area_vector += d.cross(points[(i + 1) % n] - loop.center) / 2;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(covariance);
  loop.planarity = loop.diameter > 0 ? std::sqrt(std::max(0.0, eigen.eigenvalues()[0])) / loop.diameter : 0;
  loop.area = std::abs(area_vector.dot(eigen.eigenvectors().col(0)));
  loop.turning = total_turning(model.mesh, loop.vertices);
}

std::vector<BoundaryLoop> walk_loops(const TriMesh& mesh) {
  std::vector<BoundaryLoop> loops;
  std::vector<char> seen(mesh.n_halfedges(), 0);
  for (const auto start : mesh.halfedges()) {
    if (!mesh.is_boundary(start) || seen[start.idx()]) continue;
    BoundaryLoop loop;
    TriMesh::HalfedgeHandle h = start;
    do {
      seen[h.idx()] = 1;
      loop.vertices.push_back(mesh.from_vertex_handle(h).idx());
      h = mesh.next_halfedge_handle(h);
    } while (h != start);
    std::rotate(loop.vertices.begin(), std::min_element(loop.vertices.begin(), loop.vertices.end()),
                loop.vertices.end());
    loops.push_back(std::move(loop));
  }
  return loops;
}

/// Faces of the soup at each of its edges that lie on a boundary of the view.
class SoupEdges {
 public:
  explicit SoupEdges(const SurfaceModel& model) {
    if (model.mesh.n_vertices() == 0 ||
        (model.repairs.non_manifold_edges == 0 && model.repairs.non_manifold_vertices == 0))
      return;
    for (int f : model.soup_face)
      for (int k = 0; k < 3; ++k) ++faces_[key(model.soup.triangles[f][k], model.soup.triangles[f][(k + 1) % 3])];
  }
  bool has_several_faces(int a, int b) const {
    const auto found = faces_.find(key(a, b));
    return found != faces_.end() && found->second > 1;
  }

 private:
  static std::uint64_t key(int a, int b) {
    return (static_cast<std::uint64_t>(std::min(a, b)) << 32) | static_cast<std::uint32_t>(std::max(a, b));
  }
  std::unordered_map<std::uint64_t, int> faces_;
};

/// Fills BoundaryLoop::coincident.
void count_coincident(const SurfaceModel& model, std::vector<BoundaryLoop>& loops) {
  using Place = std::array<double, 3>;
  const auto place = [&](int v) {
    const Vec3 p = model.mesh.point(TriMesh::VertexHandle(v));
    return Place{p.x(), p.y(), p.z()};
  };
  std::vector<std::pair<std::pair<Place, Place>, BoundaryLoop*>> edges;
  for (BoundaryLoop& loop : loops)
    for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
      const Place a = place(loop.vertices[i]), b = place(loop.vertices[(i + 1) % loop.vertices.size()]);
      edges.push_back({std::minmax(a, b), &loop});
    }
  std::sort(edges.begin(), edges.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t j = i;
    while (j < edges.size() && edges[j].first == edges[i].first) ++j;
    for (std::size_t k = i; k < j && j - i > 1; ++k) ++edges[k].second->coincident;
    i = j;
  }
}

LoopKind kind_of(const SurfaceModel& model, const BoundaryLoop& loop, const std::map<int, int>& visits,
                 const SoupEdges& edges) {
  const std::size_t n = loop.vertices.size();
  bool touching = false;
  for (std::size_t i = 0; i < n; ++i) {
    const int a = model.soup_vertex[loop.vertices[i]], b = model.soup_vertex[loop.vertices[(i + 1) % n]];
    if (edges.has_several_faces(a, b)) return LoopKind::cut;
    touching = touching || visits.at(a) > 1;
  }
  if (touching) return LoopKind::touching;
  if (loop.coincident == loop.edges()) return LoopKind::crack;
  return bounds_a_sheet(loop) ? LoopKind::outer_rim : LoopKind::hole;
}

}  // namespace

const char* to_string(LoopKind kind) {
  switch (kind) {
    case LoopKind::hole: return "hole";
    case LoopKind::outer_rim: return "outer rim";
    case LoopKind::touching: return "touching";
    case LoopKind::crack: return "crack";
    case LoopKind::cut: return "cut";
  }
  return "";
}

bool bounds_a_sheet(const BoundaryLoop& loop) {
  const bool by_kind = loop.kind != LoopKind::crack && loop.kind != LoopKind::cut;
  return by_kind && loop.turning > outer_rim_turning;
}

std::vector<BoundaryLoop> find_boundary_loops(const SurfaceModel& model) {
  std::vector<BoundaryLoop> loops = walk_loops(model.mesh);
  std::map<int, int> visits;
  for (const BoundaryLoop& loop : loops)
    for (int v : loop.vertices) ++visits[model.soup_vertex[v]];
  const SoupEdges edges(model);
  count_coincident(model, loops);
  for (BoundaryLoop& loop : loops) {
    measure(model, loop);
    loop.kind = kind_of(model, loop, visits, edges);
  }
  std::sort(loops.begin(), loops.end(), [&](const BoundaryLoop& a, const BoundaryLoop& b) {
    if (a.perimeter != b.perimeter) return a.perimeter > b.perimeter;
    return a.vertices.front() < b.vertices.front();
  });
  for (std::size_t k = 0; k < loops.size(); ++k) loops[k].number = static_cast<int>(k) + 1;
  return loops;
}

}  // namespace loopmend
