// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/vertex_survey.h"

#include "core/threads.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <numeric>
#include <span>
#include <utility>

namespace loopmend {

namespace {

constexpr int vertices_at_a_time = 4096;

/// The corners at each vertex: 3 · triangle + place, ascending. Triangles with a corner twice are left out.
class CornersAtVertices {
 public:
  CornersAtVertices(const Triangles& triangles, std::size_t vertex_count)
      : first_(vertex_count + 2, 0),
        corners_(std::make_unique_for_overwrite<int[]>(3 * triangles.size())) {
    for (const Triangle& t : triangles) {
      if (!has_three_corners(t)) {
        ++left_out_;
        continue;
      }
      for (int v : t) ++first_[static_cast<std::size_t>(v) + 2];
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    for (std::size_t f = 0; f < triangles.size(); ++f) {
      if (left_out_ > 0 && !has_three_corners(triangles[f])) continue;
      for (int k = 0; k < 3; ++k)
        corners_[first_[static_cast<std::size_t>(triangles[f][k]) + 1]++] = static_cast<int>(3 * f) + k;
    }
  }
  std::span<const int> operator[](int v) const { return {corners_.get() + first_[v], corners_.get() + first_[v + 1]}; }
  std::size_t left_out() const { return left_out_; }

 private:
  std::vector<int> first_;
  std::unique_ptr<int[]> corners_;
  std::size_t left_out_ = 0;
};

/// One triangle seen from one of its corners: the edge opposite runs from `next` to `previous`.
struct LinkEdge {
  int next, previous;
  int corner;
};

void unsorted_link_at(const Triangles& triangles, std::span<const int> corners, std::vector<LinkEdge>& link) {
  link.clear();
  for (int corner : corners) {
    const Triangle& t = triangles[corner / 3];
    link.push_back({t[(corner + 1) % 3], t[(corner + 2) % 3], corner});
  }
}

void sort_link(std::vector<LinkEdge>& link) {
  std::sort(link.begin(), link.end(), [](const LinkEdge& a, const LinkEdge& b) { return a.next < b.next; });
}

void link_at(const Triangles& triangles, std::span<const int> corners, std::vector<LinkEdge>& link) {
  unsorted_link_at(triangles, corners, link);
  sort_link(link);
}

/// Whether the edges are one ring, in whatever order they stand: what nearly all vertices have. Not asked of many edges.
bool is_one_ring(const std::vector<LinkEdge>& link) {
  constexpr std::size_t most = 16;
  if (link.empty() || link.size() > most) return false;
  int at = link.front().previous;
  for (std::size_t steps = 1; steps < link.size(); ++steps) {
    const auto next = std::find_if(link.begin() + 1, link.end(), [&](const LinkEdge& edge) { return edge.next == at; });
    if (next == link.end()) return false;
    at = next->previous;
    if (at == link.front().next) return steps + 1 == link.size();
  }
  return false;
}

/// A number without a pattern for each vertex.
std::uint64_t scattered(int v) {
  std::uint64_t z = static_cast<std::uint64_t>(v) * 0x9E3779B97F4A7C15ull;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
  return z ^ (z >> 31);
}

/// How many triangles the edges to the neighbours have: sorted neighbours, one for each triangle at the edge.
std::vector<int>& neighbors_of(const std::vector<LinkEdge>& link, std::vector<int>& neighbors) {
  neighbors.clear();
  for (const LinkEdge& edge : link) {
    neighbors.push_back(edge.next);
    neighbors.push_back(edge.previous);
  }
  std::sort(neighbors.begin(), neighbors.end());
  return neighbors;
}

/// Follows the fan from a corner to its end or round. @returns how many corners it has
template <class Visit>
std::size_t walk(const std::vector<LinkEdge>& link, std::size_t start, const Visit& visit) {
  std::size_t steps = 0;
  for (std::size_t at = start; steps < link.size();) {
    visit(link[at]);
    ++steps;
    const auto next = std::lower_bound(link.begin(), link.end(), link[at].previous,
                                       [](const LinkEdge& edge, int v) { return edge.next < v; });
    if (next == link.end() || next->next != link[at].previous) break;
    at = static_cast<std::size_t>(next - link.begin());
    if (at == start) break;
  }
  return steps;
}

/// For each corner whether another one leads to it; the first of an open fan is led to by none.
void find_led_to(const std::vector<LinkEdge>& link, std::vector<int>& previous, std::vector<char>& is_led_to) {
  previous.clear();
  for (const LinkEdge& edge : link) previous.push_back(edge.previous);
  std::sort(previous.begin(), previous.end());
  is_led_to.clear();
  for (const LinkEdge& edge : link)
    is_led_to.push_back(std::binary_search(previous.begin(), previous.end(), edge.next));
}

struct Scratch {
  std::vector<LinkEdge> link;
  std::vector<int> neighbors;
  std::vector<char> is_led_to;
};

/// Whether two triangles lie back to back: a closed fan of their own.
bool has_pair(const std::vector<LinkEdge>& link) {
  return std::any_of(link.begin(), link.end(), [&](const LinkEdge& edge) {
    return std::any_of(link.begin(), link.end(), [&](const LinkEdge& other) {
      return other.next == edge.previous && other.previous == edge.next;
    });
  });
}

/// @param ends  is set to the number of edges with one triangle only, where the vertex is not disordered
VertexState state_of(Scratch& scratch, int& ends) {
  const std::vector<LinkEdge>& link = scratch.link;
  std::vector<int>& neighbors = scratch.neighbors;
  if (link.empty()) return VertexState::clean;
  for (std::size_t k = 1; k < link.size(); ++k)
    if (link[k].next == link[k - 1].next) return VertexState::disordered;
  neighbors_of(link, neighbors);
  for (std::size_t k = 0; k < neighbors.size();) {
    std::size_t end = k;
    while (end < neighbors.size() && neighbors[end] == neighbors[k]) ++end;
    if (end - k > 2) return VertexState::disordered;
    // Twice `previous` is an edge along which two triangles run the same way; twice `next` was found above.
    ends += end - k == 1;
    if (end - k == 2) {
      const auto is_next = std::binary_search(link.begin(), link.end(), LinkEdge{neighbors[k], 0, 0},
                                              [](const LinkEdge& a, const LinkEdge& b) { return a.next < b.next; });
      if (!is_next) return VertexState::disordered;
    }
    k = end;
  }
  if (ends > 2) return VertexState::several;
  std::size_t start = 0;
  if (ends == 2) {
    find_led_to(link, neighbors, scratch.is_led_to);
    start = static_cast<std::size_t>(std::find(scratch.is_led_to.begin(), scratch.is_led_to.end(), 0) -
                                     scratch.is_led_to.begin());
    if (start == link.size()) return VertexState::several;
  }
  return walk(link, start, [](const LinkEdge&) {}) == link.size() ? VertexState::clean : VertexState::several;
}

}  // namespace

bool VertexSurvey::any(VertexState which) const { return std::find(state.begin(), state.end(), which) != state.end(); }

VertexSurvey survey_vertices(const Triangles& triangles, std::size_t vertex_count) {
  const CornersAtVertices corners(triangles, vertex_count);
  VertexSurvey survey;
  survey.collapsed_triangles = corners.left_out();
  survey.state.assign(vertex_count, VertexState::clean);
  survey.at_boundary.assign(vertex_count, 0);
  std::atomic<bool> may_repeat{false};
  parallel_for(
      0, static_cast<int>(vertex_count), vertices_at_a_time, [] { return Scratch{}; },
      [&](int v, Scratch& scratch) {
        unsorted_link_at(triangles, corners[v], scratch.link);
        if (scratch.link.size() > 2 && is_one_ring(scratch.link)) return;
        sort_link(scratch.link);
        int ends = 0;
        survey.state[v] = state_of(scratch, ends);
        survey.at_boundary[v] = ends > 0;
        const bool ask = scratch.link.size() == 2 || survey.state[v] == VertexState::several;
        if (survey.state[v] == VertexState::disordered || (ask && has_pair(scratch.link)))
          may_repeat.store(true, std::memory_order_relaxed);
      });
  survey.may_repeat = may_repeat;
  Scratch scratch;
  for (std::size_t v = 0; v < vertex_count; ++v) {
    if (survey.state[v] != VertexState::disordered) continue;
    link_at(triangles, corners[static_cast<int>(v)], scratch.link);
    const std::vector<int>& neighbors = neighbors_of(scratch.link, scratch.neighbors);
    for (std::size_t k = 0; k < neighbors.size();) {
      std::size_t end = k;
      while (end < neighbors.size() && neighbors[end] == neighbors[k]) ++end;
      survey.non_manifold_edges += end - k > 2 && neighbors[k] > static_cast<int>(v);
      k = end;
    }
  }
  return survey;
}

std::vector<char> repeated_triangles(const Triangles& triangles, std::size_t vertex_count) {
  // Each triangle at its lowest vertex.
  const auto lowest = [](const Triangle& t) { return std::min({t[0], t[1], t[2]}); };
  std::vector<int> first(vertex_count + 2, 0), at_lowest(triangles.size());
  for (const Triangle& t : triangles) ++first[static_cast<std::size_t>(lowest(t)) + 2];
  std::partial_sum(first.begin(), first.end(), first.begin());
  for (std::size_t f = 0; f < triangles.size(); ++f)
    at_lowest[first[static_cast<std::size_t>(lowest(triangles[f])) + 1]++] = static_cast<int>(f);
  std::vector<char> repeated(triangles.size(), 0);
  parallel_for(
      0, static_cast<int>(vertex_count), vertices_at_a_time, [] { return std::vector<std::array<int, 3>>(); },
      [&](int v, std::vector<std::array<int, 3>>& others) {
        others.clear();
        for (int k = first[v]; k < first[v + 1]; ++k) {
          Triangle t = triangles[at_lowest[k]];
          std::sort(t.begin(), t.end());
          if (t[0] < t[1] && t[1] < t[2]) others.push_back({t[1], t[2], at_lowest[k]});
        }
        std::sort(others.begin(), others.end());
        for (std::size_t k = 1; k < others.size(); ++k)
          if (others[k][0] == others[k - 1][0] && others[k][1] == others[k - 1][1]) repeated[others[k][2]] = 1;
      });
  return repeated;
}

std::vector<int> open_vertices(const VertexSurvey& survey, const Triangles& triangles) {
  std::map<int, std::uint64_t> balance;  // of the disordered ones: what is entered less what is left, without a pattern
  if (survey.any(VertexState::disordered))
    for (const Triangle& t : triangles)
      for (int k = 0; k < 3; ++k)
        if (survey.state[t[k]] == VertexState::disordered && has_three_corners(t))
          balance[t[k]] += scattered(t[(k + 1) % 3]) - scattered(t[(k + 2) % 3]);
  std::vector<int> open;
  for (std::size_t v = 0; v < survey.state.size(); ++v) {
    const auto sum = balance.find(static_cast<int>(v));
    if (sum == balance.end() ? survey.at_boundary[v] != 0 : sum->second != 0) open.push_back(static_cast<int>(v));
  }
  return open;
}

void separate_fans(const VertexSurvey& survey, Triangles& triangles, std::vector<int>& origin) {
  std::map<int, std::vector<int>> corners_at;
  for (std::size_t f = 0; f < triangles.size(); ++f)
    for (int k = 0; k < 3; ++k)
      if (const auto v = static_cast<std::size_t>(triangles[f][k]);
          v < survey.state.size() && survey.state[v] == VertexState::several)
        corners_at[triangles[f][k]].push_back(static_cast<int>(3 * f) + k);
  std::vector<std::pair<int, int>> renumbered;  // corner, new vertex
  Scratch scratch;
  for (const auto& [v, corners] : corners_at) {
    const std::vector<LinkEdge>& link = scratch.link;
    link_at(triangles, corners, scratch.link);
    find_led_to(link, scratch.neighbors, scratch.is_led_to);
    std::vector<char> used(link.size(), 0);
    std::vector<std::vector<int>> fans;
    for (const bool closed : {false, true})
      for (std::size_t start = 0; start < link.size(); ++start) {
        if (used[start] || (!closed && scratch.is_led_to[start])) continue;
        std::vector<int>& fan = fans.emplace_back();
        walk(link, start, [&](const LinkEdge& edge) {
          used[&edge - link.data()] = 1;
          fan.push_back(edge.corner);
        });
      }
    std::sort(fans.begin(), fans.end(), [](const auto& a, const auto& b) {
      return *std::min_element(a.begin(), a.end()) < *std::min_element(b.begin(), b.end());
    });
    for (std::size_t k = 1; k < fans.size(); ++k) {
      for (int corner : fans[k]) renumbered.emplace_back(corner, static_cast<int>(origin.size()));
      origin.push_back(origin[v]);
    }
  }
  for (const auto& [corner, vertex] : renumbered) triangles[corner / 3][corner % 3] = vertex;
}

}  // namespace loopmend
