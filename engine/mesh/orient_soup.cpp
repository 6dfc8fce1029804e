// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/orient_soup.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <span>
#include <tuple>
#include <utility>

namespace loopmend {

namespace {

// A corner is 3 · face + place; so is a side, by the corner that it leaves.
int vertex(const Triangles& triangles, int side, int k) { return triangles[side / 3][(side % 3 + k) % 3]; }
int corner(int side, int k) { return side / 3 * 3 + (side % 3 + k) % 3; }
bool same_direction(const Triangles& triangles, int s, int t) {
  return vertex(triangles, s, 0) == vertex(triangles, t, 0);
}

/// Calls visit(sides of one edge, ascending) for each edge, ascending by the lower vertex, then by the higher one.
template <class Visit>
void for_each_edge(const Triangles& triangles, std::size_t vertex_count, const Visit& visit) {
  const auto ends = [&](int side) { return std::minmax({vertex(triangles, side, 0), vertex(triangles, side, 1)}); };
  const int side_count = static_cast<int>(3 * triangles.size());
  std::vector<int> first(vertex_count + 2, 0);  // by the lower vertex
  for (int side = 0; side < side_count; ++side) ++first[static_cast<std::size_t>(ends(side).first) + 2];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::pair<int, int>> sides(side_count);  // higher vertex, side
  for (int side = 0; side < side_count; ++side) {
    const auto [low, high] = ends(side);
    sides[first[static_cast<std::size_t>(low) + 1]++] = {high, side};
  }
  std::vector<int> at;
  for (std::size_t v = 0; v < vertex_count; ++v) {
    std::sort(sides.begin() + first[v], sides.begin() + first[v + 1]);
    for (int i = first[v]; i < first[v + 1];) {
      at.clear();
      for (const int high = sides[i].first; i < first[v + 1] && sides[i].first == high; ++i)
        at.push_back(sides[i].second);
      visit(std::span<const int>(at));
    }
  }
}

/// The corners at each vertex, joined into fans across edges.
class Fans {
 public:
  explicit Fans(const Triangles& triangles) : triangles_(triangles), parent_(3 * triangles.size()) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  void join_across(int s, int t) {
    const int turn = same_direction(triangles_, s, t) ? 0 : 1;
    for (int k : {0, 1}) {
      const int a = root(corner(s, k)), b = root(corner(t, (k + turn) % 2));
      parent_[std::max(a, b)] = std::min(a, b);
    }
  }

  /// The faces with a vertex for each fan, numbered by vertex, then by the fan's first corner.
  Triangles separated(std::vector<int>& origin) {
    std::vector<int> number(parent_.size(), -1);  // by root
    std::vector<char> is_used(origin.size(), 0);
    std::vector<std::pair<int, int>> others;  // vertex, root
    for (int c = 0; c < static_cast<int>(parent_.size()); ++c) {
      if (root(c) != c) continue;
      const int v = vertex(triangles_, c, 0);
      if (is_used[v])
        others.emplace_back(v, c);
      else
        number[c] = v;
      is_used[v] = 1;
    }
    std::sort(others.begin(), others.end());
    for (const auto& [v, c] : others) {
      number[c] = static_cast<int>(origin.size());
      origin.push_back(origin[v]);
    }
    Triangles result = triangles_;
    for (std::size_t f = 0; f < result.size(); ++f)
      for (int k = 0; k < 3; ++k) result[f][k] = number[root(static_cast<int>(3 * f) + k)];
    return result;
  }

 private:
  int root(int corner) {
    while (parent_[corner] != corner) corner = parent_[corner] = parent_[parent_[corner]];
    return corner;
  }

