// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/loop_facing.h"

#include <Eigen/Geometry>

namespace loopmend {

namespace {

/// Unit vector in the plane of the face beside a boundary halfedge, across the edge, away from the face.
Vec3 conormal(const TriMesh& mesh, TriMesh::VertexHandle a, TriMesh::VertexHandle b) {
  const auto h = mesh.find_halfedge(b, a);
  if (!h.is_valid() || mesh.is_boundary(h)) return Vec3::Zero();
  const Vec3 from = mesh.point(a), to = mesh.point(b);
  const Vec3 apex = mesh.point(mesh.to_vertex_handle(mesh.next_halfedge_handle(h)));
  const Vec3 along = (to - from).normalized();
  const Vec3 out = from - apex;
  return (out - along.dot(out) * along).normalized();
}

}  // namespace

LoopFacing loop_facing(const SurfaceModel& model, const BoundaryLoop& loop) {
  const std::size_t n = loop.vertices.size();
  LoopFacing facing{loop.center, 0, Vec3::Zero(), {}, Points(n, Vec3::Zero()), Vec3::Zero()};
  double perimeter = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const TriMesh::VertexHandle a(loop.vertices[i]), b(loop.vertices[(i + 1) % n]);
    const Vec3 p = model.mesh.point(a), q = model.mesh.point(b);
    const double length = (q - p).norm();
    facing.edge_conormals.push_back(conormal(model.mesh, a, b));
    const Vec3 across = length * facing.edge_conormals.back();
    facing.radius += (p - loop.center).norm() / static_cast<double>(n);
    facing.axis += (p - loop.center).cross(q - loop.center);
    facing.onward += across;
    facing.conormals[i] += across;
    facing.conormals[(i + 1) % n] += across;
    perimeter += length;
  }
  for (Vec3& c : facing.conormals) c = c.norm() > 0 ? Vec3(c.normalized()) : Vec3::Zero();
  if (perimeter > 0) facing.onward /= perimeter;
  const double norm = facing.axis.norm();
  facing.axis = norm > 0 ? Vec3(facing.axis / norm) : Vec3::Zero();
  return facing;
}

}  // namespace loopmend
