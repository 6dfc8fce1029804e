#include "filling/triangulate_loop.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>

#include <limits>

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

void call_cgal(Mesh& mesh, Mesh::Halfedge_index border, TriangulationMethod method,
               std::vector<Mesh::Face_index>& faces) {
  namespace pmp = CGAL::Polygon_mesh_processing;
  const auto base = CGAL::parameters::use_2d_constrained_delaunay_triangulation(false);
  auto out = std::back_inserter(faces);
  switch (method) {
    case TriangulationMethod::cubic:
      pmp::triangulate_hole(mesh, border, out, base.use_delaunay_triangulation(false));
      break;
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