  const Triangles& triangles_;
  std::vector<int> parent_;  // lower than the child
};

/// From the edge into the face, square to the edge.
Vec3 wing(const Points& points, const Triangles& triangles, int side) {
  const auto point = [&](int k) { return points[vertex(triangles, side, k)]; };
  const Vec3 along = (point(1) - point(0)).normalized(), out = point(2) - point(0);
  return (out - along.dot(out) * along).normalized();
}

void join_the_flattest(const Points& points, const Triangles& triangles, std::span<const int> at, Fans& fans) {
  std::vector<std::tuple<double, int, int>> pairs;  // cosine between the wings: −1 is flat
  for (std::size_t i = 0; i < at.size(); ++i)
    for (std::size_t j = i + 1; j < at.size(); ++j)
      if (!same_direction(triangles, at[i], at[j]))
        pairs.emplace_back(wing(points, triangles, at[i]).dot(wing(points, triangles, at[j])), at[i], at[j]);
  std::sort(pairs.begin(), pairs.end());
  std::set<int> joined;
  for (const auto& [cosine, s, t] : pairs) {
    if (joined.contains(s) || joined.contains(t)) continue;
    fans.join_across(s, t);
    joined.insert({s, t});
  }
}

/// Walks each component across its edges of two faces, and turns each face that disagrees with the one before.
class Orientation {
 public:
  Orientation(const Triangles& triangles, std::size_t vertex_count)
      : triangles_(triangles),
        twin_(3 * triangles.size(), -1),
        is_reached_(triangles.size(), 0),
        is_reversed_(triangles.size(), 0),
        is_component_turned_(triangles.size(), 0) {
    for_each_edge(triangles, vertex_count, [&](std::span<const int> at) {
      if (at.size() != 2) return;
      twin_[at[0]] = at[1];
      twin_[at[1]] = at[0];
    });
    for (int f = 0; f < static_cast<int>(triangles.size()); ++f)
      if (!is_reached_[f]) walk(f);
  }

  Fans fans() const {
    Fans result(triangles_);
    for (int side = 0; side < static_cast<int>(twin_.size()); ++side)
      if (twin_[side] > side && !disagree(side, twin_[side])) result.join_across(side, twin_[side]);
    return result;
  }

  /// Turns the faces, with corners of other numbers by now. @returns whether each is turned in the end.
  std::vector<char> turn(Triangles& triangles) const {
    std::vector<char> is_turned(triangles.size());
    for (std::size_t f = 0; f < triangles.size(); ++f) {
      if (is_reversed_[f]) std::swap(triangles[f][0], triangles[f][2]);
      if (is_component_turned_[f]) std::swap(triangles[f][1], triangles[f][2]);
      is_turned[f] = is_reversed_[f] != is_component_turned_[f];
    }
    return is_turned;
  }

 private:
  bool disagree(int s, int t) const {
    return same_direction(triangles_, s, t) == (is_reversed_[s / 3] == is_reversed_[t / 3]);
  }

  void walk(int start) {
    std::vector<int> faces, stack{start};
    is_reached_[start] = 1;
    int reversed = 0;
    while (!stack.empty()) {
      const int f = stack.back();
      stack.pop_back();
      faces.push_back(f);
      reversed += is_reversed_[f];
      // In the order of its sides, which decides where a one-sided component is cut.
      for (const int k : is_reversed_[f] ? std::array{1, 0, 2} : std::array{0, 1, 2}) {
        const int across = twin_[3 * f + k];
        if (across < 0 || is_reached_[across / 3]) continue;
        is_reversed_[across / 3] = disagree(3 * f + k, across);
        is_reached_[across / 3] = 1;
        stack.push_back(across / 3);
      }
    }
    if (2 * reversed > static_cast<int>(faces.size()))
      for (int f : faces) is_component_turned_[f] = 1;
  }

  const Triangles& triangles_;
  std::vector<int> twin_;  // side → the other one of its edge; -1 where there are less or more than two
  std::vector<char> is_reached_, is_reversed_, is_component_turned_;
};

}  // namespace

void separate_at_edges(const Points& points, Triangles& triangles, std::vector<int>& origin) {
  Fans fans(triangles);
  for_each_edge(triangles, origin.size(), [&](std::span<const int> at) {
    if (at.size() == 2) fans.join_across(at[0], at[1]);
    if (at.size() > 2) join_the_flattest(points, triangles, at, fans);
  });
  triangles = fans.separated(origin);
}

std::vector<char> orient_soup(Triangles& triangles, std::vector<int>& origin) {
  const Orientation orientation(triangles, origin.size());
  Triangles result = orientation.fans().separated(origin);
  const std::vector<char> is_turned = orientation.turn(result);
  triangles = std::move(result);
  return is_turned;
}

}  // namespace loopmend
