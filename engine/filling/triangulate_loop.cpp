#include "filling/triangulate_loop.h"

#include "filling/least_folded.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>

#include <limits>
#include <map>

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

Triangles cubic_triangulation(const Mesh& mesh, Mesh::Halfedge_index border) {
  std::vector<int> vertices;
  Triangles triangles = least_folded_triangulation(seen_from_inside(mesh, border, vertices));
  for (Triangle& t : triangles)
    for (int& v : t) v = vertices[v];
  return triangles;
}

void call_cgal(Mesh& mesh, Mesh::Halfedge_index border, TriangulationMethod method,
               std::vector<Mesh::Face_index>& faces) {
  namespace pmp = CGAL::Polygon_mesh_processing;
  const auto base = CGAL::parameters::use_2d_constrained_delaunay_triangulation(false);
  auto out = std::back_inserter(faces);
  switch (method) {
    case TriangulationMethod::cubic: break;
    case TriangulationMethod::delaunay:
      pmp::triangulate_hole(mesh, border, out, base.use_delaunay_triangulation(true));
      break;
    case TriangulationMethod::delaunay_only:
      pmp::triangulate_hole(mesh, border, out, base.use_delaunay_triangulation(true).do_not_use_cubic_algorithm(true));
      break;
    case TriangulationMethod::planar:
      pmp::triangulate_hole(mesh, border, out,
                            CGAL::parameters::use_2d_constrained_delaunay_triangulation(true)
                                .threshold_distance(std::numeric_limits<double>::max())
                                .use_delaunay_triangulation(true)
                                .do_not_use_cubic_algorithm(true));
      break;
  }
}

}  // namespace

Triangles triangulate_loop(const Points& points, const Triangles& surroundings, const std::vector<int>& loop,
                           TriangulationMethod method) {
  Mesh mesh = neighborhood(points, surroundings);
  const Mesh::Halfedge_index border = mesh.halfedge(vertex(loop[0]), vertex(loop[1]));
  if (border == Mesh::null_halfedge() || !mesh.is_border(border)) return {};
  if (method == TriangulationMethod::cubic) return cubic_triangulation(mesh, border);
  std::vector<Mesh::Face_index> faces;
  call_cgal(mesh, border, method, faces);
  if (faces.size() + 2 != loop.size()) return {};
  Triangles triangles;
  for (Mesh::Face_index f : faces) {
    Triangle t;
    int k = 0;
    for (Vertex v : mesh.vertices_around_face(mesh.halfedge(f))) t[k++] = static_cast<int>(v.idx());
    triangles.push_back(t);
  }
  return triangles;
}

}  // namespace loopmend
