// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/join_touching_fans.h"

#include "mesh/vertex_fans.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>

namespace loopmend {

namespace {

/// Those of the vertices that share a place, and a colour where there are colours, group by group, ascending.
std::vector<std::vector<int>> groups_in_one_place(const TriangleSoup& soup, std::vector<int> vertices) {
  const auto key = [&](int v) { return std::make_tuple(soup.points[v].x(), soup.points[v].y(), soup.points[v].z()); };
  const auto same = [&](int a, int b) {
    return soup.points[a] == soup.points[b] && (soup.colors.empty() || soup.colors[a] == soup.colors[b]);
  };
  std::stable_sort(vertices.begin(), vertices.end(), [&](int a, int b) { return key(a) < key(b); });
  std::vector<std::vector<int>> groups;
  for (std::size_t i = 0; i < vertices.size();) {
    std::size_t j = i + 1;
    while (j < vertices.size() && same(vertices[i], vertices[j])) ++j;
    if (j > i + 1)
      groups.emplace_back(vertices.begin() + static_cast<long>(i), vertices.begin() + static_cast<long>(j));
    i = j;
  }
  return groups;
}

using NextAround = std::map<int, int>;  ///< of one vertex: from each neighbor to the next, face by face

/// Open fans by their neighbors in order. Nothing where a fan is closed.
std::optional<std::vector<std::vector<int>>> fans_of(NextAround next) {
  std::vector<std::vector<int>> fans;
  std::map<int, int> entered;
  for (const auto& [from, to] : next) ++entered[to];
  std::vector<int> starts;
  for (const auto& [from, to] : next)
    if (!entered.contains(from)) starts.push_back(from);
  for (int start : starts) {
    std::vector<int>& fan = fans.emplace_back(1, start);
    for (auto at = next.find(start); at != next.end(); at = next.find(fan.back())) {
      fan.push_back(at->second);
      next.erase(at);
    }
  }
  if (!next.empty()) return std::nullopt;
  return fans;
}

/// The fans of a group of vertices in one place; nothing where they are no plain fans, share a neighbor's place, or overlap.
bool lie_side_by_side(const Points& points, const std::vector<int>& group, const std::map<int, NextAround>& around) {
  std::vector<FanLink> links;
  Points neighbors;
  for (int v : group) {
    const auto fans = fans_of(around.at(v));
    if (!fans) return false;
    for (const std::vector<int>& fan : *fans) {
      FanLink& link = links.emplace_back();
      for (int w : fan) link.push_back(points[w]);
      neighbors.insert(neighbors.end(), link.begin(), link.end());
    }
  }
  for (std::size_t i = 0; i < neighbors.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (neighbors[i] == neighbors[j]) return false;
  return links.size() > 1 && arrange_fans(points[group.front()], links).has_value();
}

}  // namespace

std::vector<int> join_touching_fans(TriangleSoup& soup, const VertexSurvey& survey) {
  const std::vector<std::vector<int>> groups = groups_in_one_place(soup, open_vertices(survey, soup.triangles));
  if (groups.empty()) return {};
  std::map<int, NextAround> around;
  for (const std::vector<int>& group : groups)
    for (int v : group) around[v];
  std::vector<char> wanted(soup.points.size(), 0), disordered(soup.points.size(), 0);
  for (const auto& [v, next] : around) wanted[v] = 1;
  for (const Triangle& t : soup.triangles)
    for (int k = 0; k < 3; ++k)
      if (wanted[t[k]] && has_three_corners(t) && !around[t[k]].emplace(t[(k + 1) % 3], t[(k + 2) % 3]).second)
        disordered[t[k]] = 1;
  std::vector<int> named(soup.points.size());
  std::iota(named.begin(), named.end(), 0);
  bool any = false;
  for (const std::vector<int>& group : groups) {
    if (std::any_of(group.begin(), group.end(), [&](int v) { return disordered[v]; })) continue;
    if (!lie_side_by_side(soup.points, group, around)) continue;
    for (int v : group) named[v] = group.front();
    any = true;
  }
  if (!any) return {};
  for (Triangle& t : soup.triangles)
    for (int& v : t) v = named[v];
  return named;
}

}  // namespace loopmend
