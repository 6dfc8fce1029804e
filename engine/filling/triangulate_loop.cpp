// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/triangulate_loop.h"

#include "filling/minimum_weight_triangulation.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace loopmend {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// What the loop looks like from inside. It begins with the loop's second vertex. Empty where an edge is no boundary edge.
OpenLoop seen_from_inside(const Points& points, const Triangles& surroundings, const std::vector<int>& loop) {
  const int n = static_cast<int>(loop.size());
  const auto vertex = [&](int place) { return loop[(place + 1) % n]; };
  std::map<int, std::vector<int>> places;
  std::map<std::pair<int, int>, int> edge_place;
  for (int i = 0; i < n; ++i) {
    places[vertex(i)].push_back(i);
    edge_place[{vertex(i), vertex(i + 1)}] = i;
  }
  OpenLoop open;
  for (int i = 0; i < n; ++i) open.points.push_back(points[vertex(i)]);
  open.across = open.points;
  std::vector<char> has_face(n, 0);
  const auto forbid = [&](int a, int b) {
    const auto at_a = places.find(a), at_b = places.find(b);
    if (at_a == places.end() || at_b == places.end()) return;
    for (int i : at_a->second)
      for (int k : at_b->second)
        if (std::abs(k - i) > 1 && std::abs(k - i) != n - 1) open.present.insert(std::minmax(i, k));
  };
  for (const Triangle& t : surroundings)
    for (int k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      if (const auto edge = edge_place.find({b, a}); edge != edge_place.end()) {
        has_face[edge->second] = 1;
        open.across[edge->second] = points[t[(k + 2) % 3]];
      }
      forbid(a, b);
    }
  for (const auto& [v, at] : places) forbid(v, v);
  if (std::count(has_face.begin(), has_face.end(), 0) > 0) return {};
  return open;
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
Triangles least_folded(const OpenLoop& loop, TriangulationMethod method) {
  Triangles triangles;
  if (method != TriangulationMethod::cubic)
    triangles = minimum_weight_triangulation(loop, delaunay_triangles(loop.points));
  if (triangles.empty() && (method == TriangulationMethod::cubic || method == TriangulationMethod::delaunay))
    triangles = minimum_weight_triangulation(loop);
  return triangles;
}

/// Constrained Delaunay in the plane that fits best; empty where the loop's image crosses itself.
Triangles planar_triangulation(const OpenLoop& loop) {
  std::vector<Kernel::Point_3> points;
  for (const Vec3& p : loop.points) points.emplace_back(p.x(), p.y(), p.z());
  std::vector<CGAL::Triple<int, int, int>> found;
  CGAL::Polygon_mesh_processing::triangulate_hole_polyline(
      points, std::back_inserter(found),
      CGAL::parameters::use_2d_constrained_delaunay_triangulation(true)
          .threshold_distance(std::numeric_limits<double>::max())
          .use_delaunay_triangulation(false)
          .do_not_use_cubic_algorithm(true));
  Triangles triangles;
  for (const auto& t : found) triangles.push_back({t.first, t.second, t.third});
  const int n = static_cast<int>(points.size());
  const bool along = std::any_of(triangles.begin(), triangles.end(), [n](const Triangle& t) {
    return (t[0] + 1) % n == t[1] || (t[1] + 1) % n == t[2] || (t[2] + 1) % n == t[0];
  });
  if (!along)
    for (Triangle& t : triangles) std::swap(t[1], t[2]);
  return triangles;
}

bool has_chord(const Triangles& triangles, const std::set<std::pair<int, int>>& chords) {
  return std::any_of(triangles.begin(), triangles.end(), [&](const Triangle& t) {
    for (int k = 0; k < 3; ++k)
      if (chords.contains(std::minmax(t[k], t[(k + 1) % 3]))) return true;
    return false;
  });
}

}  // namespace

Triangles triangulate_loop(const Points& points, const Triangles& surroundings, const std::vector<int>& loop,
                           TriangulationMethod method) {
  const OpenLoop open = seen_from_inside(points, surroundings, loop);
  Triangles triangles;
  if (open.points.empty()) return triangles;
  if (method == TriangulationMethod::planar) triangles = planar_triangulation(open);
  if (has_chord(triangles, open.present)) triangles.clear();
  if (triangles.empty()) triangles = least_folded(open, method);
  if (triangles.size() + 2 != loop.size()) triangles.clear();
  const int n = static_cast<int>(loop.size());
  for (Triangle& t : triangles)
    for (int& v : t) v = (v + 1) % n;
  return triangles;
}

}  // namespace loopmend
