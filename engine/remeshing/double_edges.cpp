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

}  // namespace

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
