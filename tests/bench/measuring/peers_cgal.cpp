// SPDX-License-Identifier: GPL-3.0-or-later
#include "peers.h"
#include "stopwatch.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/fair.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>

namespace loopmend::bench {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace pmp = CGAL::Polygon_mesh_processing;

Mesh::Vertex_index vertex(int v) { return Mesh::Vertex_index(static_cast<Mesh::size_type>(v)); }

Mesh to_mesh(const Points& points, const Triangles& triangles) {
  Mesh mesh;
  for (const Vec3& p : points) mesh.add_vertex({p.x(), p.y(), p.z()});
  for (const Triangle& t : triangles) mesh.add_face(vertex(t[0]), vertex(t[1]), vertex(t[2]));
  return mesh;
}

/// @returns whether the hole was closed and faired.
bool fill_one(Mesh& mesh, Mesh::Halfedge_index separator, unsigned continuity) {
  std::vector<Mesh::Face_index> faces;
  std::vector<Mesh::Vertex_index> vertices;
  const bool faired = std::get<0>(
      pmp::triangulate_refine_and_fair_hole(mesh, separator, std::back_inserter(faces), std::back_inserter(vertices),
                                            CGAL::parameters::fairing_continuity(continuity)));
  return faired && !faces.empty();
}

void take_new(const Mesh& mesh, std::size_t old_points, std::size_t old_faces, Filling& filling) {
  for (std::size_t v = old_points; v < mesh.number_of_vertices(); ++v) {
    const auto& p = mesh.point(vertex(static_cast<int>(v)));
    filling.points.emplace_back(p.x(), p.y(), p.z());
  }
  for (const auto face : mesh.faces()) {
    if (static_cast<std::size_t>(face) < old_faces) continue;
    Triangle t{};
    int k = 0;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(face))) t[k++] = static_cast<int>(v);
    filling.triangles.push_back(t);
  }
}

}  // namespace

Filling fill_by_cgal(const Points& points, const Triangles& triangles, const std::vector<std::vector<int>>& loops,
                     unsigned continuity) try {
  Mesh mesh = to_mesh(points, triangles);
  const std::size_t old_faces = mesh.number_of_faces();
  Filling filling;
  filling.complete = true;
  const Stopwatch watch;
  for (const auto& loop : loops) {
    const Mesh::Halfedge_index separator = mesh.halfedge(vertex(loop[0]), vertex(loop[1]));
    const bool found = separator != Mesh::null_halfedge() && mesh.is_border(separator);
    if (!found || !fill_one(mesh, separator, continuity)) filling.complete = false;
  }
  filling.seconds = watch.seconds();
  filling.status = filling.complete ? "filled" : "failed";
  take_new(mesh, points.size(), old_faces, filling);
  return filling;
} catch (const std::exception& error) {
  Filling filling;
  filling.status = "failed";
  filling.message = error.what();
  return filling;
}

double seconds_of_cgal_fairing(const Points& points, const Triangles& triangles, int free, unsigned continuity) {
  Mesh mesh = to_mesh(points, triangles);
  std::vector<Mesh::Vertex_index> inner;
  for (int v = 0; v < free; ++v) inner.push_back(vertex(v));
  const Stopwatch watch;
  const bool faired = pmp::fair(mesh, inner, CGAL::parameters::fairing_continuity(continuity));
  const double seconds = watch.seconds();
  return faired ? seconds : -1;
}

}  // namespace loopmend::bench
