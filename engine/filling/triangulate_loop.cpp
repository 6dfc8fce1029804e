// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/triangulate_loop.h"

#include "core/rotation.h"
#include "filling/delaunay.h"
#include "filling/minimum_weight_triangulation.h"
#include "mesh/self_intersections.h"
#include "mesh/triangulate_polygon.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace loopmend {

namespace {

/// What the loop looks like from inside. It begins with the loop's second vertex. Empty where an edge is no boundary edge.
OpenLoop seen_from_inside(const Points& points, const Triangles& neighborhood, const std::vector<int>& loop,
                          const Chords& avoided) {
  const int n = static_cast<int>(loop.size());
  const auto vertex = [&](int place) { return loop[(place + 1) % n]; };
  std::map<std::pair<int, int>, int> edge_place;
  for (int i = 0; i < n; ++i) edge_place[{vertex(i), vertex(i + 1)}] = i;
  OpenLoop open;
  for (int i = 0; i < n; ++i) open.points.push_back(points[vertex(i)]);
  open.across = open.points;
  std::vector<char> has_face(n, 0);
  for (const Triangle& t : neighborhood)
    for (int k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      if (const auto edge = edge_place.find({b, a}); edge != edge_place.end()) {
        has_face[edge->second] = 1;
        open.across[edge->second] = points[t[(k + 2) % 3]];
      }
    }
  for (const auto& [i, k] : avoided) open.present.insert(std::minmax((i + n - 1) % n, (k + n - 1) % n));
  if (std::count(has_face.begin(), has_face.end(), 0) > 0) return {};
  return open;
}

/// Corners in ascending order: the faces of the Delaunay triangulation of a loop, and, as in CGAL's hole filling, all
/// triangles at those edges of the loop that it lacks. CGAL's own search among them starts where cells happen to lie in
/// memory, and of equally good triangulations keeps the first: on symmetric loops it is not the same from run to run.
Triangles delaunay_triangles(const Points& points) {
  Triangles triangles = delaunay_faces(points);
  if (triangles.empty()) return triangles;
  const int n = static_cast<int>(points.size());
  std::vector<char> has_edge(n, 0);  // to the next point of the loop
  for (const Triangle& t : triangles) {
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
  const std::size_t n = loop.points.size();
  Vec3 area = Vec3::Zero();
  for (std::size_t i = 0; i < n; ++i)
    area += (loop.points[i] - loop.points[0]).cross(loop.points[(i + 1) % n] - loop.points[0]);
  const Eigen::Quaterniond flat = rotation_between(area, Vec3::UnitZ());
  Points points;
  for (const Vec3& p : loop.points) points.push_back(flat * p);
  std::vector<int> polygon(n);
  std::iota(polygon.begin(), polygon.end(), 0);
  return triangulate_seen_flat(points, polygon);
}

constexpr int longest_for_all_triangles = 60;  ///< 34 220 triangles
constexpr int longest_uncut = 200;
constexpr int most_searched = 200;  ///< triangulations: each costs O(n³)

/// Corners in ascending order.
Triangles all_triangles(int n) {
  Triangles triangles;
  for (int i = 0; i < n; ++i)
    for (int m = i + 1; m < n; ++m)
      for (int k = m + 1; k < n; ++k) triangles.push_back({i, m, k});
  return triangles;
}

/// Those among `candidates`, over the open loop's points, that cut none of the neighborhood.
Triangles uncut_among(const Triangles& candidates, const OpenLoop& open, const Points& points,
                      const Triangles& neighborhood, const CancelToken& cancel) {
  Points all = open.points;
  all.insert(all.end(), points.begin(), points.end());
  Triangles triangles = candidates;
  const int shift = static_cast<int>(open.points.size());
  for (Triangle t : neighborhood) {
    for (int& v : t) v += shift;
    triangles.push_back(t);
  }
  const std::vector<char> cuts = triangles_that_cut(all, triangles, static_cast<int>(candidates.size()), cancel);
  Triangles uncut;
  for (std::size_t f = 0; f < cuts.size(); ++f)
    if (!cuts[f]) uncut.push_back(candidates[f]);
  return uncut;
}

/// Two triangles at one chord between places of a loop that passes a vertex twice, and that join it to different places:
/// four triangles would meet there. (−1, −1) if there are none.
std::pair<int, int> at_a_double_chord(const Triangles& triangles, const std::vector<int>& vertex) {
  std::map<std::pair<int, int>, std::pair<std::pair<int, int>, int>> first;  // by vertices: the places, a triangle
  for (std::size_t f = 0; f < triangles.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      const int a = triangles[f][k], b = triangles[f][(k + 1) % 3];
      const std::pair<int, int> places = std::minmax(a, b);
      const auto [entry, added] =
          first.emplace(std::minmax(vertex[a], vertex[b]), std::pair(places, static_cast<int>(f)));
      if (!added && entry->second.first != places) return {entry->second.second, static_cast<int>(f)};
    }
  return {-1, -1};
}

/// The least folded triangulation of the allowed triangles that does not cut itself: of two that cut each other, one or the
/// other is left out, those with the fewest left out first. Empty where none was found.
/// @param vertex  of each place
Triangles least_folded_uncut(const OpenLoop& open, const std::vector<int>& vertex, const Triangles& allowed,
                             const CancelToken& cancel) {
  std::vector<std::set<Triangle>> left_out{{}};
  for (std::size_t next = 0; next < left_out.size() && next < most_searched && !cancel.cancelled(); ++next) {
    Triangles rest = allowed;
    std::erase_if(rest, [&](const Triangle& t) { return left_out[next].contains(t); });
    const Triangles triangles = minimum_weight_triangulation(open, rest);
    if (triangles.size() + 2 != open.points.size()) continue;
    std::pair<int, int> clash = at_a_double_chord(triangles, vertex);
    if (clash.first < 0) {
      const auto pairs = self_intersections(open.points, triangles, static_cast<int>(triangles.size()), cancel);
      if (pairs.empty()) return triangles;
      clash = pairs.front();
    }
    for (const int f : {clash.first, clash.second}) {
      Triangle t = triangles[f];
      std::sort(t.begin(), t.end());
      left_out.push_back(left_out[next]);
      left_out.back().insert(t);
    }
  }
  return {};
}

/// From places as seen from inside to those of the loop.
Triangles over_the_loop(Triangles triangles, int n) {
  for (Triangle& t : triangles)
    for (int& v : t) v = (v + 1) % n;
  return triangles;
}

bool has_chord(const Triangles& triangles, const Chords& chords) {
  return std::any_of(triangles.begin(), triangles.end(), [&](const Triangle& t) {
    for (int k = 0; k < 3; ++k)
      if (chords.contains(std::minmax(t[k], t[(k + 1) % 3]))) return true;
    return false;
  });
}

}  // namespace

Chords present_chords(const Triangles& neighborhood, const std::vector<int>& loop) {
  const int n = static_cast<int>(loop.size());
  std::map<int, std::vector<int>> places;
  for (int i = 0; i < n; ++i) places[loop[i]].push_back(i);
  Chords chords;
  const auto add = [&](int a, int b) {
    const auto at_a = places.find(a), at_b = places.find(b);
    if (at_a == places.end() || at_b == places.end()) return;
    for (int i : at_a->second)
      for (int k : at_b->second)
        if (std::abs(k - i) > 1 && std::abs(k - i) != n - 1) chords.insert(std::minmax(i, k));
  };
  for (const Triangle& t : neighborhood)
    for (int k = 0; k < 3; ++k) add(t[k], t[(k + 1) % 3]);
  for (const auto& [v, at] : places) add(v, v);
  return chords;
}

Chords straight_chords(const Points& points, const std::vector<int>& loop) {
  constexpr double straight = 1e-5;  // radians
  const int n = static_cast<int>(loop.size());
  const auto at = [&](int k) { return points[loop[k % n]]; };
  const auto is_straight = [&](int k) {
    const Vec3 to = at(k) - at(k - 1), from = at(k + 1) - at(k);
    return to.dot(from) > 0 && to.cross(from).norm() < straight * to.dot(from);
  };
  Chords chords;
  for (int i = 0; i < n; ++i)
    for (int k = i + 2; k < i + n - 1 && is_straight(k - 1); ++k) chords.insert(std::minmax(i, k % n));
  return chords;
}

Triangles triangulate_loop(const Points& points, const Triangles& neighborhood, const std::vector<int>& loop,
                           const Chords& avoided, TriangulationMethod method) {
  const OpenLoop open = seen_from_inside(points, neighborhood, loop, avoided);
  Triangles triangles;
  if (open.points.empty()) return triangles;
  if (method == TriangulationMethod::planar) triangles = planar_triangulation(open);
  if (has_chord(triangles, open.present)) triangles.clear();
  if (triangles.empty()) triangles = least_folded(open, method);
  if (triangles.size() + 2 != loop.size()) triangles.clear();
  return over_the_loop(std::move(triangles), static_cast<int>(loop.size()));
}

Triangles triangulate_loop_uncut(const Points& points, const Triangles& neighborhood, const std::vector<int>& loop,
                                 const Chords& avoided, const CancelToken& cancel) {
  const int n = static_cast<int>(loop.size());
  if (n > longest_uncut) return {};
  const OpenLoop open = seen_from_inside(points, neighborhood, loop, avoided);
  if (open.points.empty()) return {};
  const Triangles candidates = n <= longest_for_all_triangles ? all_triangles(n) : delaunay_triangles(open.points);
  const Triangles allowed = uncut_among(candidates, open, points, neighborhood, cancel);
  std::vector<int> vertex;
  for (int i = 0; i < n; ++i) vertex.push_back(loop[(i + 1) % n]);
  const Triangles triangles = least_folded_uncut(open, vertex, allowed, cancel);
  return cancel.cancelled() ? Triangles() : over_the_loop(triangles, n);
}

}  // namespace loopmend
