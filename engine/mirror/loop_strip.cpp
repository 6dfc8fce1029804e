// SPDX-License-Identifier: GPL-3.0-or-later
#include "mirror/loop_strip.h"

#include "filling/bridge_topology.h"
#include "filling/triangulate_loop.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

namespace loopmend {

namespace {

constexpr int sector_edges = 10;  ///< of the loop, for one polygon

struct CrossEdge {
  int i = 0;  ///< place in the loop
  int j = 0;  ///< place in the border
  double length = 0;
};

/// As they follow one another along the loop, which the border runs against.
std::vector<CrossEdge> cross_edges(const Points& loop, const Points& border) {
  const int n = static_cast<int>(loop.size());
  std::vector<CrossEdge> edges;
  for (const Triangle& t : bridge_by_strip(loop, border))
    edges.push_back({t[0], t[2] - n, (loop[t[0]] - border[t[2] - n]).norm()});
  return edges;
}

/// The shortest of each sector of the loop; two at least.
std::vector<CrossEdge> sector_bounds(const std::vector<CrossEdge>& edges, int loop_edges) {
  const int sectors = std::max(2, loop_edges / sector_edges);
  std::vector<CrossEdge> bounds(sectors);
  std::vector<char> known(sectors, 0);
  for (const CrossEdge& edge : edges) {
    const int s = static_cast<int>(static_cast<long>(edge.i) * sectors / loop_edges);
    if (known[s] && bounds[s].length <= edge.length) continue;
    bounds[s] = edge;
    known[s] = 1;
  }
  return bounds;
}

class StripMaker {
 public:
  StripMaker(const Patch& patch, const InnerSheet& inner)
      : loop_(patch.loops[0]),
        border_(inner.border),
        points_(patch.positions) {
    const int shift = static_cast<int>(points_.size());
    points_.insert(points_.end(), inner.points.begin(), inner.points.end());
    for (int& v : border_) v += shift;
    const std::unordered_set<int> ends(border_.begin(), border_.end());
    const auto keep = [&](const Triangle& t, const auto& is_end) {
      if (std::any_of(t.begin(), t.end(), is_end)) around_.push_back(t);
    };
    for (std::size_t f = patch.patch_triangles; f < patch.triangles.size(); ++f)
      keep(patch.triangles[f], [&](int v) { return patch.ring[v] == 1; });
    for (const auto& [a, b, c] : inner.triangles)
      keep({a + shift, b + shift, c + shift}, [&](int v) { return ends.contains(v); });
    for (std::size_t k = 0; k < loop_.size(); ++k) place_[loop_[k]] = static_cast<int>(k);
    for (std::size_t k = 0; k < border_.size(); ++k) place_[border_[k]] = static_cast<int>(loop_.size() + k);
  }

  Triangles make() const {
    const std::vector<CrossEdge> bounds =
        sector_bounds(cross_edges(places(loop_), places(border_)), static_cast<int>(loop_.size()));
    Triangles strip;
    for (std::size_t s = 0; s < bounds.size(); ++s) {
      const Triangles own = sector(bounds[s], bounds[(s + 1) % bounds.size()]);
      if (own.empty()) return {};
      strip.insert(strip.end(), own.begin(), own.end());
    }
    return strip;
  }

 private:
  Points places(const std::vector<int>& vertices) const {
    Points result;
    for (int v : vertices) result.push_back(points_[v]);
    return result;
  }

  int on_loop(int i) const { return loop_[(i + loop_.size()) % loop_.size()]; }

  /// From one cross edge along the loop to another, and back along the border.
  Triangles sector(const CrossEdge& from, const CrossEdge& to) const {
    const int n = static_cast<int>(loop_.size()), m = static_cast<int>(border_.size());
    std::vector<int> polygon;
    for (int i = from.i;; i = (i + 1) % n) {
      polygon.push_back(loop_[i]);
      if (i == to.i) break;
    }
    for (int j = to.j;; j = (j + 1) % m) {
      polygon.push_back(border_[j]);
      if (j == from.j) break;
    }
    if (polygon.size() < 3) return {};
    Triangles around = around_;  // and what the strip has beyond the cross edges, roughly
    around.push_back({loop_[from.i], border_[from.j], on_loop(from.i - 1)});
    around.push_back({border_[to.j], loop_[to.i], on_loop(to.i + 1)});
    const Triangles own =
        triangulate_loop(points_, around, polygon, present_chords(around_, polygon), TriangulationMethod::cubic);
    Triangles result;
    for (const Triangle& t : own)
      result.push_back({place_.at(polygon[t[0]]), place_.at(polygon[t[1]]), place_.at(polygon[t[2]])});
    return result;
  }

  std::vector<int> loop_, border_;
  Points points_;
  Triangles around_;
  std::unordered_map<int, int> place_;
};

}  // namespace

Triangles strip_to_loop(const Patch& patch, const InnerSheet& inner) { return StripMaker(patch, inner).make(); }

}  // namespace loopmend
