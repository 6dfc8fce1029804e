// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/orient_soup.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>

#include <algorithm>
#include <numeric>

namespace loopmend {

namespace {

/// Notes where each vertex that CGAL adds comes from.
struct SplitVertices : CGAL::Polygon_mesh_processing::Default_orientation_visitor {
  explicit SplitVertices(std::vector<int>& vertices) : origin(&vertices) {}
  void duplicated_vertex(std::size_t old_vertex, std::size_t new_vertex) {
    if (origin->size() <= new_vertex) origin->resize(new_vertex + 1);
    (*origin)[new_vertex] = (*origin)[old_vertex];
  }
  std::vector<int>* origin;
};

}  // namespace

OrientedSoup orient_soup(const Points& points, const Triangles& triangles) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_3> cgal_points;
  cgal_points.reserve(points.size());
  for (const Vec3& p : points) cgal_points.emplace_back(p.x(), p.y(), p.z());
  std::vector<std::vector<std::size_t>> polygons;
  polygons.reserve(triangles.size());
  for (const Triangle& t : triangles)
    polygons.push_back(
        {static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[1]), static_cast<std::size_t>(t[2])});

  OrientedSoup result;
  result.origin.resize(points.size());
  std::iota(result.origin.begin(), result.origin.end(), 0);
  CGAL::Polygon_mesh_processing::orient_polygon_soup(cgal_points, polygons,
                                                     CGAL::parameters::visitor(SplitVertices(result.origin)));
  result.triangles.resize(triangles.size());
  for (std::size_t f = 0; f < triangles.size(); ++f)
    std::copy(polygons[f].begin(), polygons[f].end(), result.triangles[f].begin());
  return result;
}

}  // namespace loopmend
