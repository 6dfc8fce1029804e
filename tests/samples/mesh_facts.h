// SPDX-License-Identifier: GPL-3.0-or-later
// Facts about a mesh that a test can state, counted directly from the triangles and without the engine's help.
#pragma once

#include "mesh/triangle_soup.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

namespace loopmend::test {

struct MeshFacts {
  int vertices = 0;
  int edges = 0;
  int faces = 0;
  bool oriented = true;         ///< no directed edge twice, hence edge-manifold and consistently oriented
  bool vertex_manifold = true;  ///< the faces at a vertex are one fan
  bool all_used = true;         ///< no point without a face
  int components = 0;           ///< edge-connected pieces
  int hanging_faces = 0;        ///< with two or more boundary edges
  double area = 0;
  double min_angle_deg = 180;
  double mean_edge = 0;
  std::vector<std::vector<int>> loops;  ///< boundary, in the direction of the faces' own edges

  int euler_characteristic() const { return vertices - edges + faces; }
};

inline double angle_at(const Vec3& p, const Vec3& a, const Vec3& b) {
  return std::atan2((a - p).cross(b - p).norm(), (a - p).dot(b - p));
}

inline std::vector<std::vector<int>> boundary_loops(const std::map<int, int>& boundary_next) {
  std::vector<std::vector<int>> loops;
  std::set<int> seen;
  for (const auto& [start, unused] : boundary_next) {
    if (seen.contains(start)) continue;
    loops.emplace_back();
    for (int v = start; seen.insert(v).second; v = boundary_next.at(v)) loops.back().push_back(v);
  }
  return loops;
}

/// Whether the corners (after, before) at one vertex chain up into a single fan.
inline bool is_one_fan(const std::map<int, int>& corners) {
  std::set<int> ends;
  for (const auto& [from, to] : corners) ends.insert(to);
  int start = corners.begin()->first;
  for (const auto& [from, to] : corners) {
    if (!ends.contains(from)) start = from;
  }
  std::size_t length = 0;
  int at = start;
  do {
    const auto next = corners.find(at);
    if (next == corners.end()) break;
    at = next->second;
    ++length;
  } while (at != start);
  return length == corners.size();
}

inline int count_components(const TriangleSoup& soup) {
  std::vector<int> parent(soup.points.size());
  for (std::size_t v = 0; v < parent.size(); ++v) parent[v] = static_cast<int>(v);
  const auto root = [&](int v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const auto& [a, b, c] : soup.triangles) {
    parent[root(a)] = root(b);
    parent[root(c)] = root(b);
  }
  std::set<int> roots;
  for (const auto& t : soup.triangles) roots.insert(root(t[0]));
  return static_cast<int>(roots.size());
}

inline MeshFacts mesh_facts(const TriangleSoup& soup) {
  MeshFacts facts;
  facts.vertices = static_cast<int>(soup.points.size());
  facts.faces = static_cast<int>(soup.triangles.size());
  std::set<std::pair<int, int>> directed;
  std::vector<std::map<int, int>> corners(soup.points.size());
  for (const Triangle& t : soup.triangles) {
    const Vec3 &a = soup.points[t[0]], &b = soup.points[t[1]], &c = soup.points[t[2]];
    facts.area += 0.5 * (b - a).cross(c - a).norm();
    for (int k = 0; k < 3; ++k) {
      const int v = t[k], next = t[(k + 1) % 3], before = t[(k + 2) % 3];
      facts.oriented = directed.emplace(v, next).second && facts.oriented;
      corners[v][next] = before;
      facts.min_angle_deg =
          std::min(facts.min_angle_deg,
                   angle_at(soup.points[v], soup.points[next], soup.points[before]) * 180 / std::numbers::pi);
    }
  }
  std::map<int, int> boundary_next;
  for (const auto& [from, to] : directed) {
    const bool is_boundary = !directed.contains({to, from});
    if (is_boundary) boundary_next[from] = to;
    if (is_boundary || from < to) {
      ++facts.edges;
      facts.mean_edge += (soup.points[from] - soup.points[to]).norm();
    }
  }
  facts.mean_edge /= facts.edges;
  for (const Triangle& t : soup.triangles) {
    int boundary_sides = 0;
    for (int k = 0; k < 3; ++k) boundary_sides += directed.contains({t[(k + 1) % 3], t[k]}) ? 0 : 1;
    facts.hanging_faces += boundary_sides >= 2 ? 1 : 0;
  }
  for (const auto& fan : corners) {
    facts.all_used = facts.all_used && !fan.empty();
    facts.vertex_manifold = facts.vertex_manifold && (fan.empty() || is_one_fan(fan));
  }
  facts.loops = boundary_loops(boundary_next);
  facts.components = count_components(soup);
  return facts;
}

/// Area-weighted normals of unit length.
inline Points unit_normals(const TriangleSoup& soup) {
  Points normals(soup.points.size(), Vec3::Zero());
  for (const auto& [a, b, c] : soup.triangles) {
    const Vec3 n = (soup.points[b] - soup.points[a]).cross(soup.points[c] - soup.points[a]);
    for (int v : {a, b, c}) normals[v] += n;
  }
  for (Vec3& n : normals) n.normalize();
  return normals;
}

/// Volume enclosed by a closed mesh; positive when the normals point outwards.
inline double signed_volume(const TriangleSoup& soup) {
  double volume = 0;
  for (const auto& [a, b, c] : soup.triangles) {
    volume += soup.points[a].dot(soup.points[b].cross(soup.points[c])) / 6;
  }
  return volume;
}

}  // namespace loopmend::test
