// SPDX-License-Identifier: GPL-3.0-or-later
#include "surfaces/roughen.h"

#include "core/error.h"
#include "core/random.h"
#include "mesh/tri_mesh.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace loopmend {
namespace {

constexpr double smallest_angle_deg = 15;

TriMesh to_tri_mesh(const TriangleSoup& soup) {
  TriMesh mesh;
  for (const Vec3& p : soup.points) mesh.add_vertex(p);
  for (const auto& [a, b, c] : soup.triangles) {
    const TriMesh::FaceHandle face =
        mesh.add_face(TriMesh::VertexHandle(a), TriMesh::VertexHandle(b), TriMesh::VertexHandle(c));
    if (!face.is_valid())
      throw InvalidArgument(verbatim("Only a manifold, consistently oriented mesh can be roughened."));
  }
  return mesh;
}

/// Area-weighted, not of unit length.
Points vertex_normals(const TriangleSoup& soup) {
  Points normals(soup.points.size(), Vec3::Zero());
  for (const auto& [a, b, c] : soup.triangles) {
    const Vec3 n = (soup.points[b] - soup.points[a]).cross(soup.points[c] - soup.points[a]);
    for (int v : {a, b, c}) normals[v] += n;
  }
  return normals;
}

/// Over the triangles' sides, so that an inner edge counts twice.
double mean_edge_length(const TriangleSoup& soup) {
  double sum = 0;
  for (const Triangle& t : soup.triangles) {
    for (int k = 0; k < 3; ++k) sum += (soup.points[t[k]] - soup.points[t[(k + 1) % 3]]).norm();
  }
  return sum / (3.0 * static_cast<double>(soup.triangles.size()));
}

double min_angle_deg(const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto angle = [](const Vec3& u, const Vec3& v) { return std::atan2(u.cross(v).norm(), u.dot(v)); };
  const double smallest = std::min({angle(b - a, c - a), angle(c - b, a - b), angle(a - c, b - c)});
  return smallest * 180 / std::numbers::pi;
}

/// Whether the flipped pair of triangles is still a decent piece of the same surface.
bool flip_is_harmless(const TriMesh& mesh, TriMesh::EdgeHandle edge) {
  const auto h = mesh.halfedge_handle(edge, 0);
  const auto o = mesh.opposite_halfedge_handle(h);
  const auto va = mesh.from_vertex_handle(h);
  const auto vb = mesh.to_vertex_handle(h);
  if (mesh.valence(va) < 5 || mesh.valence(vb) < 5) return false;
  const Vec3& a = mesh.point(va);
  const Vec3& b = mesh.point(vb);
  const Vec3& c = mesh.point(mesh.to_vertex_handle(mesh.next_halfedge_handle(h)));
  const Vec3& d = mesh.point(mesh.to_vertex_handle(mesh.next_halfedge_handle(o)));
  const Vec3 mean_normal = ((b - a).cross(c - a) + (d - a).cross(b - a)).normalized();
  // Flipped: (a, d, c) and (d, b, c). Within 60° of the old mean normal there is no fold.
  const Vec3 first = (d - a).cross(c - a).normalized();
  const Vec3 second = (b - d).cross(c - d).normalized();
  return first.dot(mean_normal) > 0.5 && second.dot(mean_normal) > 0.5 && min_angle_deg(a, d, c) > smallest_angle_deg &&
         min_angle_deg(d, b, c) > smallest_angle_deg;
}

void jitter_points(TriangleSoup& soup, double length, Random& random, const std::function<Vec3(const Vec3&)>& project) {
  const Points normals = vertex_normals(soup);
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    const double angle = random.uniform(0, 2 * std::numbers::pi);
    if (normals[v].norm() == 0) continue;
    const Vec3 n = normals[v].normalized();
    const Vec3 u = n.unitOrthogonal();
    soup.points[v] = project(soup.points[v] + length * (std::cos(angle) * u + std::sin(angle) * n.cross(u)));
  }
}

void flip_edges(TriangleSoup& soup, double share, Random& random) {
  TriMesh mesh = to_tri_mesh(soup);
  for (const auto edge : mesh.edges()) {
    const bool chosen = random.uniform() < share;
    if (!chosen || mesh.is_boundary(edge) || !mesh.is_flip_ok(edge) || !flip_is_harmless(mesh, edge)) continue;
    mesh.flip(edge);
  }
  for (const auto face : mesh.faces()) {
    int k = 0;
    for (const auto v : mesh.fv_range(face)) soup.triangles[face.idx()][k++] = v.idx();
  }
}

}  // namespace

TriangleSoup roughen(const TriangleSoup& soup, double jitter, double flip_share, unsigned seed,
                     const std::function<Vec3(const Vec3&)>& project) {
  if (!(jitter >= 0 && jitter <= 0.4)) throw InvalidArgument(verbatim("roughen: jitter must be 0 to 0.4."));
  if (!(flip_share >= 0 && flip_share <= 1)) throw InvalidArgument(verbatim("roughen: flip_share must be 0 to 1."));
  if (soup.triangles.empty()) return soup;
  TriangleSoup rough = soup;
  Random random(seed);
  jitter_points(rough, jitter * mean_edge_length(soup), random, project);
  flip_edges(rough, flip_share, random);
  return rough;
}

}  // namespace loopmend
