// SPDX-License-Identifier: GPL-3.0-or-later
#include "remeshing/double_edges.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>

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

}  // namespace

void split_double_edges(const std::vector<int>& vertex, Points& points, Triangles& triangles) {
  const int places = static_cast<int>(vertex.size());
  std::set<int> repeated;
  for (int i = 0; i < places; ++i)
    if (vertex[i] != i) repeated.insert({i, vertex[i]});
  if (repeated.empty()) return;
  const auto vertex_of = [&](int v) { return v < places ? vertex[v] : v; };
  std::map<Edge, std::set<Edge>> edges;
  for (const Triangle& t : triangles)
    for (int k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      if (repeated.contains(a) || repeated.contains(b))
        edges[std::minmax(vertex_of(a), vertex_of(b))].insert(std::minmax(a, b));
    }
  for (const auto& [ends, same] : edges)
    for (auto edge = std::next(same.begin()); edge != same.end(); ++edge) split(*edge, points, triangles);
}

}  // namespace loopmend
