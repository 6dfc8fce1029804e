// SPDX-License-Identifier: GPL-3.0-or-later
#include "remeshing/double_edges.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace loopmend {

namespace {

using Edge = std::pair<int, int>;

/// Both triangles at the edge, each parted at its middle.
void split(const Edge& edge, Points& points, Triangles& triangles) {
  const int middle = static_cast<int>(points.size());
  points.push_back((points[edge.first] + points[edge.second]) / 2);
  const std::size_t count = triangles.size();
  for (std::size_t f = 0; f < count; ++f)
    for (int k = 0; k < 3; ++k) {
      const int a = triangles[f][k], b = triangles[f][(k + 1) % 3], apex = triangles[f][(k + 2) % 3];
      if (Edge(std::minmax(a, b)) != edge) continue;
      triangles[f] = {a, middle, apex};
      triangles.push_back({middle, b, apex});
      break;
    }
}

/// For each of the first points the lowest one in the same place.
std::vector<int> first_in_place(int places, const Points& points) {
  std::map<std::array<double, 3>, int> first;
  std::vector<int> vertex;
  for (int i = 0; i < places; ++i)
    vertex.push_back(first.try_emplace({points[i].x(), points[i].y(), points[i].z()}, i).first->second);
  return vertex;
}

constexpr double off_the_edge = 0.25;

}  // namespace

void split_beside(const std::set<Edge>& edges, Points& points, Triangles& triangles) {
  if (edges.empty()) return;
  std::map<Edge, Points> apexes;
  for (const Triangle& t : triangles)
    for (int k = 0; k < 3; ++k)
      if (const Edge edge = std::minmax(t[k], t[(k + 1) % 3]); edges.contains(edge))
        apexes[edge].push_back(points[t[(k + 2) % 3]]);
  std::map<Edge, int> middle;
  for (const auto& [edge, at] : apexes) {
    middle.emplace(edge, static_cast<int>(points.size()));
    Vec3 beyond = Vec3::Zero();
    for (const Vec3& p : at) beyond += p / static_cast<double>(at.size());
    points.push_back((1 - off_the_edge) / 2 * (points[edge.first] + points[edge.second]) + off_the_edge * beyond);
  }
  for (std::size_t f = 0; f < triangles.size();) {
    const Triangle t = triangles[f];
    int k = 0;
    while (k < 3 && !edges.contains(std::minmax(t[k], t[(k + 1) % 3]))) ++k;
    if (k == 3) {
      ++f;
      continue;
    }
    const int a = t[k], b = t[(k + 1) % 3], apex = t[(k + 2) % 3], between = middle.at(std::minmax(a, b));
    triangles[f] = {a, between, apex};
    triangles.push_back({between, b, apex});
  }
}

void split_double_edges(int places, Points& points, Triangles& triangles) {
  const std::vector<int> vertex = first_in_place(places, points);
  std::set<int> repeated;
  for (int i = 0; i < places; ++i)
    if (vertex[i] != i) repeated.insert({i, vertex[i]});
  if (repeated.empty()) return;
  const auto vertex_of = [&](int v) { return v < places ? vertex[v] : v; };
  std::map<Edge, std::map<Edge, int>> edges;  // by places: those that lie there, each with its number of triangles
  for (const Triangle& t : triangles)
    for (int k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      if (repeated.contains(a) || repeated.contains(b))
        ++edges[std::minmax(vertex_of(a), vertex_of(b))][std::minmax(a, b)];
    }
  for (const auto& [ends, same] : edges) {
    const auto is_inner = [](const auto& edge) { return edge.second > 1; };  // the others are the boundary, and stay
    const bool all_inner = std::all_of(same.begin(), same.end(), is_inner);
    for (auto edge = all_inner ? std::next(same.begin()) : same.begin(); edge != same.end(); ++edge)
      if (is_inner(*edge)) split(edge->first, points, triangles);
  }
}

}  // namespace loopmend
