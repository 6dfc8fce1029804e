// SPDX-License-Identifier: GPL-3.0-or-later
// Facts about a filled scan that owe nothing to what the fill says of itself: counted from the soups before and after, and
// by CGAL.
#pragma once

#include "mesh/boundary_loops.h"
#include "mesh/triangle_soup.h"

#define CGAL_NO_DEPRECATION_WARNINGS 1  // CGAL 6, of Debian 13, has AABB_traits_3 beside AABB_traits, CGAL 5 has not
#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace loopmend::test {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using DirectedEdge = std::pair<int, int>;

/// @throws std::runtime_error if the soup is no oriented manifold.
inline CgalMesh to_cgal(const TriangleSoup& soup) {
  CgalMesh mesh;
  for (const Vec3& p : soup.points) mesh.add_vertex({p.x(), p.y(), p.z()});
  const auto vertex = [](int v) { return CgalMesh::Vertex_index(static_cast<CgalMesh::size_type>(v)); };
  for (const Triangle& t : soup.triangles)
    if (mesh.add_face(vertex(t[0]), vertex(t[1]), vertex(t[2])) == CgalMesh::null_face())
      throw std::runtime_error("a face does not fit its neighbours");
  return mesh;
}

/// The triangles that a fill has added.
inline Triangles added_triangles(const TriangleSoup& before, const TriangleSoup& after) {
  return {after.triangles.begin() + static_cast<long>(before.triangles.size()), after.triangles.end()};
}

/// The boundary edges of a patch, in the direction of its triangles.
inline std::set<DirectedEdge> boundary_edges(const Triangles& triangles) {
  std::set<DirectedEdge> all, open;
  for (const Triangle& t : triangles)
    for (int k = 0; k < 3; ++k) all.emplace(t[k], t[(k + 1) % 3]);
  for (const auto& [a, b] : all)
    if (!all.contains({b, a})) open.emplace(a, b);
  return open;
}

/// The edges of boundary loops as points of the soup, in the direction in which a patch runs along them.
inline std::set<DirectedEdge> loop_edges(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops) {
  std::set<DirectedEdge> edges;
  for (const BoundaryLoop& loop : loops)
    for (std::size_t k = 0; k < loop.vertices.size(); ++k)
      edges.emplace(model.soup_vertex[loop.vertices[k]],
                    model.soup_vertex[loop.vertices[(k + 1) % loop.vertices.size()]]);
  return edges;
}

inline double area_of(const Points& points, const Triangles& triangles) {
  double area = 0;
  for (const auto& [a, b, c] : triangles) area += 0.5 * (points[b] - points[a]).cross(points[c] - points[a]).norm();
  return area;
}

/// The sharpest turn between two triangles that share an edge, in degrees: 0 is flat, 180 a triangle folded onto the other.
inline double sharpest_fold_deg(const Points& points, const Triangles& triangles) {
  const auto normal = [&](const Triangle& t) {
    return Vec3((points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]));
  };
  std::map<DirectedEdge, std::size_t> face;
  for (std::size_t f = 0; f < triangles.size(); ++f)
    for (int k = 0; k < 3; ++k) face[{triangles[f][k], triangles[f][(k + 1) % 3]}] = f;
  double sharpest = 0;
  for (const auto& [edge, f] : face) {
    const auto other = face.find({edge.second, edge.first});
    if (other == face.end()) continue;
    const Vec3 n = normal(triangles[f]), m = normal(triangles[other->second]);
    sharpest = std::max(sharpest, std::atan2(n.cross(m).norm(), n.dot(m)) * 180 / std::numbers::pi);
  }
  return sharpest;
}

/// How often a triangle that the fill has added meets one of the scan or of a patch where it should not; by CGAL.
inline std::size_t count_self_intersections(const TriangleSoup& before, const TriangleSoup& after) {
  const CgalMesh mesh = to_cgal(after);
  CGAL::Bbox_3 around;  // of the patches: nothing beyond can meet them
  for (const Triangle& t : added_triangles(before, after))
    for (int v : t) around += Kernel::Point_3(after.points[v].x(), after.points[v].y(), after.points[v].z()).bbox();
  std::vector<CgalMesh::Face_index> near;
  for (CgalMesh::Face_index f : mesh.faces()) {
    CGAL::Bbox_3 box;
    for (CgalMesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f))) box += mesh.point(v).bbox();
    if (CGAL::do_overlap(box, around)) near.push_back(f);
  }
  std::vector<std::pair<CgalMesh::Face_index, CgalMesh::Face_index>> pairs;
  CGAL::Polygon_mesh_processing::self_intersections(near, mesh, std::back_inserter(pairs));
  const std::size_t first_added = before.triangles.size();  // faces have the numbers of the soup's triangles
  return static_cast<std::size_t>(std::count_if(pairs.begin(), pairs.end(), [&](const auto& pair) {
    return static_cast<std::size_t>(pair.first) >= first_added || static_cast<std::size_t>(pair.second) >= first_added;
  }));
}

/// Distances to a surface that is known.
class Truth {
 public:
  explicit Truth(const TriangleSoup& soup)
      : mesh_(to_cgal(soup)),
        tree_(mesh_.faces_begin(), mesh_.faces_end(), mesh_) {
    tree_.accelerate_distance_queries();
  }
  double distance(const Vec3& p) const { return std::sqrt(tree_.squared_distance({p.x(), p.y(), p.z()})); }

 private:
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_face_graph_triangle_primitive<CgalMesh>>>;
  CgalMesh mesh_;
  Tree tree_;
};

}  // namespace loopmend::test
