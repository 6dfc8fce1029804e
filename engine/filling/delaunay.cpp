// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/delaunay.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace loopmend {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SpaceVertex = CGAL::Triangulation_vertex_base_with_info_3<int, Kernel>;
using SpaceStructure =
    CGAL::Triangulation_data_structure_3<SpaceVertex, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
using SpaceDelaunay = CGAL::Delaunay_triangulation_3<Kernel, SpaceStructure>;

SpaceDelaunay delaunay_of(const Points& points) {
  std::vector<std::pair<Kernel::Point_3, int>> numbered;
  for (const Vec3& p : points) numbered.push_back({{p.x(), p.y(), p.z()}, static_cast<int>(numbered.size())});
  return SpaceDelaunay(numbered.begin(), numbered.end());
}

/// In the order of the cell.
Triangle corners(const SpaceDelaunay::Facet& facet) {
  Triangle t;
  for (int k = 0, v = 0; v < 4; ++v)
    if (v != facet.second) t[k++] = facet.first->vertex(v)->info();
  return t;
}

}  // namespace

Triangles delaunay_faces(const Points& points) {
  const SpaceDelaunay delaunay = delaunay_of(points);
  Triangles triangles;
  if (delaunay.dimension() < 2) return triangles;
  for (const SpaceDelaunay::Facet& facet : delaunay.finite_facets()) {
    Triangle t = corners(facet);
    std::sort(t.begin(), t.end());
    triangles.push_back(t);
  }
  return triangles;
}

Triangles hull_facets(const Points& points) {
  const SpaceDelaunay delaunay = delaunay_of(points);
  Triangles triangles;
  if (delaunay.dimension() < 3) return triangles;
  std::vector<SpaceDelaunay::Cell_handle> outside;
  delaunay.incident_cells(delaunay.infinite_vertex(), std::back_inserter(outside));
  const auto place = [&](int v) { return Kernel::Point_3(points[v].x(), points[v].y(), points[v].z()); };
  for (const SpaceDelaunay::Cell_handle cell : outside) {
    const SpaceDelaunay::Facet facet(cell, cell->index(delaunay.infinite_vertex()));
    Triangle t = corners(facet);
    const int within = delaunay.mirror_vertex(facet.first, facet.second)->info();
    if (CGAL::orientation(place(t[0]), place(t[1]), place(t[2]), place(within)) == CGAL::POSITIVE)
      std::swap(t[1], t[2]);
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    triangles.push_back(t);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

}  // namespace loopmend
