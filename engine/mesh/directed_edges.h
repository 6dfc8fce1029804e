// SPDX-License-Identifier: GPL-3.0-or-later
// The edges of triangles as they run in them, to be looked up: a tree of them takes several times as long.
#pragma once

#include "core/types.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace loopmend {

class DirectedEdges {
 public:
  using Edge = std::pair<int, int>;

  /// Of the first `count` triangles.
  DirectedEdges(const Triangles& triangles, int count) {
    edges_.reserve(3 * count);
    for (int f = 0; f < count; ++f)
      for (int k = 0; k < 3; ++k) edges_.emplace_back(triangles[f][k], triangles[f][(k + 1) % 3]);
    std::sort(edges_.begin(), edges_.end());
  }

  bool contains(const Edge& edge) const { return std::binary_search(edges_.begin(), edges_.end(), edge); }
  /// Whether no triangle lies on its other side.
  bool is_open(const Edge& edge) const { return contains(edge) && !contains({edge.second, edge.first}); }
  /// Whether some edge runs the same way in two triangles.
  bool any_twice() const { return std::adjacent_find(edges_.begin(), edges_.end()) != edges_.end(); }
  const std::vector<Edge>& all() const { return edges_; }  ///< in order

 private:
  std::vector<Edge> edges_;
};

}  // namespace loopmend
