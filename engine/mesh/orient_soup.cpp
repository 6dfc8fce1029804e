#include "mesh/orient_soup.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>

#include <algorithm>
#include <numeric>

namespace loopmend {

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

  CGAL::Polygon_mesh_processing::orient_polygon_soup(cgal_points, polygons);

  OrientedSoup result;
  result.origin.resize(cgal_points.size());
  std::iota(result.origin.begin(), result.origin.end(), 0);
  result.triangles.resize(triangles.size());
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    const Triangle& given = triangles[f];
    Triangle turned;
    std::copy(polygons[f].begin(), polygons[f].end(), turned.begin());
    result.triangles[f] = turned;
    // A split vertex has a new number: the corner that stands at its place, in the same or in the reversed order.
    const auto fits = [&](const Triangle& old_order) {
      for (int k = 0; k < 3; ++k) {
        if (static_cast<std::size_t>(turned[k]) < points.size() ? turned[k] != old_order[k]
                                                                : cgal_points[turned[k]] != cgal_points[old_order[k]])
          return false;
      }
      return true;
    };
    for (int rotation = 0; rotation < 3; ++rotation) {
      const Triangle forward{given[rotation], given[(rotation + 1) % 3], given[(rotation + 2) % 3]};
      const Triangle backward{forward[2], forward[1], forward[0]};
      const Triangle* match = fits(forward) ? &forward : fits(backward) ? &backward : nullptr;
      if (!match) continue;
      for (int k = 0; k < 3; ++k) result.origin[turned[k]] = (*match)[k];
      break;
    }
  }
  return result;
}

}  // namespace loopmend
