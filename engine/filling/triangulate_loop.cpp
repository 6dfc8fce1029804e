// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/triangulate_loop.h"

#include "filling/minimum_weight_triangulation.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace loopmend {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;

Vertex vertex(int v) { return Vertex(static_cast<Mesh::size_type>(v)); }

/// The neighbourhood as a CGAL mesh; vertex numbers are kept.
Mesh neighborhood(const Points& points, const Triangles& surroundings) {
  Mesh mesh;
  mesh.reserve(static_cast<unsigned>(points.size()), static_cast<unsigned>(3 * points.size()),
               static_cast<unsigned>(surroundings.size()));
  for (const Vec3& p : points) mesh.add_vertex({p.x(), p.y(), p.z()});
  for (const Triangle& t : surroundings) mesh.add_face(vertex(t[0]), vertex(t[1]), vertex(t[2]));
  return mesh;
}

/// What the hole at `border` looks like from inside. @param vertices  of the result's points. Empty where the border meets
/// itself.
OpenLoop seen_from_inside(const Mesh& mesh, Mesh::Halfedge_index border, std::vector<int>& vertices) {
  const auto place = [&](Vertex v) {
    const auto& p = mesh.point(v);
    return Vec3(p.x(), p.y(), p.z());
  };
  OpenLoop loop;
  std::map<int, int> number;
  for (const Mesh::Halfedge_index h : mesh.halfedges_around_face(border)) {
    const Vertex v = mesh.target(h);
    if (!number.emplace(v.idx(), static_cast<int>(vertices.size())).second) return {};
    vertices.push_back(static_cast<int>(v.idx()));
    loop.points.push_back(place(v));
    loop.across.push_back(place(mesh.target(mesh.next(mesh.opposite(mesh.next(h))))));
  }
  const int n = static_cast<int>(vertices.size());
  for (int i = 0; i < n; ++i)
    for (const Vertex w : mesh.vertices_around_target(mesh.halfedge(vertex(vertices[i])))) {
      const auto other = number.find(static_cast<int>(w.idx()));
      if (other == number.end()) continue;
      const int k = other->second;
      if (k > i + 1 && !(i == 0 && k == n - 1)) loop.present.insert({i, k});
    }
  return loop;
}

/// Corners in ascending order: the faces of the Delaunay triangulation of a loop, and, as in CGAL's hole filling, all
/// triangles at those edges of the loop that it lacks. CGAL's own search among them starts where cells happen to lie in
/// memory, and of equally good triangulations keeps the first: on symmetric loops it is not the same from run to run.
Triangles delaunay_triangles(const Points& points) {
  using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<int, Kernel>;
  using Structure = CGAL::Triangulation_data_structure_3<VertexBase, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
  std::vector<std::pair<Kernel::Point_3, int>> numbered;
  for (const Vec3& p : points) numbered.push_back({{p.x(), p.y(), p.z()}, static_cast<int>(numbered.size())});
  const CGAL::Delaunay_triangulation_3<Kernel, Structure> delaunay(numbered.begin(), numbered.end());
  Triangles triangles;
  if (delaunay.dimension() < 2) return triangles;
  const int n = static_cast<int>(points.size());
  std::vector<char> has_edge(n, 0);  // to the next point of the loop
  for (const auto& [cell, opposite] : delaunay.finite_facets()) {
    Triangle t;
    for (int k = 0, v = 0; v < 4; ++v)
      if (v != opposite) t[k++] = cell->vertex(v)->info();
    std::sort(t.begin(), t.end());
    triangles.push_back(t);
    if (t[1] == t[0] + 1) has_edge[t[0]] = 1;
    if (t[2] == t[1] + 1) has_edge[t[1]] = 1;
    if (t[0] == 0 && t[2] == n - 1) has_edge[n - 1] = 1;
  }
  for (int i = 0; i < n; ++i) {
    if (has_edge[i]) continue;
    for (int m = 0; m < n; ++m) {
      Triangle t{i, (i + 1) % n, m};
      std::sort(t.begin(), t.end());
      if (t[0] != t[1] && t[1] != t[2]) triangles.push_back(t);
    }
  }
  return triangles;
}

/// Over Delaunay triangles if they will do; else, or where it is asked for, over all.
Triangles least_folded(const Mesh& mesh, Mesh::Halfedge_index border, TriangulationMethod method) {
  std::vector<int> vertices;
  const OpenLoop loop = seen_from_inside(mesh, border, vertices);
  Triangles triangles;
  if (loop.points.empty()) return triangles;
  if (method != TriangulationMethod::cubic)
    triangles = minimum_weight_triangulation(loop, delaunay_triangles(loop.points));
  if (triangles.empty() && (method == TriangulationMethod::cubic || method == TriangulationMethod::delaunay))
    triangles = minimum_weight_triangulation(loop);
  for (Triangle& t : triangles)
    for (int& v : t) v = vertices[v];
  return triangles;
}

/// Constrained Delaunay in the plane that fits best; empty where the loop's image crosses itself.
Triangles planar_triangulation(Mesh& mesh, Mesh::Halfedge_index border) {
  std::vector<Mesh::Face_index> faces;
  CGAL::Polygon_mesh_processing::triangulate_hole(mesh, border, std::back_inserter(faces),
                                                  CGAL::parameters::use_2d_constrained_delaunay_triangulation(true)
                                                      .threshold_distance(std::numeric_limits<double>::max())
                                                      .use_delaunay_triangulation(false)
                                                      .do_not_use_cubic_algorithm(true));
  Triangles triangles;
  for (Mesh::Face_index f : faces) {
    Triangle t;
    int k = 0;
    for (Vertex v : mesh.vertices_around_face(mesh.halfedge(f))) t[k++] = static_cast<int>(v.idx());
    triangles.push_back(t);
  }
  return triangles;
}

}  // namespace

Triangles triangulate_loop(const Points& points, const Triangles& surroundings, const std::vector<int>& loop,
                           TriangulationMethod method) {
  Mesh mesh = neighborhood(points, surroundings);
  const Mesh::Halfedge_index border = mesh.halfedge(vertex(loop[0]), vertex(loop[1]));
  if (border == Mesh::null_halfedge() || !mesh.is_border(border)) return {};
  Triangles triangles;
  if (method == TriangulationMethod::planar) triangles = planar_triangulation(mesh, border);
  if (triangles.empty()) triangles = least_folded(mesh, border, method);
  if (triangles.size() + 2 != loop.size()) triangles.clear();
  return triangles;
}

}  // namespace loopmend
