// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/mesh_arrays.h"

namespace loopmend {

Points points_of(const TriMesh& mesh) {
  Points points;
  points.reserve(mesh.n_vertices());
  for (const auto v : mesh.vertices()) points.push_back(mesh.point(v));
  return points;
}

Triangles triangles_of(const TriMesh& mesh) {
  Triangles triangles;
  triangles.reserve(mesh.n_faces());
  for (const auto f : mesh.faces()) {
    const auto h = mesh.halfedge_handle(f);
    triangles.push_back({mesh.from_vertex_handle(h).idx(), mesh.to_vertex_handle(h).idx(),
                         mesh.to_vertex_handle(mesh.next_halfedge_handle(h)).idx()});
  }
  return triangles;
}

}  // namespace loopmend
